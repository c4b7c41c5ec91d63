"""The speed of paths whose parameter is not the part of the length that has been covered."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.lengths.equations import dot
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

# The number of paths whose speeds are calculated at once: it bounds the memory.
CHUNK = 4096


def speeds(surface: Surface, space: TrialSpace, values: Array) -> Array:
    """Return the speeds of paths at the points of the quadrature, shape (paths, points).

    Parameters
    ----------
    surface : Surface
        That of each path.
    space : TrialSpace
    values : ndarray, shape (paths, 2, n + 1)
        The values of u and v at the space's nodes.
    """
    place, slopes, _ = space.at_quadrature
    # Differences from the start, so that rounding errors of derivatives do not grow with (u, v).
    du, dv = ((values - values[:, :, :1]) @ slopes.T).transpose(1, 0, 2)
    _, s_u, s_v = surface.jet((values @ place.T).transpose(0, 2, 1), 1)
    tangent = s_u * du + s_v * dv
    return np.sqrt(dot(tangent, tangent))


class VaryingSpeed(NamedTuple):
    """What the speed of paths is calculated from when it is asked for.

    Speeds themselves would take more memory than the paths, and few are ever asked for.

    Parameters
    ----------
    surface : Surface
    rows : ndarray of int, shape (paths,)
        The place of each path's surface among these.
    """

    surface: Surface
    rows: Ints

    def take(self, paths: Ints) -> "VaryingSpeed":
        """Return what belongs to some of the paths, on the same surfaces."""
        return VaryingSpeed(self.surface, self.rows[paths])

    def alone(self) -> "VaryingSpeed":
        """Return the same without the surfaces that none of the paths is on."""
        return VaryingSpeed(self.surface.take(self.rows), np.arange(len(self.rows)))

    def at_quadrature(self, space: TrialSpace, values: Array) -> Array:
        """Return the speeds at the points of the quadrature, shape (paths, points).

        Parameters
        ----------
        space : TrialSpace
        values : ndarray, shape (paths, 2, n + 1)
            The values of u and v at the space's nodes.
        """
        speed = np.empty((len(values), len(space.quadrature.points)))
        for first in range(0, len(values), CHUNK):
            some = slice(first, first + CHUNK)
            speed[some] = speeds(self.surface.take(self.rows[some]), space, values[some])
        return speed
