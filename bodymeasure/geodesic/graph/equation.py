r"""The geodesic equation for paths that run across their straight line as a graph.

Where a path does not turn back, one unknown function determines it: the offset q(t), with
:math:`(u, v) = (t + q, t - q)` on a patch whose corners (0, 0) and (1, 1) are its ends. With
:math:`T(t, q) = S(t + q, t - q)` the path has the velocity :math:`x' = T_t + T_q q'` and, but for
:math:`T_q q''`, the acceleration :math:`h = T_{tt} + 2 T_{tq} q' + T_{qq} q'^2`. Its geodesic
curvature is zero where

.. math:: F = W q'' + (x' \cdot T_t)(h \cdot T_q) - (x' \cdot T_q)(h \cdot T_t) = 0, \qquad
   W = |T_t \times T_q|^2,

one equation, while the form with u(t) and v(t) has two: half the unknowns, an eighth of the linear
algebra. On a Bezier patch T_q, T_t and T_tt are at a fixed t polynomials in q. All arrays have the
batch along their last axis.
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


def linearize(coefficients: Any, offset: Any, slope: Any, bend: Any) -> tuple[Any, Any, Any, Any]:
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
    e, f, g = dot(t_t, t_t), dot(t_t, t_q), dot(t_q, t_q)
    tq_q, tq_t, qq_q, qq_t = dot(t_tq, t_q), dot(t_tq, t_t), dot(t_qq, t_q), dot(t_qq, t_t)
    e_q, f_q, g_q = 2.0 * tq_t, tq_q + qq_t, 2.0 * qq_q
    # x' . T_t and x' . T_q, and h with its derivative by q.
    along, across = e + f * slope, f + g * slope
    h = t_tt + (2.0 * t_tq + t_qq * p) * p
    h_q = t_ttq + (2.0 * t_tqq + t_qqq * p) * p
    by_q, by_t = dot(h, t_q), dot(h, t_t)
    area = e * g - f * f
    left = area * bend + along * by_q - across * by_t
    left_q = (e_q * g + e * g_q - 2.0 * f * f_q) * bend
    left_q += (e_q + f_q * slope) * by_q - (f_q + g_q * slope) * by_t
    left_q += along * (dot(h_q, t_q) + dot(h, t_qq)) - across * (dot(h_q, t_t) + dot(h, t_tq))
    # The derivative of h by q' is 2 T_tq + 2 T_qq q'.
    left_p = f * by_q - g * by_t
    left_p += 2.0 * (along * (tq_q + qq_q * slope) - across * (tq_t + qq_t * slope))
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
    bent = dot(velocity, t_t) * dot(acceleration, t_q) - dot(velocity, t_q) * dot(acceleration, t_t)
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
