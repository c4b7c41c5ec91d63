"""From a first route to the shortest path: refine, look for a shorter route, refine again."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.geodesic.across.contact.joined import HeldPath
from bodymeasure.geodesic.across.contact.solve import held_path
from bodymeasure.geodesic.across.pieces.route_error import RouteLength, route_length
from bodymeasure.geodesic.across.pieces.route_refine import Refined, refine
from bodymeasure.geodesic.across.routes.route import Route, RouteKey
from bodymeasure.geodesic.across.search.route_repair import other_routes, over_missing_neighbors

# Of the polynomial on each patch, tried in turn.
DEGREES = (8, 12, 16, 24, 32, 48, 72)
# Beyond this, only for paths that have no length yet, such as through the crotch of a body, where
# patches bend sharply.
ORDINARY = 32
# Relative error of the length that is asked for, and what is good enough if the last degree has not
# met it, as where patches bend sharply near a corner.
TOLERANCE, GOOD_ENOUGH = 1e-9, 1e-6
# What holds a path is read at degrees up to this: where it cannot be, it hardly can at higher ones.
HIGHEST_READ = 12
# Routes that are refined for a path, at most.
MOST_ROUTES = 60
# A route must be shorter by this part to be better: less is the trial space's. One with fewer
# crossings is better if it is not longer by more than rounding.
SHORTER, ROUNDING = 1e-9, 1e-12
# Where a path runs along an edge, it is no geodesic, and its error is told by the last three
# degrees: the polynomials do not bend as sharply as it does, and this many times their largest
# difference is left.
CONTACT_SAFETY = 4.0
CONTACT_TOLERANCE = 1e-4


@dataclass(frozen=True, eq=False)
class Found:
    """The shortest path that was found.

    Parameters
    ----------
    refined : Refined
    length : RouteLength
    contact : bool
        Whether an edge of the atlas holds it for a part.
    good : bool
        Whether its length is known.
    routes : int
        How many were refined.
    held : HeldPath, optional
        The path of legs and arcs, where edges hold it from all sides; `length` is then its own.
    """

    refined: Refined
    length: RouteLength
    contact: bool
    good: bool
    routes: int
    held: HeldPath | None = None


def shortest_along(atlas: Atlas, neighbors: Neighbors, route: Route, size: float) -> Found:
    """The shortest path along a route, or along those that it asks for.

    Parameters
    ----------
    atlas : Atlas
    neighbors : Neighbors
    route : Route
    size : float
        About the length of the path.
    """
    tried: set[RouteKey] = {route.key}
    best = refine(atlas, route, DEGREES[0], size)
    history: list[float] = []
    for degree in DEGREES:
        if degree > DEGREES[0]:
            best = refine(atlas, best.route, degree, size, best)
        best, missed, held = _repaired(atlas, neighbors, best, tried)
        contact = _on_boundary(neighbors, best)
        if held is not None:
            return Found(best, held.length, contact, True, len(tried), held)
        length = route_length(best)
        length = length._replace(error=length.error + missed)
        if contact:
            # The formulas hold for geodesics, which a path along an edge is not.
            changes = [abs(best.length - before) for before in history[-2:]]
            error = CONTACT_SAFETY * max(changes, default=np.inf)
            length = length._replace(corrected=length.raw, error=error)
            good = error <= CONTACT_TOLERANCE * length.raw
        else:
            good = length.trusted and length.error <= GOOD_ENOUGH * length.raw
        history.append(best.length)
        good = good and best.minimum.converged
        exact = not contact and length.error <= TOLERANCE * length.raw
        if good and (exact or degree >= ORDINARY):
            break
    return Found(best, length, contact, good, len(tried))


def _repaired(
    atlas: Atlas, neighbors: Neighbors, best: Refined, tried: set[RouteKey]
) -> tuple[Refined, float, HeldPath | None]:
    """The best along any route that a path asks for, and those ask for, as long as it gets shorter.

    What was tried is remembered, over all degrees. Also by how much a route was shorter that was
    not better by enough; and the path of legs and arcs, if edges hold it from all sides, so that it
    asks for no neighbor.
    """
    degree, missed, held = best.problem.space.size, 0.0, None
    improved = True
    while improved:
        improved = False
        for route in _wanted(atlas, neighbors, best):
            if isinstance(route, HeldPath):
                held = route
                break
            if route.key in tried or len(tried) >= MOST_ROUTES:
                continue
            tried.add(route.key)
            other = refine(atlas, route, degree, best.problem.size)
            simpler = len(route.crossings) < len(best.problem.route.crossings)
            margin = 1.0 + ROUNDING if simpler else 1.0 - SHORTER
            if other.length < best.length * margin:
                best, improved, missed = other, True, 0.0
                break
            missed = max(missed, best.length - other.length)
    return best, missed, held


def _wanted(atlas: Atlas, neighbors: Neighbors, best: Refined) -> Iterator[Route | HeldPath]:
    """Routes that may be shorter, and between them the path itself where edges hold it."""
    yield from other_routes(neighbors, best)
    if best.held_nodes.any() and best.problem.space.size <= HIGHEST_READ:
        held = held_path(atlas, neighbors, best, TOLERANCE)
        if held is not None:
            yield held
    yield from over_missing_neighbors(neighbors, best)


def _on_boundary(neighbors: Neighbors, refined: Refined) -> bool:
    """Whether an edge without a neighbor holds a path."""
    held, values = refined.held_nodes, refined.values[:, :, 1:-1]
    for piece, patch in enumerate(refined.problem.route.patches):
        for side, edge in enumerate(EDGES):
            here = held[piece, edge.fixed_axis] & (
                values[piece, edge.fixed_axis] == edge.fixed_value
            )
            if here.any() and not neighbors.over.get((patch, side)):
                return True
    return False
