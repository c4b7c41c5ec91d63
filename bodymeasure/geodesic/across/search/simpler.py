"""Paths without pieces of no length that lead over a seam and back."""

from dataclasses import replace

import numpy as np

from bodymeasure.geodesic.across.pieces.budget import Budget
from bodymeasure.geodesic.across.pieces.refine import RefinedPath, refine

# A piece of less than this part of the path is empty.
EMPTY = 1e-4
# A path with fewer crossings is better if it is not longer by more than this part.
ROUNDING = 1e-12


def simplified(best: RefinedPath, budget: Budget) -> RefinedPath:
    """Return a path without its empty pieces that only change sides of a seam."""
    while not budget.has_run_out():
        simpler = _without_empty_return(best)
        if simpler is None:
            break
        budget.spend(simpler)
        if simpler.length > best.length * (1.0 + ROUNDING):
            break
        best = simpler
    return best


def _without_empty_return(refined: RefinedPath) -> RefinedPath | None:
    """Return a path without two empty pieces by which it changes sides of a seam back and forth.

    Its course is the same, so that it is found from where it is, not from straight lines, from
    which another path along the shorter route may be nearer. None if there are no such pieces.
    """
    route = refined.route
    if route.closed:
        return None
    empty = refined.lengths < EMPTY * refined.lengths.sum()
    for piece in range(1, len(route.crossings)):
        enter, leave = route.crossings[piece - 1 : piece + 1]
        returns = enter.edge == leave.edge and route.patches[piece - 1] == leave.to_patch
        if returns and empty[piece] and (empty[piece - 1] or empty[piece + 1]):
            left_out = [piece, piece - 1 if empty[piece - 1] else piece + 1]
            shorter = route.replaced(piece - 1, piece + 1)
            before = replace(refined, values=np.delete(refined.values, left_out, axis=0))
            problem = refined.problem
            return refine(problem.atlas, shorter, problem.space, problem.size, before)
    return None
