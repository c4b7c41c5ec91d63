"""Other routes that may be shorter than that of a refined path or loop.

Where an edge or a corner holds the path, it would be shorter on the other side. A change of a route
is given by the first crossing that is replaced, the one before which the replaced ones end, and the
crossings that are put in their place (`Route.replaced`).
"""

from collections.abc import Collection, Iterator, Sequence

import numpy as np

from bodymeasure._typing import Bools
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import AXIS, EDGES, VALUE
from bodymeasure.atlas.topology.neighbors import Crossing, Neighbors
from bodymeasure.geodesic.across.pieces.refine import RefinedPath
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.search.sides import one_sided, seam_runs, sides_of_middle

# The degree while a loop slides: its polynomials only have to show in which direction.
SLIDING = 3
# A piece below this part of the path's length may be one too many.
SHORT = 1e-3
# A path that crosses a seam this near to a corner, in the parameter of the seam, may have to pass
# the corner on the other side.
NEAR_CORNER = 1e-2
# A piece that could be shorter by no more than this part of the path needs no neighbor. That is so
# where a piece runs along a seam from which the surface falls equally on both sides.
WORTHWHILE = 1e-10
# While a loop slides, such small ones are only those of its degree.
WORTHWHILE_SLIDING = 1e-7
# A path that is farther outside its patch than this, between its nodes, lacks a neighbor.
OUTSIDE = 1e-9

_NearCorners = list[tuple[AtlasPoint | None, AtlasPoint | None]]
Change = tuple[int, int, Sequence[tuple[Crossing, float]]]


def other_routes(neighbors: Neighbors, refined: RefinedPath) -> Iterator[Route]:
    """Yield routes over the same seams or fewer that may be shorter, the likeliest first.

    Those over further patches are `detours`.
    """
    route = refined.route
    yield from _without_ends(neighbors, refined)
    yield from _without_returns(refined)
    runs = seam_runs(neighbors, refined)
    yield from one_sided(neighbors, route, runs)
    yield from sides_of_middle(neighbors, refined)
    # The path passes the corners between the seams along which it runs.
    passed = {number for run in runs for number in range(run.first, run.last)}
    corners = _round_corners(neighbors, route, _corners(route), passed)
    yield from (route.replaced(*change) for change in corners)


def other_loops(neighbors: Neighbors, loop: RefinedPath) -> Iterator[Route]:
    """Yield routes that may be shorter than a loop's, the likeliest first.

    A loop that slides over the body is held by many corners at once, and by none once it has passed
    them. So all corners are passed together at first, then one by one.
    """
    near = _corners(loop.route)
    first = _outside_corners(near)
    route, near = loop.route.begun_at(first), near[first:] + near[:first]
    held = np.roll(loop.minimum.held[loop.problem.joints], -first)
    corners = list(_round_corners(neighbors, route, near))
    yield from _all_at_once(route, [change for change in corners if held[slice(*change[:2])].any()])
    yield from _without_returns(loop)
    worthwhile = WORTHWHILE_SLIDING if loop.problem.space.size <= SLIDING else WORTHWHILE
    changes = list(detours(neighbors, loop, worthwhile))
    yield from _all_at_once(loop.route, changes)
    yield from (loop.route.replaced(*change) for change in changes)
    yield from (route.replaced(*change) for change in corners)


def _without_ends(neighbors: Neighbors, refined: RefinedPath) -> Iterator[Route]:
    """Routes without a first or last piece that only leads over the seam on which its end lies.

    It has no length, or the seam holds it: a path may leave that to either side.
    """
    route = refined.route
    if route.ends is None or not route.crossings:
        return
    start, end = route.ends
    may_go = refined.lengths < SHORT * refined.lengths.sum()
    may_go |= refined.held_nodes.any(axis=(1, 2))
    for step in neighbors.steps(start) if may_go[0] else ():
        if step.crossing == route.crossings[0]:
            yield Route((step.place, end), route.crossings[1:], route.along[1:])
    for step in neighbors.steps(end) if may_go[-1] else ():
        if step.crossing == _back(route.crossings[-1], route.patches[-2]):
            yield Route((start, step.place), route.crossings[:-1], route.along[:-1])


def _back(crossing: Crossing, patch: int) -> Crossing:
    """The crossing of the same seam back to the patch that it leaves."""
    return Crossing(crossing.edge, crossing.to_side, crossing.from_side, patch, crossing.flipped)


def _without_returns(refined: RefinedPath) -> Iterator[Route]:
    """Routes without a piece that only goes over a seam and comes back."""
    route = refined.route
    patches, count = route.patches, len(route.crossings)
    for piece in range(0 if route.closed else 1, count):
        enter = piece if route.closed else piece - 1
        leave = (enter + 1) % count
        same_edge = route.crossings[enter].edge == route.crossings[leave].edge
        returns = same_edge and patches[piece - 1] == patches[(piece + 1) % len(patches)]
        if count > 1 and returns and refined.lengths[piece] < SHORT * refined.lengths.sum():
            # The two crossings of a loop may be its last and its first: it is begun at them.
            begun = route.begun_at(enter) if route.closed else route
            first = 0 if route.closed else enter
            yield begun.replaced(first, first + 2)


