r"""The energy and the length of paths as functions of their nodal values.

With :math:`x' = S_u u' + S_v v'`, the energy is :math:`\tfrac12 \int |x'|^2 dt` and the length
:math:`\int |x'| dt`. At each quadrature point both depend on z = (u, v, u', v') alone, with

.. math:: \nabla E = J^T x', \qquad \nabla^2 E = J^T J + x' \cdot \nabla^2 x', \qquad J = dx'/dz,

and, with :math:`\sigma = |x'|`, :math:`\nabla L = \nabla E / \sigma` and
:math:`\nabla^2 L = (\nabla^2 E - \nabla L \nabla L^T) / \sigma`. All derivatives are exact.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.lengths.equations import dot
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.geodesic.surfaces.protocol import Surface
from bodymeasure.native import PathTables, energies

INNER_NODES = slice(1, -1)


@dataclass(frozen=True)
class SecondOrder:
    """A functional of paths to the second order, by the nodal values of its unknown functions.

    Parameters
    ----------
    value : ndarray, shape (problems,)
    gradient : ndarray, shape (problems, k)
        The derivatives by the values at the nodes; of two unknown functions, all nodes of u come
        first.
    hessian : ndarray, shape (problems, k, k)
    """

    value: Array
    gradient: Array
    hessian: Array


class Functional(Protocol):
    """A functional of paths, as `energy` and `length_over_v` are."""

    def __call__(
        self, surface: Surface, space: TrialSpace, values: Array, nodes: slice = INNER_NODES
    ) -> SecondOrder:
        """Return value, gradient and Hessian for nodal values of shape (problems, 2, n + 1)."""


def energy(
    surface: Surface, space: TrialSpace, values: Array, nodes: slice = INNER_NODES
) -> SecondOrder:
    """Return the energy of paths to the second order, by u and v.

    Parameters
    ----------
    surface : Surface
    space : TrialSpace
    values : ndarray, shape (problems, 2, n + 1)
        The nodal values of u and v.
    nodes : slice
        The nodes by whose values the derivatives are taken.
    """
    compiled = _compiled(surface, space, values, nodes, flat=False)
    return compiled or _energy(_terms(surface, space, values), space, nodes)


def energy_of_a_flat_surface(
    surface: Surface, space: TrialSpace, values: Array, nodes: slice = INNER_NODES
) -> SecondOrder:
    """Return `energy` with J^T J for its Hessian, as in a plane, which has no negative eigenvalue.

    The parameters are those of `energy`.
    """
    compiled = _compiled(surface, space, values, nodes, flat=True)
    return compiled or _energy(_terms(surface, space, values)._replace(bend={}), space, nodes)


def _compiled(
    surface: Surface, space: TrialSpace, values: Array, nodes: slice, *, flat: bool
) -> SecondOrder | None:
    """What compiled kernels find; None if they do not serve."""
    tables = path_tables(surface, space)
    if tables is None:
        return None
    value, gradient, hessian = energies(tables, values, flat)
    if nodes != slice(None):
        count, every = len(value), values.shape[2]
        gradient = gradient.reshape(count, 2, every)[:, :, nodes].reshape(count, -1)
        hessian = hessian.reshape(count, 2, every, 2, every)[:, :, nodes][..., nodes]
        hessian = hessian.reshape(*gradient.shape, -1)
    return SecondOrder(value, gradient, hessian)


def path_tables(surface: Surface, space: TrialSpace) -> PathTables | None:
    """Return patches and a trial space as compiled kernels take them; None if they do not serve."""
    if not isinstance(surface, BezierSurfaces) or surface.coordinates != 3:
        return None
    place, slopes, _ = space.at_quadrature
    weights = space.quadrature.weights
    tables = PathTables(surface.nets, surface.degrees, place, slopes, weights)
    return tables if tables.are_served else None


def _energy(terms: "_Terms", space: TrialSpace, nodes: slice) -> SecondOrder:
    density = 0.5 * dot(terms.velocity, terms.velocity)
    return _integrated(space, nodes, density, (terms.gradient, terms.second), (0, 1))


# Where a path stands still its length has no derivative; `minimize` sees that it is not finite.
@np.errstate(divide="ignore", invalid="ignore", over="ignore")
def length_over_v(
    surface: Surface, space: TrialSpace, values: Array, nodes: slice = INNER_NODES
) -> SecondOrder:
    """Return the length of paths to the second order, by v alone while u stays as it is.

    The parameters are those of `energy`.
    """
    terms = _terms(surface, space, values)
    speed = np.sqrt(dot(terms.velocity, terms.velocity))
    factor = 1.0 / speed
    gradients = [terms.gradient(a) * factor for a in range(4)]

    def second(a: int, b: int) -> Array:
        return (terms.second(a, b) - gradients[a] * gradients[b]) * factor

    return _integrated(space, nodes, speed, (gradients.__getitem__, second), (1,))


class _Terms(NamedTuple):
    """The velocity x' of paths at the quadrature points, and its derivatives by z.

    Parameters
    ----------
    velocity : ndarray, shape (3, problems, points)
    by : tuple of four ndarrays of that shape
        dx'/dz.
    bend : dict of ndarray, shape (problems, points)
        x' . d2x'/dz2 by the places of both in z, the lesser first, where that is not zero.
    """

    velocity: Array
    by: tuple[Array, Array, Array, Array]
    bend: dict[tuple[int, int], Array]

    def gradient(self, a: int) -> Array:
        """Return the derivative of the energy's density by component a of z."""
        return dot(self.velocity, self.by[a])

    def second(self, a: int, b: int) -> Array:
        """Return the density's second derivative by the components a and b."""
        a, b = min(a, b), max(a, b)
        result = dot(self.by[a], self.by[b])
        return result + self.bend[a, b] if (a, b) in self.bend else result


