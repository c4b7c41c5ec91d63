"""The search for the shortest path or loop: refine one, look for a shorter route, and refine it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.contact.solve import held_path
from bodymeasure.geodesic.across.pieces.cutting import cut_until_known
from bodymeasure.geodesic.across.pieces.error import LoopKind, route_length
from bodymeasure.geodesic.across.pieces.part import PathPart
from bodymeasure.geodesic.across.pieces.refine import RefinedPath, refine
from bodymeasure.geodesic.across.routes.route import Route, RouteKey
from bodymeasure.geodesic.across.search.repair import detours, other_loops, other_routes
from bodymeasure.geodesic.status import Status
from bodymeasure.trust import NEGLIGIBLE

# Degrees of the polynomial on each patch, tried in turn.
DEGREES = (8, 12, 16, 24, 32, 48, 72)
# The degree while a loop slides: its polynomials only have to show in which direction.
SLIDING = 3
# A path that has no good length at this degree, such as below a breast or through the crotch of a
# body, where patches bend sharply, is cut. Higher degrees are only for those that this does not
# help either.
ORDINARY = 32
# The relative error that is wanted for a length, and the one that is good enough if the last degree
# has not met it, as where patches bend sharply near a corner.
TOLERANCE, GOOD_ENOUGH = 1e-9, 1e-6
# Which edges hold a path is read off at degrees up to this: where it cannot be, it hardly can at
# higher ones.
HIGHEST_READ = 12
# The number of routes that are refined at most, for a path in all and for a loop at each degree:
# from the hip to the waist it takes some twenty.
MOST_ROUTES, MOST_LOOPS = 60, 400
# A route is better if its path is shorter by this part of it: smaller differences are errors of the
# trial space. One with fewer crossings is better if it is not longer by more than rounding.
SHORTER, ROUNDING = 1e-9, 1e-12
# Where a path runs along an edge it is no geodesic, and polynomials do not bend as sharply as it
# does. Its error is then estimated as this many times the largest difference of its lengths at the
# last three degrees.
CONTACT_SAFETY = 4.0
CONTACT_TOLERANCE = 1e-4
# A loop below this part of the length of the first one has contracted to a point.
COLLAPSED = 1e-3
NO_LOOP = (
    "the loop contracts to a point: it goes round no part of the body; choose one round the trunk "
    "or a limb"
)


@dataclass(frozen=True, eq=False)
class SearchResult:
    """The shortest path or loop that was found.

    Parameters
    ----------
    refined : RefinedPath
    part : PathPart
        The path itself; where edges hold it from all sides it consists of legs and arcs.
    kind : LoopKind or None
        None for a path with ends.
    status : Status
    """

    refined: RefinedPath
    part: PathPart
    kind: LoopKind | None
    status: Status


def shortest_along(atlas: Atlas, neighbors: Neighbors, route: Route, size: float) -> SearchResult:
    """Return the shortest path or loop along a route, or along others that it leads to.

    Parameters
    ----------
    atlas : Atlas
    neighbors : Neighbors
    route : Route
    size : float
        About the length of the path.

    Raises
    ------
    InputError
        If a loop contracts to a point.
    """
    if route.closed and not route.crossings:
        raise InputError(NO_LOOP)
    degrees = (SLIDING, *DEGREES) if route.closed else DEGREES
    # Between points on both sides of a seam and beside it, rounding is much of what is measured.
    negligible = NEGLIGIBLE * float(np.ptp(atlas.points, axis=0).max())
    best = refine(atlas, route, degrees[0], size)
    tried: set[RouteKey] = set()
    history: list[float] = []
    for degree in degrees:
        if degree > degrees[0]:
            best = refine(atlas, best.route, degree, size, best)
        # At a low degree, a loop may be shorter over a neighbor only because it consists of two
        # polynomials there. So routes of loops are tried again at the next degree.
        tried = {best.problem.route.key} if route.closed else tried | {route.key}
        best, missed, held = repaired(atlas, neighbors, best, tried)
        if route.closed and best.length < COLLAPSED * size:
            raise InputError(NO_LOOP)
        contact = _on_boundary(neighbors, best)
        if held is not None:
            kind, good = None, True
            break
        length, kind = route_length(best)
        length = replace(length, error=length.error + missed)
        if contact:
            # The formulas of the error hold for geodesics, which a path along an edge is not.
            changes = [abs(best.length - before) for before in history[-2:]]
            error = CONTACT_SAFETY * max(changes, default=np.inf)
            length = replace(length, correction=np.zeros(()), error=np.asarray(error))
            good = bool(error <= CONTACT_TOLERANCE * length.raw)
        else:
            most = GOOD_ENOUGH * max(float(length.raw), negligible)
            good = bool(length.trusted and length.error <= most)
        history.append(best.length)
        # Newton's method comes to rest on a saddle, too, but does not notice it, nor where the
        # parameters of so short a path have only a few digits.
        rests = best.minimum.converged or kind is LoopKind.SADDLE or length.raw < negligible
        good = bool(good and rests)
        enough = GOOD_ENOUGH * negligible if length.raw < negligible else TOLERANCE * length.raw
        exact = not contact and length.error <= enough
        if good and degree > SLIDING and (exact or degree >= ORDINARY):
            break
        if degree == ORDINARY and not (contact or route.closed):
            cut, known = cut_until_known(atlas, best, TOLERANCE)
            if cut.minimum.converged and known.is_known_to(GOOD_ENOUGH):
                best, length, good = cut, replace(known, error=known.error + missed), True
                break
    part = held or PathPart.of(best, length)
    if not good:
        status = Status.NOT_CONVERGED
    elif contact:
        status = Status.ON_BOUNDARY
    elif kind is LoopKind.SADDLE or (kind is None and not part.length.minimal):
        status = Status.NOT_A_MINIMUM
    else:
        status = Status.CONVERGED
    return SearchResult(best, part, kind, status)


def repaired(
    atlas: Atlas, neighbors: Neighbors, best: RefinedPath, tried: set[RouteKey]
) -> tuple[RefinedPath, float, PathPart | None]:
    """Try other routes as long as the path gets shorter.

    Parameters
    ----------
    atlas : Atlas
    neighbors : Neighbors
    best : RefinedPath
        The best path so far.
    tried : set of RouteKey
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
        improved = False
        for route in _wanted(atlas, neighbors, best):
            if isinstance(route, PathPart):
                return best, missed, route
            if route.closed and not route.crossings:
                raise InputError(NO_LOOP)
            most = MOST_LOOPS if route.closed else MOST_ROUTES
            if route.key in tried or len(tried) >= most:
                continue
            tried.add(route.key)
            other = refine(atlas, route, degree, best.problem.size)
            simpler = len(route.crossings) < len(best.problem.route.crossings)
            margin = 1.0 + ROUNDING if simpler else 1.0 - SHORTER
            if other.length < best.length * margin:
                best, improved, missed = other, True, 0.0
                break
            missed = max(missed, best.length - other.length)
    return best, missed, None


def _wanted(atlas: Atlas, neighbors: Neighbors, best: RefinedPath) -> Iterator[Route | PathPart]:
    """Routes that may be shorter, and among them the path itself where edges hold it."""
    if best.problem.route.closed:
        yield from other_loops(neighbors, best)
        return
    yield from other_routes(neighbors, best)
    if best.held_nodes.any() and best.problem.space.size <= HIGHEST_READ:
        held = held_path(atlas, neighbors, best, TOLERANCE)
        if held is not None:
            yield held
    yield from (best.route.replaced(*change) for change in detours(neighbors, best))


def _on_boundary(neighbors: Neighbors, refined: RefinedPath) -> bool:
    """Return whether an edge without a neighbor holds a path."""
    held, values = refined.held_nodes, refined.values[:, :, 1:-1]
    for piece, patch in enumerate(refined.problem.route.patches):
        for side, edge in enumerate(EDGES):
            axis = edge.fixed_axis
            here = held[piece, axis] & (values[piece, axis] == edge.fixed_value)
            if here.any() and not neighbors.over.get((patch, side)):
                return True
    return False
