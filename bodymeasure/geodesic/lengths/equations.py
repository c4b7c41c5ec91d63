"""The geodesic equations at collocation points, and their Jacobian."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface


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
    """The equations' left sides at points, and their derivatives.

    Parameters
    ----------
    residual : ndarray, shape (2, ...)
    by_value, by_velocity, by_second : ndarray, shape (2, 2, ...)
        The derivatives of each equation by each coordinate, u or v.
    """

    residual: Array
    by_value: Array
    by_velocity: Array
    by_second: Array


def linearization(jet: Array, velocity: Array, second: Array) -> Linearization:
    """Return ``S_u . a`` and ``S_v . a``, with a the `acceleration`, and their derivatives.

    Parameters
    ----------
    jet : ndarray, shape (10, 3, ...)
    velocity, second : ndarray, shape (2, ...)
    """
    (du, dv), (ddu, ddv) = velocity, second
    duu, duv, dvv = du * du, 2.0 * du * dv, dv * dv
    twice_du, twice_dv = 2.0 * du, 2.0 * dv
    # The acceleration and its derivatives by u, v, u' and v' are sums of derivatives of the surface
    # with these factors. All together they take a few operations, where single ones took a hundred.
    factors = np.zeros((5, 10, *du.shape))
    for sums, terms in enumerate(
        (
            {1: ddu, 2: ddv, 3: duu, 4: duv, 5: dvv},
            {3: ddu, 4: ddv, 6: duu, 7: duv, 8: dvv},
            {4: ddu, 5: ddv, 7: duu, 8: duv, 9: dvv},
            {3: twice_du, 4: twice_dv},
            {4: twice_du, 5: twice_dv},
        )
    ):
        for number, factor in terms.items():
            factors[sums, number] = factor
    sums = np.einsum("ad...,dc...->ac...", factors, jet)
    tangents = jet[1:3]
    products = np.einsum("ic...,ac...->ia...", tangents, sums)
    # The acceleration by itself, with S_uu, S_uv and S_vv.
    bent = np.einsum("dc...,c...->d...", jet[3:6], sums[0])
    by_value = products[:, 1:3]
    by_value[0] += bent[:2]
    by_value[1] += bent[1:]
    metric = np.einsum("ic...,jc...->ij...", tangents, tangents)
    return Linearization(products[:, 0], by_value, products[:, 3:], metric)


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

    points = inner.shape[2]
    by_node = slice(None) if ends else slice(1, -1)
    first, second = first[:, by_node], second[:, by_node]
    row = np.arange(points)
    jacobian = _by_row(here.by_velocity) * first[:, None]
    jacobian += _by_row(here.by_second) * second[:, None]
    # The indices come first, and then what is not indexed.
    jacobian[:, :, row, :, row + 1 if ends else row] += here.by_value.transpose(3, 2, 0, 1)
    return here.residual.swapaxes(0, 1), jacobian


def _by_row(entries: Array) -> Array:
    """(equation, coordinate, problem, point) as (problem, equation, point, coordinate, 1)."""
    return entries.transpose(2, 0, 3, 1)[..., None]
