r"""The geodesic equation for paths that run across their straight line as a graph.

Where a path does not turn back, one unknown function determines it: the offset q(t), with
:math:`(u, v) = (t + q, t - q)` on a patch whose corners (0, 0) and (1, 1) are its ends. With
:math:`T(t, q) = S(t + q, t - q)` the path has the velocity :math:`x' = T_t + T_q q'` and, but for
:math:`T_q q''`, the acceleration :math:`h = T_{tt} + 2 T_{tq} q' + T_{qq} q'^2`. Its geodesic
curvature is zero where

.. math:: F = W q'' + (x' \times h) \cdot N = 0, \qquad N = T_t \times T_q, \quad W = |N|^2,

one equation, while the form with u(t) and v(t) has two: half the unknowns, an eighth of the linear
algebra. In scalar products W is E G - F^2, which would lose the width of patches that are 1e8 times
as long as wide: there it is a difference of numbers that are equal but for rounding. On a Bezier
patch T_q, T_t and T_tt are at a fixed t polynomials in q. All arrays have the batch along their
last axis.
"""

from typing import Any

from bodymeasure.geodesic.lengths.path_geometry import PathGeometry


def derivatives_by_offset(coefficients: Any, offset: Any, order: int) -> list[Any]:
    """Return the values of polynomials in q and their derivatives, by Horner's scheme.

    Parameters
    ----------
    coefficients : array, shape (powers, fields, points, 3, problems)
    offset : array, shape (points, problems)
    order : int
        0 to 2.

    Returns
    -------
    list of array, shape (fields, points, 3, problems)
    """
    q = offset[:, None, :]
    highest = coefficients.shape[0] - 1
    # Patches of low degree have fewer derivatives than are asked for.
    sums = [(1.0 if k <= highest else 0.0) * coefficients[highest, ...] for k in range(order + 1)]
    for power in range(highest - 1, -1, -1):
        for k in range(min(order, highest - 1 - power), 0, -1):
            sums[k] *= q
            sums[k] += sums[k - 1]
        sums[0] *= q
        sums[0] += coefficients[power, ...]
    if order == 2:
        sums[2] *= 2.0
    return sums


def dot(a: Any, b: Any) -> Any:
    """Return the scalar products of vectors whose components run along axis 1."""
    result = a[:, 0, :] * b[:, 0, :]
    result += a[:, 1, :] * b[:, 1, :]
    result += a[:, 2, :] * b[:, 2, :]
    return result


def linearize(
    coefficients: Any, offset: Any, slope: Any, bend: Any, xp: Any
) -> tuple[Any, Any, Any, Any]:
    """Return the equation's left side F and its derivatives by q, q' and q''.

    Parameters
    ----------
    coefficients : array, shape (powers, 3, points, 3, problems)
        The polynomials that `graph.maps.offset_map` gives.
    offset, slope, bend : array, shape (points, problems)
        q, q' and q''.

    Returns
    -------
    tuple of four arrays, shape (points, problems)
    """
    place, first, second = derivatives_by_offset(coefficients[:, :2, ...], offset, 2)
    t_q, t_t, t_qq, t_tq, t_qqq, t_tqq = (
        derivative[field, ...] for derivative in (place, first, second) for field in (0, 1)
    )
    t_tt, t_ttq = (x[0, ...] for x in derivatives_by_offset(coefficients[:-1, 2:, ...], offset, 1))
    p = slope[:, None, :]
    # x', h, and their derivatives by q; that of h by q' is twice that of x' by q.
    velocity, ahead = t_t + t_q * p, t_tq + t_qq * p
    h = t_tt + (2.0 * t_tq + t_qq * p) * p
    h_q = t_ttq + (2.0 * t_tqq + t_qqq * p) * p
    normal, turn = _cross(t_t, t_q, xp), _cross(velocity, h, xp)
    normal_q = _cross(t_tq, t_q, xp) + _cross(t_t, t_qq, xp)
    # (a x h) . n = a . (h x n), and (x' x b) . n = b . (n x x').
    by_velocity, by_h = _cross(h, normal, xp), _cross(normal, velocity, xp)
    area = dot(normal, normal)
    left = area * bend + dot(turn, normal)
    left_q = 2.0 * dot(normal, normal_q) * bend + dot(turn, normal_q)
    left_q += dot(ahead, by_velocity) + dot(h_q, by_h)
    left_p = dot(t_q, by_velocity) + 2.0 * dot(ahead, by_h)
    return left, left_q, left_p, area


def offset_geometry(coefficients: Any, offset: Any, slope: Any, bend: Any, xp: Any) -> PathGeometry:
    """Return speed and curvatures of paths; the arguments are those of `linearize`."""
    place, first = derivatives_by_offset(coefficients[:, :2, ...], offset, 1)
    t_q, t_t, t_qq, t_tq = (x[field, ...] for x in (place, first) for field in (0, 1))
    (t_tt,) = (x[0, ...] for x in derivatives_by_offset(coefficients[:, 2:, ...], offset, 0))
    p = slope[:, None, :]
    velocity = t_t + t_q * p
    acceleration = t_tt + (2.0 * t_tq + t_qq * p) * p + t_q * bend[:, None, :]
    normal = _cross(t_t, t_q, xp)
    area = dot(normal, normal)
    speed_squared = dot(velocity, velocity)
    speed = xp.sqrt(speed_squared)
    bent = dot(_cross(velocity, acceleration, xp), normal)
    twist = dot(t_tq, normal)
    return PathGeometry(
        speed=speed,
        geodesic_curvature=bent / (speed_squared * speed * xp.sqrt(area)),
        gaussian_curvature=(dot(t_tt, normal) * dot(t_qq, normal) - twist * twist) / (area * area),
    )


def _cross(a: Any, b: Any, xp: Any) -> Any:
    return xp.stack(
        [
            a[:, 1, :] * b[:, 2, :] - a[:, 2, :] * b[:, 1, :],
            a[:, 2, :] * b[:, 0, :] - a[:, 0, :] * b[:, 2, :],
            a[:, 0, :] * b[:, 1, :] - a[:, 1, :] * b[:, 0, :],
        ],
        axis=1,
    )
