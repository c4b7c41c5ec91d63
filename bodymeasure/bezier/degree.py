"""Degree elevation."""

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array


def elevate(control_points: ArrayLike, degree_u: int, degree_v: int) -> Array:
    """Return the same patches written with higher degrees.

    Parameters
    ----------
    control_points : array_like, shape (*batch, m + 1, n + 1, 3)
    degree_u, degree_v : int
        The degrees to reach, at least m and n.

    Returns
    -------
    ndarray, shape (*batch, degree_u + 1, degree_v + 1, 3)

    Raises
    ------
    ValueError
        If a degree is lower than that of the patches.

    Notes
    -----
    Farin, 5th ed., equation (6.1), once per degree.
    """
    net = np.asarray(control_points, dtype=np.float64)
    for axis, degree in ((-3, degree_u), (-2, degree_v)):
        if degree < net.shape[axis] - 1:
            raise ValueError(
                f"a patch of degree {net.shape[axis] - 1} cannot be written with degree {degree}; "
                "ask for at least its own degree"
            )
        while net.shape[axis] - 1 < degree:
            net = np.moveaxis(_elevate_once(np.moveaxis(net, axis, 0)), 0, axis)
    return net


def _elevate_once(points: Array) -> Array:
    """Raise the degree by one along axis 0."""
    count = len(points)
    weight = (np.arange(1, count) / count).reshape(-1, *(1,) * (points.ndim - 1))
    inner = weight * points[:-1] + (1.0 - weight) * points[1:]
    return np.concatenate([points[:1], inner, points[-1:]])
