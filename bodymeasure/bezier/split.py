"""Splitting a patch and restricting it to a sub-rectangle, exactly."""

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array


def _blossom_rows(degree: int, start: Any, end: Any) -> Array:
    """Return the matrices that take control points on [0, 1] to those on [start, end].

    Row i holds the blossom's weights at (start, ..., start, end, ..., end) with i ends:
    Farin, 5th ed., section 4.7. Shape (*batch, degree + 1, degree + 1).
    """
    start, end = np.broadcast_arrays(
        np.asarray(start, dtype=np.float64), np.asarray(end, dtype=np.float64)
    )
    rows = []
    for ends in range(degree + 1):
        weights = np.ones((*start.shape, 1))
        for step in range(degree):
            t = (end if step < ends else start)[..., None]
            raised = np.zeros((*start.shape, step + 2))
            raised[..., :-1] += (1.0 - t) * weights
            raised[..., 1:] += t * weights
            weights = raised
        rows.append(weights)
    return np.stack(rows, axis=-2)


def restrict(control_points: ArrayLike, lower: ArrayLike, upper: ArrayLike) -> Array:
    """Return the control points of each patch restricted to a parameter rectangle.

    Parameters
    ----------
    control_points : array_like, shape (*batch, m + 1, n + 1, 3)
    lower, upper : array_like, shape (*batch, 2)
        Two opposite corners (u, v) of the rectangle; upper may lie below lower, which turns the
        patch round. The restricted patch runs from lower at (0, 0) to upper at (1, 1).

    Returns
    -------
    ndarray, shape (*batch, m + 1, n + 1, 3)
    """
    net = np.asarray(control_points, dtype=np.float64)
    lower = np.asarray(lower, dtype=np.float64)
    upper = np.asarray(upper, dtype=np.float64)
    rows_u = _blossom_rows(net.shape[-3] - 1, lower[..., 0], upper[..., 0])
    rows_v = _blossom_rows(net.shape[-2] - 1, lower[..., 1], upper[..., 1])
    along_u = np.einsum("...ai,...ijc->...ajc", rows_u, net)
    return np.asarray(rows_v[..., None, :, :] @ along_u)


def split(control_points: ArrayLike, u: float = 0.5, v: float = 0.5) -> Array:
    """Cut each patch into four at (u, v).

    Parameters
    ----------
    control_points : array_like, shape (*batch, m + 1, n + 1, 3)
    u, v : float
        Where to cut.

    Returns
    -------
    ndarray, shape (*batch, 2, 2, m + 1, n + 1, 3)
        ``[..., i, j]`` is the lower (0) or upper (1) part in u and in v. Neighboring parts share
        their edge's control points to the last bit.
    """
    net = np.asarray(control_points, dtype=np.float64)
    parts = np.empty((*net.shape[:-3], 2, 2, *net.shape[-3:]))
    for i, rows_u in enumerate(halves(net.shape[-3] - 1, u)):
        along_u = np.einsum("ai,...ijc->...ajc", rows_u, net)
        for j, rows_v in enumerate(halves(net.shape[-2] - 1, v)):
            parts[..., i, j, :, :, :] = np.einsum("bj,...ajc->...abc", rows_v, along_u)
    return parts


@lru_cache(maxsize=32)
def halves(degree: int, t: float) -> tuple[Array, Array]:
    """Return the matrices from control points of a curve to those of its parts at t."""
    return _blossom_rows(degree, 0.0, t), _blossom_rows(degree, t, 1.0)
