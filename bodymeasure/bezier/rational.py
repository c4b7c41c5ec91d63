"""Rational Bezier patches: control points in homogeneous coordinates."""

from math import comb

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.arguments import numbers
from bodymeasure.errors import InputError


def homogeneous(control_points: ArrayLike, weights: ArrayLike) -> Array:
    """Return the control points of rational patches.

    Parameters
    ----------
    control_points : array_like, shape (..., m + 1, n + 1, 3)
    weights : array_like, shape (..., m + 1, n + 1)
        They broadcast with the control points.

    Returns
    -------
    ndarray, shape (..., m + 1, n + 1, 4)
        ``(w x, w y, w z, w)``: wherever control points are taken, four coordinates mean a rational
        patch.

    Examples
    --------
    >>> import numpy as np
    >>> import bodymeasure as bm
    >>> patch = bm.load_sample("paraboloid").control_points[0]
    >>> rational = bm.homogeneous(patch, np.full((4, 4), 2.0))
    >>> rational.shape, round(bm.solve_geodesic(rational, (0, 0), (1, 1)).length, 6)
    ((4, 4, 4), 2.562007)
    """
    points = numbers(control_points, "control_points", "numbers (..., 3)")
    given = numbers(weights, "weights", "numbers (...)")
    if points.ndim == 0 or points.shape[-1] != 3:
        raise InputError(f"control_points have shape {points.shape}; expected (..., 3)")
    try:
        weight = np.broadcast_to(given, points.shape[:-1])[..., None]
    except ValueError:
        raise InputError(
            f"weights have shape {given.shape}, which does not broadcast to that of the control "
            f"points, {points.shape[:-1]}"
        ) from None
    return np.concatenate([points * weight, weight], axis=-1)


def project(control_points: ArrayLike) -> Array:
    """Return control points in space: four coordinates are divided by their weights.

    Parameters
    ----------
    control_points : array_like, shape (..., 3) or (..., 4)

    Returns
    -------
    ndarray, shape (..., 3)
    """
    points = np.asarray(control_points, dtype=np.float64)
    return points if points.shape[-1] == 3 else points[..., :3] / points[..., 3:]


def scaled(control_points: Array, factor: float) -> Array:
    """Scale patches (..., 3 or 4) about the origin; weights stay as they are."""
    result = control_points * factor
    result[..., 3:] = control_points[..., 3:]
    return result


def divide(jet: Array) -> Array:
    """Return the derivatives of a rational patch from those of its homogeneous coordinates.

    Parameters
    ----------
    jet : ndarray, shape (..., k + 1, k + 1, 4)
        ``[..., i, j, :]`` is the derivative taken i times by u and j times by v.

    Returns
    -------
    ndarray, shape (..., k + 1, k + 1, 3)

    Notes
    -----
    Leibniz's rule for ``A = w S``, solved for the highest derivative of S: L. Piegl and W. Tiller,
    The NURBS Book, equation (4.20).
    """
    numerator, weight = jet[..., :3], jet[..., 3]
    result = np.empty(numerator.shape)
    for i in range(jet.shape[-3]):
        for j in range(jet.shape[-2]):
            value = numerator[..., i, j, :].copy()
            for k in range(i + 1):
                for m in range(j + 1):
                    if k or m:
                        factor = comb(i, k) * comb(j, m) * weight[..., k, m]
                        value -= factor[..., None] * result[..., i - k, j - m, :]
            result[..., i, j, :] = value / weight[..., :1, 0]
    return result