def _round_corners(
    neighbors: Neighbors, route: Route, corners: _NearCorners, passed: Collection[int] = ()
) -> Iterator[Change]:
    """Ways round the other side of corners that a path nearly runs into, but for those passed."""
    first, count = 0, len(corners)
    while first < count:
        leave, _ = corners[first]
        if leave is None or first in passed:
            first += 1
            continue
        last = first
        while last + 1 < count and corners[last][1] == corners[last + 1][0] is not None:
            last += 1
        _, enter = corners[last]
        current = route.crossings[first : last + 1]
        for way in neighbors.ways(leave, enter) if enter else ():
            if tuple(step.crossing for step in way) != current:
                yield first, last + 1, [step[:2] for step in way]
        first = last + 1


def _outside_corners(corners: _NearCorners) -> int:
    """The number of a crossing before which a loop does not stay in a corner."""
    for number, (leave, _) in enumerate(corners):
        _, enter = corners[number - 1]
        if enter is None or enter != leave:
            return number
    return 0


def _corners(route: Route) -> _NearCorners:
    """The corners of both patches that each crossing is near to; None where it is near to none."""
    result: _NearCorners = []
    for number, crossing in enumerate(route.crossings):
        along = route.along[number]
        if crossing.within is None and NEAR_CORNER < along < 1.0 - NEAR_CORNER:
            result.append((None, None))
            continue
        points = route.crossed[number]
        nearest = [AtlasPoint(p.patch, float(round(p.u)), float(round(p.v))) for p in points]
        before, after = (
            corner if max(abs(p.u - corner.u), abs(p.v - corner.v)) <= NEAR_CORNER else None
            for p, corner in zip(points, nearest, strict=True)
        )
        result.append((before, after))
    return result


def detours(
    neighbors: Neighbors, refined: RefinedPath, worthwhile: float = WORTHWHILE
) -> Iterator[Change]:
    """Yield ways over the neighbor behind an edge.

    The edge holds the path, or the path passes it between its nodes. A piece that could be shorter
    by no more than `worthwhile` parts of the path is left out.
    """
    route, space, values = refined.route, refined.problem.space, refined.values
    pieces, _, nodes = values.shape
    samples = (values.reshape(-1, nodes) @ space.between_nodes.T).reshape(pieces, 2, -1)
    # Most paths are on their patches everywhere.
    if not refined.held_nodes.any() and np.abs(samples - 0.5).max() <= 0.5 + OUTSIDE:
        return
    times = np.concatenate([space.nodes[1:-1], space.times_between])
    order = np.argsort(times, kind="stable")
    beyond = (samples[:, AXIS] - VALUE[:, None]) * (2.0 * VALUE[:, None] - 1.0) > OUTSIDE
    on_edge = refined.held_nodes[:, AXIS] & (values[:, AXIS, 1:-1] == VALUE[:, None])
    leaves = np.concatenate([on_edge, beyond], axis=2)[:, :, order]
    for piece in np.flatnonzero(leaves.any(axis=(1, 2))).tolist():
        # The gain is how much shorter the piece could be if nothing held it.
        if abs(refined.by_piece.correction[piece]) < worthwhile * refined.lengths.sum():
            continue
        patch = route.patches[piece]
        # The number of the crossing that leaves the piece.
        leaving = piece + route.closed
        for side in np.flatnonzero(leaves[piece].any(axis=1)).tolist():
            crossings = neighbors.over.get((patch, side), ())
            runs = _runs(leaves[piece, side]) if crossings else []
            for first, last in runs[:1] if route.closed else runs:
                ends = times[order][[max(first - 1, 0), min(last + 1, len(times) - 1)]]
                along = space.functions.values(ends) @ values[piece, 1 - EDGES[side].fixed_axis]
                leave, enter = np.clip(along, 0.0, 1.0).tolist()
                for crossing in crossings:
                    there = 1.0 - enter if crossing.flipped else enter
                    yield leaving, leaving, [(crossing, leave), (_back(crossing, patch), there)]


def _runs(mask: Bools) -> list[tuple[int, int]]:
    """The first and the last of all true values, then of each run of them if there are several.

    A polynomial that is held at its nodes oscillates about the edge, so that its runs mostly belong
    together.
    """
    changes = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(np.int8)))
    runs = [(int(first), int(last) - 1) for first, last in changes.reshape(-1, 2)]
    return [(runs[0][0], runs[-1][1]), *runs] if len(runs) > 1 else runs


def _all_at_once(route: Route, changes: list[Change]) -> Iterator[Route]:
    """The route with the first change of each group that overlaps, if there are several groups."""
    chosen: list[Change] = []
    for change in changes:
        first, *_ = change
        if not chosen or (first >= chosen[-1][1] and first > chosen[-1][0]):
            chosen.append(change)
    if len(chosen) > 1:
        for change in reversed(chosen):
            route = route.replaced(*change)
        yield route
