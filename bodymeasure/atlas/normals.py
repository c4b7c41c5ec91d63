"""The normal field S_u x S_v of bicubic patches as a polynomial."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bodymeasure.bezier import bernstein, derivatives

# S_u has degree (2, 3) and S_v degree (3, 2), so that their cross product has degree (5, 5).
NORMAL_DEGREE = 5


def normal_coefficients(control_points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bernstein coefficients of the normal field S_u x S_v.

    Parameters
    ----------
    control_points : ndarray, shape (patches, 4, 4, 3)

    Returns
    -------
    ndarray, shape (patches, 6, 6, 3)
        In squared units of length. Their convex hull holds every value of the field, so a
        direction with which all of them make an acute angle proves that the patch neither folds
        nor degenerates.

    Notes
    -----
    By interpolation at 6 x 6 Chebyshev points, which determine the field.
    """
    nodes = 0.5 - 0.5 * np.cos(np.pi * (np.arange(NORMAL_DEGREE + 1) + 0.5) / (NORMAL_DEGREE + 1))
    values = bernstein(NORMAL_DEGREE, nodes)[:, 0]
    to_coefficients = np.asarray(np.linalg.inv(values), dtype=np.float64)
    basis = bernstein(3, nodes, order=1)
    # Far from the origin, differences of coordinates are all that is exact.
    local = control_points - control_points[:, :1, :1]
    along_u = _apply(basis[:, 1], basis[:, 0], local)
    along_v = _apply(basis[:, 0], basis[:, 1], local)
    return _apply(to_coefficients, to_coefficients, np.cross(along_u, along_v))


def _apply(
    rows_u: NDArray[np.float64], rows_v: NDArray[np.float64], nets: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Linear maps along both axes of nets (patches, m, n, 3)."""
    count, _, columns, _ = nets.shape
    first = rows_u @ nets.reshape(count, -1, columns * 3)
    return np.asarray(rows_v @ first.reshape(count, -1, columns, 3))


def normal_vectors(
    control_points: NDArray[np.float64], parameters: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Normals S_u x S_v, not normalised.

    Parameters
    ----------
    control_points : ndarray, shape (*batch, 4, 4, 3)
    parameters : ndarray, shape (*batch, ..., 2)

    Returns
    -------
    ndarray, shape (*batch, ..., 3)
    """
    tangents = derivatives(control_points, parameters, order=1)
    return np.cross(tangents[..., 1, 0, :], tangents[..., 0, 1, :])


def patch_sizes(control_points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Diagonal of each patch's bounding box, shape (patches,)."""
    nets = control_points.reshape(len(control_points), -1, 3)
    return np.asarray(np.linalg.norm(np.ptp(nets, axis=1), axis=-1))
