"""The shortest path that is known while others are solved."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.elements.path import DEGREE, ElementPath
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface

# A path that is so near to a known minimum everywhere, and as long but for so much, in parts of its
# length, leads there. Several polygons often lead to one path, and each takes as long as the first.
NEAR, ALIKE = 3e-3, 1e-4


class Rival(NamedTuple):
    """The shortest path that is known between the same ends.

    Parameters
    ----------
    length : float
        What a path must be below; infinite if none is known.
    positions : ndarray, shape (m + 1, 3)
        At equal distances along it; NaN if it is no minimum, or there is none.
    """

    length: float
    positions: Array

    def is_reached_by(self, surface: Surface, path: ElementPath, lengths: Array) -> bool:
        """Whether a path, with the lengths of its elements, is this one but for further cuts."""
        length = float(lengths.sum())
        if not abs(length - self.length) <= ALIKE * length:
            return False
        begins = np.cumsum(lengths) - lengths
        nodes = polynomial_space(DEGREE).nodes
        times = (begins[:, None] + lengths[:, None] * nodes).ravel() / length
        places = path.values.transpose(0, 2, 1).reshape(1, -1, 2)
        here = surface.jet(places, 0)[0, :, 0]
        even = np.linspace(0.0, 1.0, len(self.positions))
        there = np.stack([np.interp(times, even, each) for each in self.positions.T])
        return bool(np.abs(here - there).max() <= NEAR * length)


NO_RIVAL = Rival(np.inf, np.full((2, 3), np.nan))
