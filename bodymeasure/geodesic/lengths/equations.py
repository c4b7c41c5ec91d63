"""The geodesic equations at collocation points, and their Jacobian."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

_Pair = tuple[Array, Array]


def dot(a: Array, b: Array) -> Array:
    """Return the scalar products of vectors whose components run along axis 0."""
    product: Array = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    return product


def acceleration(jet: Array, velocity: Array, second: Array) -> Array:
    """Return the second derivative of S(u(t), v(t)) by t.

    Parameters
    ----------
    jet : ndarray, shape (>= 6, 3, ...)
        The derivatives of the surface, in the order of `surfaces.protocol.JET`.
    velocity, second : ndarray, shape (2, ...)
        (u', v') and (u'', v'').

    Returns
    -------
    ndarray, shape (3, ...)
    """
    du, dv = velocity
    _, s_u, s_v, s_uu, s_uv, s_vv = jet[:6]
    result: Array = (
        s_uu * (du * du)
        + s_uv * (2.0 * du * dv)
        + s_vv * (dv * dv)
        + s_u * second[0]
        + s_v * second[1]
    )
    return result


class Linearization(NamedTuple):
    """The equations' left sides at points, and their derivatives, each array of shape (...).

    In ``by_value[i][j]`` and the others, i is the equation and j the coordinate, u or v.
    """

    residual: _Pair
    by_value: tuple[_Pair, _Pair]
    by_velocity: tuple[_Pair, _Pair]
    by_second: tuple[_Pair, _Pair]


def linearization(jet: Array, velocity: Array, second: Array) -> Linearization:
    """Return ``S_u . a`` and ``S_v . a``, with a the `acceleration`, and their derivatives.

    Parameters
    ----------
    jet : ndarray, shape (10, 3, ...)
    velocity, second : ndarray, shape (2, ...)
    """
    _, s_u, s_v, s_uu, s_uv, s_vv, s_uuu, s_uuv, s_uvv, s_vvv = jet
    du, dv = velocity
    a = acceleration(jet, velocity, second)
    duu, duv, dvv = du * du, 2.0 * du * dv, dv * dv
    a_by_u = s_uuu * duu + s_uuv * duv + s_uvv * dvv + s_uu * second[0] + s_uv * second[1]
    a_by_v = s_uuv * duu + s_uvv * duv + s_vvv * dvv + s_uv * second[0] + s_vv * second[1]
    a_by_du = 2.0 * (s_uu * du + s_uv * dv)
    a_by_dv = 2.0 * (s_uv * du + s_vv * dv)
    mixed = dot(s_uv, a)
    metric_uv = dot(s_u, s_v)
    return Linearization(
        residual=(dot(s_u, a), dot(s_v, a)),
        by_value=(
            (dot(s_uu, a) + dot(s_u, a_by_u), mixed + dot(s_u, a_by_v)),
            (mixed + dot(s_v, a_by_u), dot(s_vv, a) + dot(s_v, a_by_v)),
        ),
        by_velocity=(
            (dot(s_u, a_by_du), dot(s_u, a_by_dv)),
            (dot(s_v, a_by_du), dot(s_v, a_by_dv)),
        ),
        by_second=((dot(s_u, s_u), metric_uv), (metric_uv, dot(s_v, s_v))),
    )


def residual_and_jacobian(
    surface: Surface, space: TrialSpace, values: Array, *, ends: bool = False
) -> tuple[Array, Array]:
    """Return the tangential acceleration at collocation points, and its derivative by nodal values.

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
    ends : bool
        Whether the Jacobian has columns for the end nodes too.

    Returns
    -------
    residual : ndarray, shape (problems, 2, n - 1)
    jacobian : ndarray, shape (problems, 2, n - 1, 2, n - 1), or (problems, 2, n - 1, 2, n + 1)
        By u and v at the inner nodes, or at all nodes.
    """
    first, second = space.differentiation
    inner = values[:, :, 1:-1]
    velocity = (values @ first.T).transpose(1, 0, 2)
    bend = (values @ second.T).transpose(1, 0, 2)
    jet = surface.jet(inner.transpose(0, 2, 1), 3)
    here = linearization(jet, velocity, bend)

    problems, _, points = inner.shape
    by_node = slice(None) if ends else slice(1, -1)
    first, second = first[:, by_node], second[:, by_node]
    jacobian = np.empty((problems, 2, points, 2, first.shape[1]))
    row_of = np.arange(points)
    column_of = row_of + 1 if ends else row_of
    for row in range(2):
        for column in range(2):
            block = jacobian[:, row, :, column]
            np.multiply(here.by_velocity[row][column][:, :, None], first, out=block)
            block += here.by_second[row][column][:, :, None] * second
            block[:, row_of, column_of] += here.by_value[row][column]
    return np.stack(here.residual, axis=1), jacobian
