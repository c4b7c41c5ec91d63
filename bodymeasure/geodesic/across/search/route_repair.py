"""Other routes that a refined path asks for: what holds it tells where it would rather go."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Crossing, Neighbors
from bodymeasure.geodesic.across.pieces.route_refine import Refined
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.search.sides import corners_along_seams, one_sided
from bodymeasure.geodesic.lengths.measure import measure_length

# A piece that is this part of the path may be one too many.
SHORT = 1e-3
# A crossing this near to a corner, in the parameter of its seam, may have to go round it.
NEAR_CORNER = 1e-2
# A piece that could be shorter by no more than this part of the path needs no neighbor, as one that
# runs along a seam from which the surface falls alike to both sides.
WORTHWHILE = 1e-10
# Further than this outside the patch, between the nodes, the path lacks a neighbor.
OUTSIDE = 1e-9


def other_routes(neighbors: Neighbors, refined: Refined) -> Iterator[Route]:
    """Routes over the same seams or fewer that may be shorter, the likeliest first."""
    route = refined.route
    yield from _without_empty_ends(neighbors, refined, route)
    yield from _without_returns(refined, route)
    yield from one_sided(neighbors, refined)
    yield from _round_corners(neighbors, route, corners_along_seams(neighbors, refined))


def _without_empty_ends(neighbors: Neighbors, refined: Refined, route: Route) -> Iterator[Route]:
    """Without a first or last piece that has no length, since its end lies on the seam."""
    total = refined.lengths.sum()
    if not route.crossings:
        return
    if refined.lengths[0] < SHORT * total:
        for step in neighbors.steps(route.start):
            if step.crossing == route.crossings[0]:
                yield Route((step.place, route.end), route.crossings[1:], route.along[1:])
    if refined.lengths[-1] < SHORT * total:
        last, patch = route.crossings[-1], route.patches[-2]
        for step in neighbors.steps(route.end):
            back = step.crossing
            if (back.edge, back.from_side, back.to_side, back.to_patch) == (
                last.edge,
                last.to_side,
                last.from_side,
                patch,
            ):
                yield Route((route.start, step.place), route.crossings[:-1], route.along[:-1])


def _without_returns(refined: Refined, route: Route) -> Iterator[Route]:
    """Without a piece that only goes over a seam and comes back."""
    patches = route.patches
    for piece in range(1, len(patches) - 1):
        enter, leave = route.crossings[piece - 1 : piece + 1]
        returns = enter.edge == leave.edge and patches[piece - 1] == patches[piece + 1]
        if returns and refined.lengths[piece] < SHORT * refined.lengths.sum():
            yield route.replaced(piece - 1, piece + 1)


def over_missing_neighbors(neighbors: Neighbors, refined: Refined) -> Iterator[Route]:
    """Over the neighbor behind an edge that holds a path, or that it passes between its nodes."""
    route = refined.route
    space, patches = refined.problem.space, route.patches
    times = np.concatenate([space.nodes[1:-1], space.times_between])
    order = np.argsort(times, kind="stable")
    samples = refined.values @ space.between_nodes.T
    held = refined.held_nodes
    # How much shorter each piece could be if nothing held it.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        gain = np.abs(measure_length(refined.problem.surface, space, refined.values).correction)
    worth = ~(gain < WORTHWHILE * refined.lengths.sum())
    for piece in np.flatnonzero(worth).tolist():
        patch = patches[piece]
        for side, edge in enumerate(EDGES):
            crossings = neighbors.over.get((patch, side), ())
            axis, value = edge.fixed_axis, edge.fixed_value
            beyond = (samples[piece, axis] - value) * (2.0 * value - 1.0) > OUTSIDE
            on_edge = refined.values[piece, axis, 1:-1] == value
            out = np.concatenate([held[piece, axis] & on_edge, beyond])[order]
            for first, last in _runs(out) if crossings else ():
                along = refined.values[piece, 1 - axis] @ _at(
                    refined, times[order][[max(first - 1, 0), min(last + 1, len(out) - 1)]]
                )
                for crossing in crossings:
                    yield _detour(route, piece, crossing, np.clip(along, 0.0, 1.0))


def _at(refined: Refined, times: Array) -> Array:
    return np.asarray(refined.problem.space.functions.values(times).T)


def _runs(mask: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and last of all true values, then of each run of them if there are several.

    Held at its nodes, a polynomial winds about the edge: its runs are mostly one.
    """
    changes = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(np.int8)))
    runs = [(int(first), int(last) - 1) for first, last in changes.reshape(-1, 2)]
    return [(runs[0][0], runs[-1][1]), *runs] if len(runs) > 1 else runs


def _detour(route: Route, piece: int, crossing: Crossing, along: Array) -> Route:
    """A piece with a way over a neighbor and back within it."""
    patch = route.patches[piece]
    back = Crossing(crossing.edge, crossing.to_side, crossing.from_side, patch, crossing.flipped)
    leave, enter = along.tolist()
    enter = 1.0 - enter if crossing.flipped else enter
    return route.replaced(piece, piece, ((crossing, leave), (back, enter)))


def _round_corners(neighbors: Neighbors, route: Route, passed: set[int]) -> Iterator[Route]:
    """Round the other side of corners that a path runs into or nearly so; not of those passed."""
    first = 0
    while first < len(route.crossings):
        leave = corner_near(route.exit(first))
        if leave is None or first in passed:
            first += 1
            continue
        last = first
        while last + 1 < len(route.crossings):
            here, there = corner_near(route.entry(last + 1)), corner_near(route.exit(last + 1))
            if there is None or here != there:
                break
            last += 1
        enter = corner_near(route.entry(last + 1))
        current = route.crossings[first : last + 1]
        for way in neighbors.ways(leave, enter) if enter else ():
            if tuple(step.crossing for step in way) != current:
                yield route.replaced(first, last + 1, [step[:2] for step in way])
        first = last + 1


def corner_near(place: AtlasPoint) -> AtlasPoint | None:
    """The corner of its patch that a place on an edge is near to; None if it is near to none."""
    nearest = AtlasPoint(place.patch, float(round(place.u)), float(round(place.v)))
    apart = max(abs(place.u - nearest.u), abs(place.v - nearest.v))
    return nearest if apart <= NEAR_CORNER else None
