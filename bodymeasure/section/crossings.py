"""Where a section crosses the sides of rectangles, each point known by one number."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas import EdgeTable, sides_of
from bodymeasure.bezier import bernstein
from bodymeasure.section.cells import Cells
from bodymeasure.section.roots import roots_of_polynomials


class Crossings(NamedTuple):
    """Points at which a section crosses the sides of rectangles.

    Parameters
    ----------
    number : ndarray of int, shape (cells, 4, degree)
        The crossings of each side (u lower, u upper, v lower, v upper), filled up with -1.
        Rectangles that share a point, even those of two patches, share its number.
    along : ndarray, shape (cells, 4, degree)
        The parameter that varies on the side, at each crossing.
    sides : ndarray of int, shape (crossings,)
        The number of patches that meet in each: 0 inside a patch, else as in `EdgeTable.sides`.
    line : ndarray of int, shape (crossings,)
        The edge of each crossing, as in `EdgeTable`; larger numbers are lines within patches.
    """

    number: Ints
    along: Array
    sides: Ints
    line: Ints


def find_crossings(distance: Array, cells: Cells, table: EdgeTable) -> Crossings:
    """Return the roots of the distance on all sides of rectangles.

    Parameters
    ----------
    distance : ndarray, shape (patches, degree + 1, degree + 1)
        Bernstein coefficients of the distance from the plane.
    cells : Cells
    table : EdgeTable
        The sides of these patches.

    Notes
    -----
    Roots belong to whole lines across a patch, or to edges of the atlas, and are found once for
    each, so that the rectangles on either side of a line see the same points, whatever their sizes.
    """
    line, flipped, low, high = _lines_of_sides(distance, cells, table)
    coefficients, row, sides = line
    roots = roots_of_polynomials(coefficients)
    exists = np.isfinite(roots)
    numbers = np.where(exists, np.cumsum(exists).reshape(roots.shape) - 1, -1)

    along = np.where(flipped[..., None], 1.0 - roots[row], roots[row])
    inside = (along >= low[..., None]) & (along < high[..., None])
    return Crossings(
        np.where(inside, numbers[row], -1),
        along,
        np.repeat(sides, exists.sum(axis=1)),
        np.repeat(np.arange(len(sides)), exists.sum(axis=1)),
    )


_Lines = tuple[Array, Ints, Ints]


def _lines_of_sides(
    distance: Array, cells: Cells, table: EdgeTable
) -> tuple[_Lines, Bools, Array, Array]:
    """Return the polynomials of all lines, and each side's row of them, direction and interval."""
    bounds = np.stack([cells.lower, cells.upper], axis=-1)
    value = bounds.reshape(-1, 4)
    # The parameter along the sides of fixed u is v, and the other way round.
    low = cells.lower[:, [1, 1, 0, 0]]
    high = cells.upper[:, [1, 1, 0, 0]]

    axis = np.broadcast_to([0, 0, 1, 1], value.shape)
    patch = np.broadcast_to(cells.patch[:, None], value.shape)
    on_edge = (value == 0.0) | (value == 1.0)
    side = 2 * axis + (value == 1.0)
    flipped = on_edge & table.reversed[patch, side]

    edge_count = len(table.sides)
    row = np.where(on_edge, table.edge[patch, side], -1)
    inner = ~on_edge
    lines = np.stack([patch[inner], axis[inner], value[inner]], axis=-1)
    # One number for each line: those of a patch lie much farther apart than its rounding.
    number = 2.0 * (2.0 * lines[:, 0] + lines[:, 1]) + lines[:, 2]
    _, first, place = np.unique(number, return_index=True, return_inverse=True)
    row[inner] = edge_count + place

    lines = _along_lines(distance, lines[first])
    coefficients = np.concatenate([_along_edges(distance, table), lines])
    sides = np.concatenate([table.sides, np.zeros(len(lines), dtype=np.int64)])
    return (coefficients, row, sides), flipped, low, high


def _along_edges(distance: Array, table: EdgeTable) -> Array:
    """Coefficients along each edge of the atlas, in the edge's own direction."""
    sides = sides_of(distance)
    sides = np.where(table.reversed[..., None], sides[..., ::-1], sides)
    result = np.ones((len(table.sides), distance.shape[1]))
    result[table.edge.ravel()] = sides.reshape(-1, distance.shape[1])
    return result


def _along_lines(distance: Array, lines: Array) -> Array:
    """Coefficients along the lines (patch, axis, value)."""
    patch, axis = lines[:, 0].astype(np.int64), lines[:, 1]
    weights = bernstein(distance.shape[1] - 1, lines[:, 2])[:, 0]
    nets = distance[patch]
    turned = np.where((axis == 0.0)[:, None, None], nets, nets.swapaxes(1, 2))
    return np.asarray(np.einsum("ki,kij->kj", weights, turned))
