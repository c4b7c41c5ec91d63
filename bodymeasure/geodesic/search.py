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

from bodymeasure.geodesic.contact import ContactPath
from bodymeasure.geodesic.method import MethodResult, Piece
from bodymeasure.geodesic.polynomial_space import polynomial_space
from bodymeasure.geodesic.shortest import shortest_path
from bodymeasure.geodesic.surface import Surface

_Array = NDArray[np.float64]

Search = Literal["quick", "thorough", "straight"]
SEARCHES: tuple[Search, ...] = get_args(Search)

# A path is outside its patch if it is so by more than this in u or v: more than rounding errors of
# a path along the edge, less than anything that could be measured.
OUTSIDE = 1e-9
# Degrees of the free pieces' trial spaces, tried in turn. Strongly bent ones take the highest.
DEGREES = (12, 20, 32, 48, 72)
# A path that was found must be shorter than the method's own by this part to be taken instead.
SHORTER = 1e-8
# A polygon of the search is shorter than the path it stands for by some thousandths; by more than
# this part it stands for another.
MISSED = 0.01
# Points of the method's own path that the search starts from, among others.
KNOWN_POINTS = 65


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
    spaces = [polynomial_space(degree) for degree in DEGREES]
    times = np.linspace(0.0, 1.0, KNOWN_POINTS)
    pieces: list[Piece] = []
    for piece in result.pieces:
        good = piece.converged & piece.measured.minimal & ~is_outside(piece)
        again = np.flatnonzero(~good if search == "quick" else np.ones_like(good))
        if len(again) == 0:
            pieces.append(piece)
            continue
        replaced = np.zeros(len(good), bool)
        converged = piece.converged.copy()
        paths = piece.take(again).points(times)
        for row, known in zip(again, paths, strict=True):
            problem = piece.problems[row : row + 1]
            start, end = (points[problem[0]] for points in ends)
            found = shortest_path(surface.take(problem), start, end, [known], spaces, tolerance)
            if found.path is None:
                # A shorter way that could not be made exact: the method's own is not the shortest.
                converged[row] &= found.polygon >= (1.0 - MISSED) * _length(piece, row)
            elif not (good[row] and _length(piece, row) <= _bound(found.path)):
                replaced[row] = True
                pieces.append(_as_piece(problem, found.path))
        kept = replace(piece, converged=converged)
        pieces.append(kept.take(np.flatnonzero(~replaced)))
    return MethodResult(tuple(p for p in pieces if len(p.problems)), result.iterations)


def is_outside(piece: Piece) -> NDArray[np.bool_]:
    """Which paths leave their patch."""
    return piece.space.leaves_patch(piece.values, OUTSIDE)


def _length(piece: Piece, row: np.integer) -> float:
    return float(piece.measured.corrected[row])


def _bound(found: ContactPath) -> float:
    return float(found.measured.corrected[0]) * (1.0 + SHORTER)


def _as_piece(problem: NDArray[np.int64], found: ContactPath) -> Piece:
    return Piece(
        problems=problem,
        space=found.space,
        values=found.values[None],
        measured=found.measured,
        converged=np.ones(1, bool),
        singular=np.zeros(1, bool),
        contacts=found.contacts,
    )
