"""The geodesic equations at collocation points, and their Jacobian."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bodymeasure.geodesic.surface import Surface
from bodymeasure.geodesic.trial_space import TrialSpace

_Array = NDArray[np.float64]


def dot(a: _Array, b: _Array) -> _Array:
    """Scalar product of vectors whose components run along axis 0."""
    product: _Array = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    return product


def acceleration(jet: _Array, velocity: _Array, second: _Array) -> _Array:
    """Second derivative of S(u(t), v(t)) by t.

    Parameters
    ----------
    jet : ndarray, shape (>= 6, 3, ...)
        Derivatives of the surface, in the order of `surface.JET`.
    velocity, second : ndarray, shape (2, ...)
        (u', v') and (u'', v'').

    Returns
    -------
    ndarray, shape (3, ...)
    """
    du, dv = velocity
    _, s_u, s_v, s_uu, s_uv, s_vv = jet[:6]
    result: _Array = (
        s_uu * (du * du)
        + s_uv * (2.0 * du * dv)
        + s_vv * (dv * dv)
        + s_u * second[0]
        + s_v * second[1]
    )
    return result


def residual_and_jacobian(
    surface: Surface, space: TrialSpace, values: _Array
) -> tuple[_Array, _Array]:
    """Tangential acceleration at the collocation points, and its derivative by the nodal values.

    With a the acceleration of S(u(t), v(t)), the equations are ``S_u . a = 0 = S_v . a``: the
    paper's (1) and (2) multiplied by the metric. They need no Christoffel symbols and stay finite
    where the metric is nearly singular.

    Parameters
    ----------
    surface : Surface
    space : TrialSpace
        With n + 1 nodes.
    values : ndarray, shape (problems, 2, n + 1)
        u and v at the nodes.

    Returns
    -------
    residual : ndarray, shape (problems, 2, n - 1)
    jacobian : ndarray, shape (problems, 2, n - 1, 2, n - 1)
        By u and v at the inner nodes.
    """
    first, second = space.differentiation
    inner = values[:, :, 1:-1]
    velocity = (values @ first.T).transpose(1, 0, 2)
    bend = (values @ second.T).transpose(1, 0, 2)
    jet = surface.jet(inner.transpose(0, 2, 1), 3)
    _, s_u, s_v, s_uu, s_uv, s_vv, s_uuu, s_uuv, s_uvv, s_vvv = jet
    du, dv = velocity
    a = acceleration(jet, velocity, bend)
    tangents = (s_u, s_v)
    residual = np.stack([dot(s_u, a), dot(s_v, a)], axis=1)

    duu, duv, dvv = du * du, 2.0 * du * dv, dv * dv
    a_by_value = (
        s_uuu * duu + s_uuv * duv + s_uvv * dvv + s_uu * bend[0] + s_uv * bend[1],
        s_uuv * duu + s_uvv * duv + s_vvv * dvv + s_uv * bend[0] + s_vv * bend[1],
    )
    a_by_velocity = (2.0 * (s_uu * du + s_uv * dv), 2.0 * (s_uv * du + s_vv * dv))
    tangents_by_value = ((s_uu, s_uv), (s_uv, s_vv))

    problems, _, points = inner.shape
    jacobian = np.empty((problems, 2, points, 2, points))
    diagonal = np.arange(points)
    for row in range(2):
        for column in range(2):
            block = jacobian[:, row, :, column]
            by_velocity = dot(tangents[row], a_by_velocity[column])
            by_bend = dot(tangents[row], tangents[column])
            np.multiply(by_velocity[:, :, None], first[:, 1:-1], out=block)
            block += by_bend[:, :, None] * second[:, 1:-1]
            block[:, diagonal, diagonal] += dot(tangents_by_value[row][column], a) + dot(
                tangents[row], a_by_value[column]
            )
    return residual, jacobian
