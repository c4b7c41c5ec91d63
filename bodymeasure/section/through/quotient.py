"""Distances from planes through poles, the sides of patches that are collapsed to a point.

Along a collapsed side, w = 0 say, the distance f from a plane through the pole is zero, so that the
side itself seems to belong to the section. The rest of it is where f / w is zero, which is a
polynomial, too. That one crosses the side in the directions in which the section leaves the pole.
"""

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.bezier import elevate


def without_poles(distance: Array, sides: Bools) -> Array:
    """Return distances from a plane divided by w about the poles that lie in it.

    Parameters
    ----------
    distance : ndarray, shape (patches, degree + 1, degree + 1)
        In Bernstein form.
    sides : ndarray of bool, shape (patches, 4)
        The collapsed sides that lie in the plane.
    """
    if not sides.any():
        return distance
    result, degree = distance.copy(), distance.shape[1] - 1
    rows = np.flatnonzero(sides.any(axis=1))
    for side in range(4):
        for row in rows[sides[rows, side]].tolist():
            net = result[row] if side < 2 else result[row].T
            net = net if side % 2 == 0 else net[::-1]
            factors = degree / np.arange(1.0, degree + 1.0)
            lower = (net[1:] * factors[:, None])[..., None]
            net = elevate(lower, degree, degree)[..., 0]
            net = net if side % 2 == 0 else net[::-1]
            result[row] = net if side < 2 else net.T
    return result