def _terms(surface: Surface, space: TrialSpace, values: Array) -> _Terms:
    place, slopes, _ = space.at_quadrature
    du, dv = ((values - values[:, :, :1]) @ slopes.T).transpose(1, 0, 2)
    jet = surface.jet((values @ place.T).transpose(0, 2, 1), 3)
    _, s_u, s_v, s_uu, s_uv, s_vv, s_uuu, s_uuv, s_uvv, s_vvv = jet
    x = s_u * du + s_v * dv
    by = (s_uu * du + s_uv * dv, s_uv * du + s_vv * dv, s_u, s_v)
    mixed = dot(x, s_uv)
    bend = {
        (0, 0): dot(x, s_uuu * du + s_uuv * dv),
        (0, 1): dot(x, s_uuv * du + s_uvv * dv),
        (1, 1): dot(x, s_uvv * du + s_vvv * dv),
        (0, 2): dot(x, s_uu),
        (0, 3): mixed,
        (1, 2): mixed,
        (1, 3): dot(x, s_vv),
    }
    return _Terms(x, by, bend)


def _integrated(
    space: TrialSpace,
    nodes: slice,
    density: Array,
    derivatives: tuple[Callable[[int], Array], Callable[[int, int], Array]],
    unknowns: tuple[int, ...],
) -> SecondOrder:
    """Integrals of a density and of its derivatives by z, taken to the unknowns' nodal values."""
    first, second = derivatives
    weights = space.quadrature.weights
    maps = space.at_quadrature[:2, :, nodes]
    gradient = [
        (first(c) * weights) @ maps[0] + (first(c + 2) * weights) @ maps[1] for c in unknowns
    ]
    problems, size = len(density), maps.shape[2]
    hessian = np.empty((problems, len(unknowns), size, len(unknowns), size))
    for i, a in enumerate(unknowns):
        for j, b in enumerate(unknowns[: i + 1]):
            block: Array = np.zeros((problems, size, size))
            for order in range(2):
                right = (second(a + 2 * order, b) * weights)[..., None] * maps[0]
                right += (second(a + 2 * order, b + 2) * weights)[..., None] * maps[1]
                block += maps[order].T @ right
            hessian[:, i, :, j] = block
            hessian[:, j, :, i] = block.transpose(0, 2, 1)
    return SecondOrder(
        density @ weights,
        np.concatenate(gradient, axis=1),
        hessian.reshape(problems, len(unknowns) * size, -1),
    )
