"""Other routes that a refined loop asks for: what holds it tells where it would rather go."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Crossing, Neighbors
from bodymeasure.geodesic.across.pieces.closed_refine import RefinedLoop
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.search.route_repair import OUTSIDE, SHORT, WORTHWHILE, corner_near
from bodymeasure.geodesic.lengths.measure import measure_length


class _Change(NamedTuple):
    """Crossings from `first` to before `last`, and what to put in their place."""

    first: int
    last: int
    steps: tuple[tuple[Crossing, float], ...]


def other_loops(neighbors: Neighbors, loop: RefinedLoop) -> Iterator[Route]:
    """Routes that may be shorter, the likeliest first.

    A loop that slides over the body is held by many corners at once, and by none once it is past
    them: so all are passed together, then one by one.
    """
    first = _outside_corners(loop.route)
    route = loop.route.begun_at(first)
    held = np.roll(loop.held_joints, -first)
    corners = list(_round_corners(neighbors, route))
    pressed = [change for change in corners if held[change.first : change.last].any()]
    # One way round each corner, to apply them all.
    yield from _all_at_once(route, pressed)
    yield from _without_returns(loop.route, loop.lengths)
    detours = list(_over_missing_neighbors(neighbors, loop))
    yield from _all_at_once(loop.route, detours)
    yield from (_changed(loop.route, [change]) for change in detours)
    yield from (_changed(route, [change]) for change in corners)


def _all_at_once(route: Route, changes: list[_Change]) -> Iterator[Route]:
    """With the first change of each stretch, if there are several."""
    chosen: list[_Change] = []
    for change in changes:
        if not chosen or (change.first >= chosen[-1].last and change.first > chosen[-1].first):
            chosen.append(change)
    if len(chosen) > 1:
        yield _changed(route, chosen)


def _changed(route: Route, changes: list[_Change]) -> Route:
    for change in reversed(changes):
        route = route.replaced(change.first, change.last, change.steps)
    return route


def _outside_corners(route: Route) -> int:
    """A crossing before which the loop does not stay in a corner."""
    for piece in range(len(route.crossings)):
        corner = corner_near(route.entry(piece - 1))
        if corner is None or corner != corner_near(route.exit(piece - 1)):
            return piece
    return 0


def _round_corners(neighbors: Neighbors, route: Route) -> Iterator[_Change]:
    """Round the other side of corners that a loop runs into or nearly so."""
    first, count = 0, len(route.crossings)
    while first < count:
        leave = corner_near(route.exit(first - 1))
        if leave is None:
            first += 1
            continue
        last = first
        while last + 1 < count:
            here, there = corner_near(route.entry(last)), corner_near(route.exit(last))
            if there is None or here != there:
                break
            last += 1
        enter = corner_near(route.entry(last))
        current = route.crossings[first : last + 1]
        for way in neighbors.ways(leave, enter) if enter else ():
            if tuple(step.crossing for step in way) != current:
                steps = tuple((step.crossing, step.along) for step in way)
                yield _Change(first, last + 1, steps)
        first = last + 1


def _without_returns(route: Route, lengths: Array) -> Iterator[Route]:
    """Without a piece that only goes over a seam and comes back."""
    count, patches = len(route.crossings), route.patches
    for piece in range(count):
        following = (piece + 1) % count
        enter, leave = route.crossings[piece], route.crossings[following]
        returns = enter.edge == leave.edge and patches[piece - 1] == patches[following]
        if count > 1 and returns and lengths[piece] < SHORT * lengths.sum():
            yield route.begun_at(piece).replaced(0, 2, ())


def _over_missing_neighbors(neighbors: Neighbors, loop: RefinedLoop) -> Iterator[_Change]:
    """Over the neighbor behind an edge that holds a loop, or that it passes between its nodes."""
    space, patches = loop.problem.space, loop.route.patches
    times = np.concatenate([space.nodes[1:-1], space.times_between])
    order = np.argsort(times, kind="stable")
    samples = loop.values @ space.between_nodes.T
    held = loop.held_nodes
    # How much shorter each piece could be if nothing held it.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        gain = np.abs(measure_length(loop.problem.surface, space, loop.values).correction)
    for piece in np.flatnonzero(~(gain < WORTHWHILE * loop.lengths.sum())).tolist():
        for side, edge in enumerate(EDGES):
            axis, value = edge.fixed_axis, edge.fixed_value
            beyond = (samples[piece, axis] - value) * (2.0 * value - 1.0) > OUTSIDE
            on_edge = held[piece, axis] & (loop.values[piece, axis, 1:-1] == value)
            out = np.flatnonzero(np.concatenate([on_edge, beyond])[order])
            if not len(out):
                continue
            ends = times[order][[max(out[0] - 1, 0), min(out[-1] + 1, len(times) - 1)]]
            leave, enter = np.clip(
                space.functions.values(ends) @ loop.values[piece, 1 - axis], 0.0, 1.0
            ).tolist()
            for crossing in neighbors.over.get((patches[piece], side), ()):
                back = Crossing(
                    crossing.edge,
                    crossing.to_side,
                    crossing.from_side,
                    patches[piece],
                    crossing.flipped,
                )
                there = 1.0 - enter if crossing.flipped else enter
                yield _Change(piece + 1, piece + 1, ((crossing, leave), (back, there)))
