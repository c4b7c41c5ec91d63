r"""The energy and the length of paths as functions of their nodal values.

With :math:`x' = S_u u' + S_v v'`, the energy is :math:`\tfrac12 \int |x'|^2 dt` and the length
:math:`\int |x'| dt`. At each quadrature point both depend on z = (u, v, u', v') alone, with

.. math:: \nabla E = J^T x', \qquad \nabla^2 E = J^T J + x' \cdot \nabla^2 x', \qquad J = dx'/dz,

and, with :math:`\sigma = |x'|`, :math:`\nabla L = \nabla E / \sigma` and
:math:`\nabla^2 L = (\nabla^2 E - \nabla L \nabla L^T) / \sigma`. All derivatives are exact.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.lengths.equations import dot
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

INNER_NODES = slice(1, -1)


@dataclass(frozen=True)
class Functional:
    """What is minimized: energy over u and v, or length over v alone with u as it is."""

    name: Literal["energy", "length"]

    @property
    def coordinates(self) -> tuple[int, ...]:
        """The unknown functions, by their place in (u, v)."""
        return (0, 1) if self.name == "energy" else (1,)


@dataclass(frozen=True)
class Expansion:
    """A functional of paths to the second order, by the nodal values of its unknown functions.

    Arrays of shapes (problems,), (problems, k) and (problems, k, k); of two unknown functions,
    all nodes of u come first.
    """

    value: Array
    gradient: Array
    hessian: Array


# Where a path stands still its length has no derivative: not finite, which `minimize` sees.
@np.errstate(divide="ignore", invalid="ignore", over="ignore")
def expand(
    functional: Functional,
    surface: Surface,
    space: TrialSpace,
    values: Array,
    nodes: slice = INNER_NODES,
) -> Expansion:
    """Value, gradient and Hessian for paths with nodal values of shape (problems, 2, n + 1).

    By the values at the inner nodes, or at other `nodes`.
    """
    place, slopes, _ = space.at_quadrature
    weights = space.quadrature.weights
    du, dv = ((values - values[:, :, :1]) @ slopes.T).transpose(1, 0, 2)
    jet = surface.jet((values @ place.T).transpose(0, 2, 1), 3)
    _, s_u, s_v, s_uu, s_uv, s_vv, s_uuu, s_uuv, s_uvv, s_vvv = jet
    x = s_u * du + s_v * dv
    # dx'/dz, and x' . d2x'/dz2 where that is not zero.
    by = (s_uu * du + s_uv * dv, s_uv * du + s_vv * dv, s_u, s_v)
    mixed = dot(x, s_uuv * du + s_uvv * dv)
    bend = {
        (0, 0): dot(x, s_uuu * du + s_uuv * dv),
        (0, 1): mixed,
        (1, 1): dot(x, s_uvv * du + s_vvv * dv),
        (0, 2): dot(x, s_uu),
        (0, 3): dot(x, s_uv),
        (1, 2): dot(x, s_uv),
        (1, 3): dot(x, s_vv),
    }
    speed_squared = dot(x, x)
    if functional.name == "energy":
        density, factor = 0.5 * speed_squared, np.ones_like(speed_squared)
    else:
        density = np.sqrt(speed_squared)
        factor = 1.0 / density

    gradients = [dot(x, by[a]) * factor for a in range(4)]

    def second(a: int, b: int) -> Array:
        a, b = min(a, b), max(a, b)
        result: Array = dot(by[a], by[b])
        if (a, b) in bend:
            result = result + bend[a, b]
        if functional.name == "length":
            result = result - gradients[a] * gradients[b]
        return result * factor * weights

    inner = (place[:, nodes], slopes[:, nodes])
    unknowns = functional.coordinates
    gradient = [
        (gradients[c] * weights) @ inner[0] + (gradients[c + 2] * weights) @ inner[1]
        for c in unknowns
    ]
    problems, size = len(values), inner[0].shape[1]
    hessian = np.empty((problems, len(unknowns), size, len(unknowns), size))
    for i, a in enumerate(unknowns):
        for j, b in enumerate(unknowns[: i + 1]):
            block: Array = np.zeros((problems, size, size))
            for order in range(2):
                right = second(a + 2 * order, b)[..., None] * inner[0]
                right += second(a + 2 * order, b + 2)[..., None] * inner[1]
                block += inner[order].T @ right
            hessian[:, i, :, j] = block
            hessian[:, j, :, i] = block.transpose(0, 2, 1)
    return Expansion(
        density @ weights,
        np.concatenate(gradient, axis=1),
        hessian.reshape(problems, len(unknowns) * size, -1),
    )
