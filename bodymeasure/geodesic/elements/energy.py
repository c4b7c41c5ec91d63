r"""The energy of a path made of elements, by all its unknowns.

With :math:`w_i` the parts of the length that the elements are to have, and :math:`E_i` their
energies over unit intervals of time, :math:`\sum 2 E_i / w_i \ge L^2`, and they are equal where
each element has its part and a constant speed. So the path of least energy is a shortest path, its
joints are where the parts say, and its speed is constant.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.elements.path import DEGREE, ElementPath
from bodymeasure.geodesic.lengths.functionals import Functional, energy
from bodymeasure.geodesic.numerics.box_newton import SecondOrder
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface

ALL_NODES = slice(None)
# The rows of the Hessian's lower bands.
BANDS = 2 * (DEGREE + 1)


@dataclass(frozen=True, eq=False)
class PathEnergy:
    """The energy of paths that are made of elements as one path is.

    Parameters
    ----------
    surface : Surface
        The surface of one problem.
    path : ElementPath
        A path with the parts that the elements are to have.
    """

    surface: Surface
    path: ElementPath

    def expanded(self, unknowns: Array, functional: Functional = energy) -> SecondOrder:
        """Return the energy to the second order, or another functional of the elements."""
        places, count = _places(len(self.path.widths)), len(unknowns)
        values = self.path.moved(unknowns).values
        whole = functional(self._own, polynomial_space(DEGREE), values, ALL_NODES)
        factor = 1.0 / self.path.widths[:, None]
        gradient: Array = np.zeros(count)
        gradient += np.bincount(places.rows, (whole.gradient * factor).ravel(), count)
        lower = whole.hessian[:, places.lower[0], places.lower[1]] * factor
        bands: Array = np.zeros(BANDS * count)
        bands += np.bincount(places.bands, lower.ravel(), BANDS * count)
        value = float(whole.value @ factor[:, 0])
        return SecondOrder(value, gradient, bands.reshape(BANDS, count))

    @cached_property
    def stiffness(self) -> Array:
        """The second derivative, by each node's place in space, of the energy; shape (nodes,)."""
        space = polynomial_space(DEGREE)
        own = space.quadrature.weights @ space.at_quadrature[1] ** 2
        result = np.zeros(DEGREE * len(self.path.widths) + 1)
        for number, width in enumerate(self.path.widths):
            result[number * DEGREE : (number + 1) * DEGREE + 1] += own / width
        return result

    @cached_property
    def _own(self) -> Surface:
        return self.surface.take(np.zeros(len(self.path.widths), np.int64))


class _Places(NamedTuple):
    """Where the derivatives by the unknowns of elements stand among those of a path.

    Parameters
    ----------
    rows : ndarray of int, shape (elements * 2 (DEGREE + 1),)
        The unknown of each entry of the elements' gradients.
    lower : ndarray of int, shape (2, k)
        The rows and columns of the elements' Hessians that make the lower triangle of the path's.
    bands : ndarray of int, shape (elements * k,)
        The places in its flattened bands of these entries.
    """

    rows: Ints
    lower: Ints
    bands: Ints


@lru_cache(maxsize=8)
def _places(elements: int) -> _Places:
    node = np.arange(DEGREE + 1)
    # All u of an element come first; of the path, u and v of each node stand together.
    local = np.concatenate([2 * node, 2 * node + 1])
    first = 2 * DEGREE * np.arange(elements)[:, None]
    lower = np.stack(np.nonzero(local[:, None] >= local))
    row, column = local[lower]
    count = 2 * (DEGREE * elements + 1)
    bands = first + ((row - column) * count + column)
    return _Places((first + local).ravel(), lower, bands.ravel())
