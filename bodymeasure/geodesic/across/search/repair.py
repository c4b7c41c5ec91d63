"""The repair of a path or loop: other routes are tried as long as that makes it shorter."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.contact.solve import held_path
from bodymeasure.geodesic.across.pieces.budget import Budget
from bodymeasure.geodesic.across.pieces.part import PathPart
from bodymeasure.geodesic.across.pieces.refine import RefinedPath, refine
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.search.other_routes import (
    SLIDING,
    detours,
    other_loops,
    other_routes,
)
from bodymeasure.geodesic.across.search.simpler import ROUNDING, simplified
from bodymeasure.geodesic.across.search.tried import TriedRoutes

# The relative error that is wanted for a length.
TOLERANCE = 1e-9
# Which edges hold a path is read off at degrees up to this: where it cannot be, it hardly can at
# higher ones.
HIGHEST_READ = 12
# A route is better if its path is shorter by this part of it: smaller differences are errors of the
# trial space, which are smaller from a degree on. One with fewer crossings is better if it is not
# longer by more than `ROUNDING`.
SHORTER, FINE, SHORTER_FINE = 1e-9, 16, 1e-11
NO_LOOP = (
    "the loop contracts to a point: it goes round no part of the body; choose one round the trunk "
    "or a limb"
)


class Search(NamedTuple):
    """The data that all steps of a search need: `size` is about the length of the path."""

    atlas: Atlas
    neighbors: Neighbors
    size: float
    budget: Budget

    def refined(
        self,
        route: Route,
        degree: int,
        before: RefinedPath | None = None,
        most: float = np.inf,
    ) -> RefinedPath:
        """Return the path along a route, exact if it may be no longer than `most`.

        The work is counted.
        """
        sharp = not route.closed or degree > SLIDING
        result = refine(self.atlas, route, degree, self.size, before, sharp=sharp, most=most)
        self.budget.spend(result)
        return result


def repaired(
    search: Search, best: RefinedPath, tried: TriedRoutes
) -> tuple[RefinedPath, float, PathPart | None]:
    """Try other routes as long as the path gets shorter.

    Parameters
    ----------
    search : Search
    best : RefinedPath
        The best path so far.
    tried : TriedRoutes
        Routes that are not tried again; those that are tried are added.

    Returns
    -------
    best : RefinedPath
        The best path now.
    missed : float
        The largest amount by which another path was shorter, but not by enough to be better.
    held : PathPart or None
        The path of legs and arcs, if edges hold it from all sides, so that it needs no neighbor.
    """
    degree, missed, improved = best.problem.space.size, 0.0, True
    while improved:
        improved, best = False, simplified(best, search.budget)
        if tried.joins(best):
            break
        for route in _wanted(search, best):
            if isinstance(route, PathPart):
                return best, missed, route
            if route.closed and not route.crossings:
                raise InputError(NO_LOOP)
            if route in tried:
                continue
            if search.budget.has_run_out():
                return best, missed, None
            simpler = len(route.crossings) < len(best.problem.route.crossings)
            least = SHORTER_FINE if degree >= FINE and not route.closed else SHORTER
            margin = 1.0 + ROUNDING if simpler else 1.0 - least
            other = search.refined(route, degree, most=best.length * max(margin, 1.0))
            tried.add(route, other.route)
            if other.length < best.length * margin:
                best, improved, missed = other, True, 0.0
                break
            missed = max(missed, best.length - other.length)
    return best, missed, None


def _wanted(search: Search, best: RefinedPath) -> Iterator[Route | PathPart]:
    """Routes that may be shorter, and among them the path itself where edges hold it."""
    atlas, neighbors = search.atlas, search.neighbors
    if best.problem.route.closed:
        yield from other_loops(neighbors, best)
        return
    yield from other_routes(neighbors, best)
    if best.held_nodes.any() and best.problem.space.size <= HIGHEST_READ:
        held = held_path(atlas, neighbors, best, TOLERANCE, search.budget)
        if held is not None:
            yield held
    yield from (best.route.replaced(*change) for change in detours(neighbors, best))
