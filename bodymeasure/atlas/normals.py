"""The normal field S_u x S_v of patches as a polynomial."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier import bernstein, derivatives, project


def normal_coefficients(control_points: Array) -> Array:
    """Bernstein coefficients of the normal field S_u x S_v.

    Parameters
    ----------
    control_points : ndarray, shape (patches, m + 1, m + 1, 3) or (patches, m + 1, m + 1, 4)

    Returns
    -------
    ndarray, shape (patches, k, k, 3)
        In squared units of length. Their convex hull holds every value of the field, so a
        direction with which all of them make an acute angle proves that the patch neither folds
        nor degenerates.

    Notes
    -----
    S_u has degree (m - 1, m) and S_v degree (m, m - 1), so that their cross product has degree
    2 m - 1. Of a rational patch ``S = A / w``, it is the field times w^3 that is a polynomial,
    ``w A_u x A_v + w_v A x A_u - w_u A x A_v`` of degree 3 m - 1. By interpolation at Chebyshev
    points, which determine it.
    """
    is_rational = control_points.shape[-1] == 4
    m = control_points.shape[1] - 1
    degree = 3 * m - 1 if is_rational else 2 * m - 1
    nodes = 0.5 - 0.5 * np.cos(np.pi * (np.arange(degree + 1) + 0.5) / (degree + 1))
    values = bernstein(degree, nodes)[:, 0]
    to_coefficients = np.asarray(np.linalg.inv(values), dtype=np.float64)
    basis = bernstein(m, nodes, order=1)
    # Far from the origin, differences of coordinates are all that is exact.
    local = _moved_to_origin(control_points)
    along_u = _apply(basis[:, 1], basis[:, 0], local)
    along_v = _apply(basis[:, 0], basis[:, 1], local)
    normals = np.cross(along_u[..., :3], along_v[..., :3])
    if is_rational:
        point = _apply(basis[:, 0], basis[:, 0], local)
        normals = (
            point[..., 3:] * normals
            + along_v[..., 3:] * np.cross(point[..., :3], along_u[..., :3])
            - along_u[..., 3:] * np.cross(point[..., :3], along_v[..., :3])
        )
    return _apply(to_coefficients, to_coefficients, normals)


def _moved_to_origin(control_points: Array) -> Array:
    """Patches (..., m + 1, n + 1, 3 or 4) moved so that their first corner is the origin."""
    corner = project(control_points[..., :1, :1, :])
    if control_points.shape[-1] == 3:
        return control_points - corner
    weight = control_points[..., 3:]
    return np.concatenate([control_points[..., :3] - weight * corner, weight], axis=-1)


def _apply(rows_u: Array, rows_v: Array, nets: Array) -> Array:
    """Linear maps along both axes of nets (patches, m, n, c)."""
    count, _, columns, coordinates = nets.shape
    first = rows_u @ nets.reshape(count, -1, columns * coordinates)
    return np.asarray(rows_v @ first.reshape(count, -1, columns, coordinates))


def normal_vectors(control_points: Array, parameters: Array) -> Array:
    """Normals S_u x S_v, not normalised.

    Parameters
    ----------
    control_points : ndarray, shape (*batch, m + 1, n + 1, 3) or (*batch, m + 1, n + 1, 4)
    parameters : ndarray, shape (*batch, ..., 2)

    Returns
    -------
    ndarray, shape (*batch, ..., 3)
    """
    tangents = derivatives(_moved_to_origin(control_points), parameters, order=1)
    return np.cross(tangents[..., 1, 0, :], tangents[..., 0, 1, :])


def patch_sizes(control_points: Array) -> Array:
    """Diagonal of the bounding box of each patch's points (..., 3), shape (patches,)."""
    nets = control_points.reshape(len(control_points), -1, 3)
    return np.asarray(np.linalg.norm(np.ptp(nets, axis=1), axis=-1))
