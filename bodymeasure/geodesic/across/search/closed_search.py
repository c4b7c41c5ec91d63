"""From a first loop to the shortest one that it contracts to."""

from dataclasses import dataclass

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.geodesic.across.pieces.closed_error import LoopKind, LoopLength, loop_length
from bodymeasure.geodesic.across.pieces.closed_refine import RefinedLoop, refine_loop
from bodymeasure.geodesic.across.routes.route import Route, RouteKey
from bodymeasure.geodesic.across.search.closed_repair import other_loops
from bodymeasure.geodesic.across.search.route_search import (
    CONTACT_SAFETY,
    CONTACT_TOLERANCE,
    DEGREES,
    GOOD_ENOUGH,
    ROUNDING,
    SHORTER,
    TOLERANCE,
)

# Of the polynomials on each patch while the loop slides: they only have to tell which way.
SLIDING = 3
# Routes that are refined for a loop, at most: from the hip to the waist it takes some twenty.
MOST_ROUTES = 400
# Of the first loop's length: one so short has contracted to a point.
COLLAPSED = 1e-3


@dataclass(frozen=True, eq=False)
class FoundLoop:
    """The loop that was found.

    Parameters
    ----------
    refined : RefinedLoop
    length : LoopLength
    contact : bool
        Whether an edge of the atlas holds it for a part.
    good : bool
        Whether its length is known.
    """

    refined: RefinedLoop
    length: LoopLength
    contact: bool
    good: bool


def contracted(atlas: Atlas, neighbors: Neighbors, route: Route, size: float) -> FoundLoop | None:
    """The shortest loop that a route contracts to; None if that is a point.

    Parameters
    ----------
    atlas : Atlas
    neighbors : Neighbors
    route : Route
    size : float
        About the length of the loop.
    """
    best = refine_loop(atlas, route, SLIDING, size)
    history: list[float] = []
    for degree in (SLIDING, *DEGREES):
        if degree > SLIDING:
            best = refine_loop(atlas, best.route, degree, size, best)
        repaired, missed = _repaired(atlas, neighbors, best)
        if repaired is None or repaired.length < COLLAPSED * size:
            return None
        best = repaired
        length, contact = loop_length(best), _on_boundary(neighbors, best)
        length = length._replace(error=length.error + missed)
        if contact:
            # The formulas hold for geodesics, which a loop along an edge is not.
            changes = [abs(best.length - before) for before in history[-2:]]
            error = CONTACT_SAFETY * max(changes, default=float("inf"))
            length = length._replace(corrected=length.raw, error=error)
            good = error <= CONTACT_TOLERANCE * length.raw
        else:
            good = length.trusted and length.error <= GOOD_ENOUGH * length.raw
        history.append(best.length)
        # Newton's method comes to rest on a saddle, too, but cannot tell that it has.
        good = good and (best.minimum.converged or length.kind is LoopKind.SADDLE)
        if degree > SLIDING and good and not contact and length.error <= TOLERANCE * length.raw:
            break
    return FoundLoop(best, length, contact, good)


def _repaired(
    atlas: Atlas, neighbors: Neighbors, best: RefinedLoop
) -> tuple[RefinedLoop | None, float]:
    """The best along any route that a loop asks for, and those ask for, as long as it gets shorter.

    What was tried is remembered, but for the next degree: polynomials of a low one may be shorter
    over a neighbor only because they are two there. Also by how much a route was shorter that was
    not better by enough. None if nothing is left to cross.
    """
    degree, missed = best.problem.space.size, 0.0
    tried: set[RouteKey] = {best.route.key}
    improved = True
    while improved:
        improved = False
        for route in other_loops(neighbors, best):
            if not route.crossings:
                return None, 0.0
            if route.key in tried or len(tried) >= MOST_ROUTES:
                continue
            tried.add(route.key)
            other = refine_loop(atlas, route, degree, best.problem.size)
            simpler = len(route.crossings) < len(best.route.crossings)
            margin = 1.0 + ROUNDING if simpler else 1.0 - SHORTER
            if other.length < best.length * margin:
                best, improved, missed = other, True, 0.0
                break
            missed = max(missed, best.length - other.length)
    return best, missed


def _on_boundary(neighbors: Neighbors, loop: RefinedLoop) -> bool:
    """Whether an edge without a neighbor holds a loop."""
    held, values = loop.held_nodes, loop.values[:, :, 1:-1]
    for piece, patch in enumerate(loop.route.patches):
        for side, edge in enumerate(EDGES):
            axis = edge.fixed_axis
            here = held[piece, axis] & (values[piece, axis] == edge.fixed_value)
            if here.any() and not neighbors.over.get((patch, side)):
                return True
    return False
