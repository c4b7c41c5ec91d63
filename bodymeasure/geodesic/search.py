"""When to look further than a method does from the straight line, and what to make of it.

Newton's method from the straight line in (u, v) finds *a* geodesic. It may leave the patch, pass a
conjugate point, or be longer than one elsewhere. `shortest_path` looks for the shortest inside the
patch; the settings say for which problems:

- ``straight``: for none.
- ``quick``: for those where the method failed: no convergence, a path outside the patch, no local
  minimum. On bodies this finds what a thorough search does.
- ``thorough``: for all. On random patches of the paper's kind, the quick search misses a shorter
  path on some in a thousand, on patches that are symmetric about the path on many.

No search proves that there is no shorter path still.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from bodymeasure.geodesic.method import MethodResult, Piece
from bodymeasure.geodesic.polish import OUTSIDE
from bodymeasure.geodesic.shortest import EDGES, Known, shortest_paths
from bodymeasure.geodesic.surface import Surface

_Array = NDArray[np.float64]

Search = Literal["quick", "thorough", "straight"]
SEARCHES: tuple[Search, ...] = get_args(Search)

# Problems that are searched at once, which bounds the memory.
CHUNK = 128


def search_further(
    surface: Surface,
    ends: tuple[_Array, _Array],
    result: MethodResult,
    search: Search,
    tolerance: float,
) -> MethodResult:
    """What a method found, with shorter paths and paths inside the patch put in.

    Parameters
    ----------
    surface : Surface
    ends : tuple of ndarray
        Start and end, both of shape (problems, 2).
    result : MethodResult
    search : {"quick", "thorough", "straight"}
    tolerance : float
        Relative error asked for.
    """
    if search == "straight":
        return result
    count = len(ends[0])
    good = np.zeros(count, bool)
    place = np.empty((2, count), np.int64)
    for number, piece in enumerate(result.pieces):
        good[piece.problems] = piece.converged & piece.measured.minimal & ~is_outside(piece)
        place[0, piece.problems] = number
        place[1, piece.problems] = np.arange(len(piece.problems))
    again = np.flatnonzero(~good if search == "quick" else np.ones_like(good))
    doubtful, replaced = np.zeros(count, bool), np.zeros(count, bool)
    shorter: list[Piece] = []
    for first in range(0, len(again), CHUNK):
        chunk = again[first : first + CHUNK]
        own = _taken(result, place[:, chunk])
        known = _known(own, good[chunk])
        found = shortest_paths(surface.take(chunk), np.stack(ends)[:, chunk], known, tolerance)
        shorter += [piece.renumbered(chunk[piece.problems]) for piece in found.pieces]
        doubtful[chunk] = found.doubtful
    for piece in shorter:
        replaced[piece.problems] = True
    kept = [piece.take(np.flatnonzero(~replaced[piece.problems])) for piece in result.pieces]
    pieces = (
        replace(piece, converged=piece.converged & ~doubtful[piece.problems])
        for piece in [*kept, *shorter]
        if len(piece.problems)
    )
    return MethodResult(tuple(pieces), result.iterations)


def is_outside(piece: Piece) -> NDArray[np.bool_]:
    """Which paths leave their patch. Of those along edges, each leg was looked at by itself."""
    if piece.contacts:
        return np.zeros(len(piece.problems), bool)
    return piece.space.leaves_patch(piece.values, OUTSIDE)


def _taken(result: MethodResult, place: NDArray[np.int64]) -> list[Piece]:
    """The paths of some problems, given by their pieces and rows, numbered anew."""
    numbers, rows = place
    return [
        result.pieces[number]
        .take(rows[numbers == number])
        .renumbered(np.flatnonzero(numbers == number))
        for number in np.unique(numbers)
    ]


def _known(pieces: list[Piece], good: NDArray[np.bool_]) -> Known:
    """Paths as the search wants them, and the lengths of those that are good."""
    times = np.linspace(0.0, 1.0, EDGES + 1)
    points, length = np.empty((len(good), EDGES + 1, 2)), np.empty(len(good))
    for piece in pieces:
        points[piece.problems] = piece.points(times)
        length[piece.problems] = piece.measured.corrected
    return Known(points, np.where(good, length, np.inf))
