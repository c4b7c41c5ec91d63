r"""The path of least energy, made of elements, in the box [0, 1]^2.

With :math:`w_i` the parts of the length that the elements are to have, and :math:`E_i` their
energies over unit intervals of time, :math:`\sum 2 E_i / w_i \ge L^2`, and they are equal where
each element has its part and a constant speed. So the path of least energy is a shortest path, its
joints are where the parts say, and its speed is constant.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.elements.path import DEGREE, ElementPath
from bodymeasure.geodesic.lengths.functionals import energy
from bodymeasure.geodesic.numerics.box_newton import BoxMinimum, SecondOrder, minimize_in_box
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface

ALL_NODES = slice(None)
# The rows of the Hessian's lower bands.
BANDS = 2 * (DEGREE + 1)


def least_energy(
    surface: Surface, path: ElementPath, idle: Bools, most_steps: int
) -> tuple[ElementPath, BoxMinimum]:
    """Return the path of least energy near a path.

    Parameters
    ----------
    surface : Surface
        The surface of one problem.
    path : ElementPath
    idle : ndarray of bool, shape (unknowns,)
        Unknowns that stay what they are.
    most_steps : int
        The most steps of Newton's method.
    """
    elements = len(path.widths)
    own = surface.take(np.zeros(elements, np.int64))
    space, places = polynomial_space(DEGREE), _places(elements)
    factor = 1.0 / path.widths[:, None]

    def expand(unknowns: Array) -> SecondOrder:
        whole = energy(own, space, path.moved(unknowns).values, ALL_NODES)
        count = len(unknowns)
        gradient: Array = np.zeros(count)
        gradient += np.bincount(places.rows, (whole.gradient * factor).ravel(), count)
        lower = whole.hessian[:, places.lower[0], places.lower[1]] * factor
        bands: Array = np.zeros(BANDS * count)
        bands += np.bincount(places.bands, lower.ravel(), BANDS * count)
        value = float(whole.value @ factor[:, 0])
        return SecondOrder(value, gradient, bands.reshape(BANDS, count))

    minimum = minimize_in_box(expand, path.unknowns, idle, most_steps)
    return path.moved(minimum.unknowns), minimum


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
