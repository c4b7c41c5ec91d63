"""The search for the shortest path or loop: refine one, look for a shorter route, and refine it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.pieces.budget import LOOP, PATH, Budget
from bodymeasure.geodesic.across.pieces.cutting import cut_until_known
from bodymeasure.geodesic.across.pieces.error import LoopKind, route_length
from bodymeasure.geodesic.across.pieces.part import PathPart
from bodymeasure.geodesic.across.pieces.refine import RefinedPath
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.routes.topology import extent
from bodymeasure.geodesic.across.search.off_saddle import beside_saddle
from bodymeasure.geodesic.across.search.other_routes import SLIDING
from bodymeasure.geodesic.across.search.repair import NO_LOOP, TOLERANCE, Search, repaired
from bodymeasure.geodesic.across.search.tried import PassedPaths, TriedRoutes
from bodymeasure.geodesic.status import Status
from bodymeasure.trust import NEGLIGIBLE

# Degrees of the polynomial on each patch, tried in turn.
DEGREES = (8, 12, 16, 24, 32, 48, 72)
# A path whose last coefficients at the first degree are larger than this part of it is hardly ever
# exact there: what its length is worth is only estimated at the next degree.
ROUGH = 2e-6
# The last degree at which a path is refined for which no budget is left.
LAST_OVERDRAWN = 16
# Routes of loops and round corners are tried again up to this degree: beyond it the few steps that
# so many unknowns are given do not bring a path that starts as straight lines to rest.
LAST_TRIED_AGAIN = 16
# A path that has no good length at this degree, such as below a breast or through the crotch of a
# body, where patches bend sharply, is cut. Higher degrees are only for those that this does not
# help either.
ORDINARY = 32
# The relative error that is good enough if the last degree has not met the one that is wanted, as
# where patches bend sharply near a corner.
GOOD_ENOUGH = 1e-6
# An error that a higher degree leaves above this part of itself stays.
STALLS = 0.5
# A route whose path is longer by this part than the shortest so far is not repaired: that makes a
# path shorter by less.
HOPELESS = 5e-3
# Paths that are longer at the lowest degree by up to this part of the shortest may be shorter yet,
# but not one that is within rounding of another: mostly it is the same. So many are taken further.
CLOSE, SAME, MOST_RIVALS = 1e-4, 1e-9, 3
# Where a path runs along an edge it is no geodesic, and polynomials do not bend as sharply as it
# does. Its error is then estimated as this many times the largest difference of its lengths at the
# last three degrees.
CONTACT_SAFETY = 4.0
CONTACT_TOLERANCE = 1e-4
# A loop below this part of the length of the first one has contracted to a point.
COLLAPSED = 1e-3


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


def shortest_along(
    atlas: Atlas,
    neighbors: Neighbors,
    routes: Sequence[Route],
    size: float,
    budget: Budget | None = None,
) -> SearchResult:
    """Return the shortest path or loop along one of several routes, or along others beside them.

    All routes are refined and repaired at the lowest degree. The shortest path goes on to higher
    degrees, and so do those that may yet turn out to be shorter.

    Parameters
    ----------
    atlas : Atlas
    neighbors : Neighbors
    routes : sequence of Route
        At least one; the likeliest first.
    size : float
        About the length of the path.
    budget : Budget, optional
        What the search may take; as much as any may if not given.

    Raises
    ------
    InputError
        If a loop contracts to a point.
    """
    closed = routes[0].closed
    if closed and not all(route.crossings for route in routes):
        raise InputError(NO_LOOP)
    search = Search(atlas, neighbors, size, budget or Budget(LOOP if closed else PATH))
    begun: list[_Begun] = []
    passed = PassedPaths()
    for route in routes:
        if begun and search.budget.has_run_out():
            break
        shortest = min((other.best.length for other in begun), default=np.inf)
        first = _begun(search, route, shortest, passed)
        if first is not None:
            begun.append(first)
    found: list[SearchResult] = []
    for rival in _rivals(begun):
        if not found or not search.budget.has_run_out():
            found.append(_along(search, rival))
    best = min(found, key=_preference)
    if best.status is Status.NOT_A_MINIMUM and not closed:
        return min((best, *_beside(search, best)), key=_preference)
    return best


class _Begun(NamedTuple):
    """A path at the lowest degree, the routes that were tried, and the rest as in `repaired`."""

    best: RefinedPath
    tried: TriedRoutes
    missed: float
    held: PathPart | None


def _begun(search: Search, route: Route, shortest: float, passed: PassedPaths) -> _Begun | None:
    """Begin a search along a route.

    None if its path is plainly longer than the shortest, or comes to one that is passed already.
    """
    best = search.refined(route, SLIDING if route.closed else DEGREES[0])
    if best.length > (1.0 + HOPELESS) * shortest:
        return None
    tried = TriedRoutes((route, best.route), passed)
    best, missed, held = repaired(search, best, tried)
    # At higher degrees no search joins another.
    tried.passed = None
    return None if tried.has_joined else _Begun(best, tried, missed, held)


def _rivals(begun: Sequence[_Begun]) -> list[_Begun]:
    """The paths of which each may be the shortest; those that are as good as one are left out."""
    ordered = sorted(begun, key=lambda each: each.best.length)
    result = ordered[:1]
    for each in ordered[1:]:
        length = each.best.length
        apart = min(length - other.best.length for other in result)
        if SAME * length < apart and length <= (1.0 + CLOSE) * result[0].best.length:
            result.append(each)
    return result[:MOST_RIVALS]


def _preference(found: SearchResult) -> tuple[bool, float]:
    """A key by which results with a length come first, then the shorter ones."""
    return not found.status.has_length, float(found.part.length.corrected)


def _beside(search: Search, saddle: SearchResult) -> Iterator[SearchResult]:
    """Yield what searches on both sides of a saddle find."""
    for refined in beside_saddle(saddle.refined):
        if search.budget.has_run_out():
            return
        search.budget.spend(refined)
        tried = TriedRoutes((refined.route,))
        best, missed, held = repaired(search, refined, tried)
        yield _along(search, _Begun(best, tried, missed, held))


def _along(search: Search, begun: _Begun) -> SearchResult:
    """Return the result of a search that has begun, at the degree that its path needs."""
    best, tried, missed, held = begun
    neighbors, closed = search.neighbors, best.problem.route.closed
    degrees = (SLIDING, *DEGREES) if closed else DEGREES
    # Between points on both sides of a seam and beside it, rounding is much of what is measured.
    negligible = NEGLIGIBLE * extent(search.atlas)
    history: list[float] = []
    errors, is_cut = [np.inf], False
    good = False
    for degree in degrees:
        if degree > degrees[0]:
            overdrawn = search.budget.left <= 0.0 and degree > LAST_OVERDRAWN
            if overdrawn or search.budget.is_overdrawn():
                # A length that is good enough does not need the next degree.
                search.budget.cut_short |= not good
                break
            best = search.refined(best.route, degree, best)
            # At a low degree, a loop may be shorter over a neighbor only because it consists of two
            # polynomials there, and a path through a corner as short as those that pass it. So
            # routes of loops and round corners are tried again at the next degree.
            through_corner = bool((best.lengths[1:-1] == 0.0).any())
            if degree <= LAST_TRIED_AGAIN and (closed or through_corner):
                tried = TriedRoutes((best.route,))
            best, missed, held = repaired(search, best, tried)
        if closed and best.length < COLLAPSED * search.size:
            raise InputError(NO_LOOP)
        contact = _on_boundary(neighbors, best)
        if held is not None:
            kind, good = None, True
            break
        history.append(best.length)
        if degree <= DEGREES[0] and _is_rough(best) and not search.budget.is_overdrawn():
            continue
        length, kind = route_length(best)
        length = replace(length, error=length.error + missed)
        if contact:
            # The formulas of the error hold for geodesics, which a path along an edge is not.
            changes = [abs(best.length - before) for before in history[-3:-1]]
            error = CONTACT_SAFETY * max(changes, default=np.inf)
            length = replace(length, correction=np.zeros(()), error=np.asarray(error))
            good = bool(error <= CONTACT_TOLERANCE * length.raw)
        else:
            most = GOOD_ENOUGH * max(float(length.raw), negligible)
            good = bool(length.trusted and length.error <= most)
        # Newton's method comes to rest on a saddle, too, but does not notice it, nor where the
        # parameters of so short a path have only a few digits.
        rests = best.minimum.converged or kind is LoopKind.SADDLE or length.raw < negligible
        good = bool(good and rests)
        enough = GOOD_ENOUGH * negligible if length.raw < negligible else TOLERANCE * length.raw
        exact = not contact and length.error <= enough
        if good and degree > SLIDING and (exact or degree >= ORDINARY):
            break
        # At a fold a higher degree hardly helps; and where no budget is left, it is cuts that may.
        stalls = not length.error <= STALLS * errors[-1] or search.budget.left <= 0.0
        errors.append(float(length.error))
        hopeless = degree == ORDINARY or (degree >= LAST_OVERDRAWN and stalls)
        if hopeless and not (is_cut or contact or closed):
            is_cut = True
            cut, known = cut_until_known(search.atlas, best, TOLERANCE, search.budget)
            if cut.minimum.converged and known.is_known_to(GOOD_ENOUGH):
                best, length, good = cut, replace(known, error=known.error + missed), True
                break
    part = held or PathPart.of(best, length)
    if not good:
        status = Status.OUT_OF_BUDGET if search.budget.cut_short else Status.NOT_CONVERGED
    elif kind is LoopKind.SADDLE or not (contact or kind is not None or part.length.minimal):
        status = Status.NOT_A_MINIMUM
    elif search.budget.cut_short:
        status = Status.CUT_SHORT
    else:
        status = Status.ON_BOUNDARY if contact else Status.CONVERGED
    return SearchResult(best, part, kind, status)


def _is_rough(path: RefinedPath) -> bool:
    """Return whether polynomials of their degree hardly follow a path."""
    last = path.problem.space.functions.coefficients[0, -2:, :, -1].astype(np.float64)
    most = np.abs(path.values @ last.T).max(axis=(1, 2))
    return bool((most * path.lengths).max() > ROUGH * path.lengths.sum())


def _on_boundary(neighbors: Neighbors, refined: RefinedPath) -> bool:
    """Return whether an edge without a neighbor holds a path."""
    held, values = refined.held_nodes, refined.values[:, :, 1:-1]
    if not held.any():
        return False
    for piece, patch in enumerate(refined.problem.route.patches):
        for side, edge in enumerate(EDGES):
            axis = edge.fixed_axis
            here = held[piece, axis] & (values[piece, axis] == edge.fixed_value)
            if here.any() and not neighbors.over.get((patch, side)):
                return True
    return False
