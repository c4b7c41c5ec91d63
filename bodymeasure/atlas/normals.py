"""Normals of patches: as vectors, as unit vectors with their bends, and as a polynomial."""

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.bezier import bernstein, derivatives, project
from bodymeasure.bezier.power_form import jets
from bodymeasure.native import MOST_DEGREE, is_compiled, normals_in_powers

# Sine of the angle between tangents that span no plane; the normal is taken a little aside, at this
# part of the way to the middle of the patch.
DEGENERATE = 1e-9
ASIDE = 1e-4
# The ratio of the lengths of both tangents, below which a point is beside a pole. There, second
# derivatives over the square of the shorter tangent are rounding; those a little aside are taken.
NEAR_POLE = 1e-5
# The ratio below which the shorter tangent itself is rounding, and the part of the way to the
# middle at which the normal is taken then.
AT_POLE = 1e-7


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
    """Return the normals S_u x S_v, which are not normalized.

    Parameters
    ----------
    control_points : ndarray, shape (*batch, m + 1, n + 1, 3) or (*batch, m + 1, n + 1, 4)
    parameters : ndarray, shape (*batch, ..., 2)

    Returns
    -------
    ndarray, shape (*batch, ..., 3)
    """
    return np.cross(*_tangents(control_points, parameters))


def unit_normals(control_points: Array, parameters: Array) -> Array:
    """Return unit vectors along S_u x S_v.

    Where the tangents span no plane, as at a pole, the normal a little nearer to the middle of the
    patch is returned, and 0 where that does not exist either.

    Parameters
    ----------
    control_points : ndarray, shape (*batch, m + 1, n + 1, 3) or (*batch, m + 1, n + 1, 4)
    parameters : ndarray, shape (*batch, ..., 2)

    Returns
    -------
    ndarray, shape (*batch, ..., 3)
    """
    normal, sine = _unit_normal(*_tangents(control_points, parameters))
    bad = (sine < DEGENERATE)[..., None]
    if bad.any():
        inside = np.where(bad, parameters + ASIDE * (0.5 - parameters), parameters)
        aside, _ = _unit_normal(*_tangents(control_points, inside))
        normal = np.where(bad, aside, normal)
    return normal


def normals_and_bends(coefficients: Array, patch: Ints, x: Array) -> tuple[Array, Array, Array]:
    """Return positions, unit normals along S_u x S_v, and how the normals bend.

    It is `unit_normals` for many small batches of points.

    Parameters
    ----------
    coefficients : ndarray, shape (patches, m + 1, m + 1, 3 or 4)
        Coefficients of powers, from `bodymeasure.bezier.power_form`.
    patch : ndarray of int, shape (k,)
    x : ndarray, shape (k, 2)

    Returns
    -------
    position, normal : ndarray, shape (k, 3)
    bend : ndarray, shape (k, 3, 3)
        Second derivatives, by the position, of the distance to the surface at its foot, counted
        along the normal; 0 where the tangents span no plane.
    """
    side, coordinates = coefficients.shape[2:]
    if not (is_compiled() and coordinates == 3 and side <= MOST_DEGREE + 1):
        return _normals_and_bends(coefficients[patch], x)
    *result, regular = normals_in_powers(coefficients, patch, x, (DEGENERATE, NEAR_POLE))
    if not regular.all():
        row = np.flatnonzero(~regular)
        rest = _normals_and_bends(coefficients[patch[row]], x[row])
        for each, other in zip(result, rest, strict=True):
            each[row] = other
    position, normal, bend = result
    return position, normal, bend


def _normals_and_bends(coefficients: Array, x: Array) -> tuple[Array, Array, Array]:
    """The same for one patch a point."""
    s = jets(coefficients, x)
    position = s[:, 0, 0].copy()
    normal, sine = _unit_normal(s[:, 1, 0], s[:, 0, 1])
    speed = np.linalg.norm(np.stack([s[:, 1, 0], s[:, 0, 1]]), axis=2)
    ratio = speed.min(axis=0) / np.maximum(speed.max(axis=0), np.finfo(np.float64).tiny)
    bad = np.flatnonzero((sine < DEGENERATE) | (ratio < AT_POLE))
    if len(bad):
        normal[bad] = _normal_aside(coefficients[bad], x[bad], AT_POLE)[1]
    regular = sine >= DEGENERATE
    row = np.flatnonzero(~regular | (ratio < NEAR_POLE))
    # Beside a pole, second derivatives are long, and perpendicular to the normal there alone.
    own = normal.copy()
    if len(row):
        s[row], own[row], sine[row] = _normal_aside(coefficients[row], x[row], ASIDE)
    regular[row] = (ratio[row] < NEAR_POLE) & (sine[row] >= DEGENERATE)
    return position, normal, _bend(s, own, regular)


def _normal_aside(coefficients: Array, x: Array, part: float) -> tuple[Array, Array, Array]:
    """Return derivatives, unit normals and sines at points nearer to the middles of patches."""
    s = jets(coefficients, x + part * (0.5 - x))
    return s, *_unit_normal(s[:, 1, 0], s[:, 0, 1])


def _tangents(control_points: Array, parameters: Array) -> tuple[Array, Array]:
    jet = derivatives(_moved_to_origin(control_points), parameters, order=1)
    return jet[..., 1, 0, :], jet[..., 0, 1, :]


def _unit_normal(su: Array, sv: Array) -> tuple[Array, Array]:
    """Unit normals, and the sines of the angles between the tangents."""
    cross = np.cross(su, sv)
    length = np.linalg.norm(cross, axis=-1)
    product = np.linalg.norm(su, axis=-1) * np.linalg.norm(sv, axis=-1)
    tiny = np.finfo(np.float64).tiny
    return cross / np.maximum(length, tiny)[..., None], length / np.maximum(product, tiny)


def _bend(s: Array, normal: Array, regular: Bools) -> Array:
    """Second derivatives of the distance to the surface, 0 where there is no tangent plane."""
    tangents = np.stack([s[:, 1, 0], s[:, 0, 1]], axis=2)
    # The metric of unit tangents is well-conditioned, unless they are parallel.
    speed = np.linalg.norm(tangents, axis=1)
    speed[~regular] = 1.0
    tangents = tangents / speed[:, None]
    metric = tangents.swapaxes(1, 2) @ tangents
    metric[~regular] = np.eye(2)
    dual = tangents @ np.linalg.inv(metric)
    second = np.einsum("kijc,kc->kij", s[:, [[2, 1], [1, 0]], [[0, 1], [1, 2]]], normal)
    second /= speed[:, :, None] * speed[:, None, :]
    second[~regular] = 0.0
    return np.asarray(-dual @ second @ dual.swapaxes(1, 2))
