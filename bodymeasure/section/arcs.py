"""Arcs of a section, each the graph of a function in one rectangle, and chains of them."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Bools, Ints
from bodymeasure.section.cells import Cells
from bodymeasure.section.crossings import Crossings
from bodymeasure.section.pieces import Pieces


class Arcs(NamedTuple):
    """Arcs of a section, which have no point but their ends in common.

    Parameters
    ----------
    pieces : Pieces
        One piece for each of k arcs.
    ends : ndarray of int, shape (k, 2)
        Numbers of the crossings at both ends.
    """

    pieces: Pieces
    ends: Ints


class Chain(NamedTuple):
    """Arcs in the order in which they follow one another.

    Parameters
    ----------
    arc : ndarray of int, shape (k,)
    backwards : ndarray of bool, shape (k,)
        Whether an arc is run from its stop to its start.
    closed : bool
    """

    arc: Ints
    backwards: Bools
    closed: bool


def pair_crossings(cells: Cells, crossings: Crossings) -> Arcs | None:
    """Join the crossings of each rectangle; None where rounding leaves one without a partner.

    A section that is a graph in a rectangle enters and leaves it by turns.
    """
    count = len(cells.patch)
    place = crossings.along.copy()
    # On two sides the graph's own parameter varies along the side; on the other two it is constant.
    over_u = cells.axis == 0
    place[over_u, 0], place[over_u, 1] = cells.lower[over_u, :1], cells.upper[over_u, :1]
    place[~over_u, 2], place[~over_u, 3] = cells.lower[~over_u, 1:], cells.upper[~over_u, 1:]
    # Each of the four sides has at most as many crossings as the degree.
    most = 4 * place.shape[-1]
    number = crossings.number.reshape(count, most)
    flat = np.where(number >= 0, place.reshape(count, most), np.inf)
    found = (number >= 0).sum(axis=1)
    if (found % 2).any():
        return None

    order = np.argsort(flat, axis=1, kind="stable")
    places = np.take_along_axis(flat, order, axis=1).reshape(count, most // 2, 2)
    numbers = np.take_along_axis(number, order, axis=1).reshape(count, most // 2, 2)
    cell, pair = np.nonzero(numbers[..., 0] >= 0)
    axis = cells.axis[cell]
    pieces = Pieces(
        cells.patch[cell],
        axis,
        places[cell, pair, 0],
        places[cell, pair, 1],
        cells.lower[cell, 1 - axis],
        cells.upper[cell, 1 - axis],
    )
    return Arcs(pieces, numbers[cell, pair])


def chain_arcs(arcs: Arcs, sides: Ints) -> list[Chain] | None:
    """Follow arcs from crossing to crossing; None if some crossing joins too many or too few.

    Parameters
    ----------
    arcs : Arcs
    sides : ndarray of int, shape (crossings,)
        The `sides` of `Crossings`; two arcs meet everywhere but on edges with one side, where they
        end.
    """
    # Crossings on edges of patches that the section does not enter do not belong to it.
    meeting = np.bincount(arcs.ends.ravel(), minlength=len(sides))
    if (meeting != np.where(sides == 1, 1, 2))[meeting > 0].any():
        return None
    order = np.argsort(arcs.ends.ravel(), kind="stable")
    first = np.concatenate([[0], np.cumsum(meeting)])
    at = [order[first[i] : first[i + 1]].tolist() for i in range(len(sides))]
    ends = arcs.ends.tolist()
    used = np.zeros(len(ends), dtype=np.bool_)

    def follow(end: int) -> list[int]:
        """Return the ends (2 arc + side) at which arc after arc is entered, from a first one."""
        entered = []
        while not used[end // 2]:
            used[end // 2] = True
            entered.append(end)
            leaving = end ^ 1
            others = [e for e in at[ends[leaving // 2][leaving % 2]] if e != leaving]
            if not others:
                break
            end = others[0]
        return entered

    open_ends = [e for e in range(2 * len(ends)) if len(at[ends[e // 2][e % 2]]) == 1]
    chains = [_chain(follow(e), closed=False) for e in open_ends if not used[e // 2]]
    chains += [_chain(follow(2 * a), closed=True) for a in range(len(ends)) if not used[a]]
    return chains


def _chain(entered: list[int], *, closed: bool) -> Chain:
    ends = np.array(entered)
    return Chain(ends // 2, ends % 2 == 1, closed)
