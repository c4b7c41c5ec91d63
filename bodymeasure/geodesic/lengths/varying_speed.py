"""The speed of paths whose parameter is not the part of the length that has been covered."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.lengths.equations import dot
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

# The number of paths whose speeds are calculated at once: it bounds the memory.
CHUNK = 4096


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
        place, slopes, _ = space.at_quadrature
        speed = np.empty((len(values), len(place)))
        for first in range(0, len(values), CHUNK):
            some = values[first : first + CHUNK]
            jet = self.surface.take(self.rows[first : first + CHUNK]).jet(
                (some @ place.T).transpose(0, 2, 1), 1
            )
            du, dv = ((some - some[:, :, :1]) @ slopes.T).transpose(1, 0, 2)
            tangent = jet[1] * du + jet[2] * dv
            speed[first : first + CHUNK] = np.sqrt(dot(tangent, tangent))
        return speed
