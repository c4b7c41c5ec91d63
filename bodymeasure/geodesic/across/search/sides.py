"""Routes along seams, all on one side of them.

The first route of a path that runs along several seams, as down the middle of a back, may change
sides anywhere. Where the seams hold the path, that makes no difference. Where it leaves them by a
little, it is the shortest if it stays on either side, but not if it has to change between them.

On a body whose halves are alike, such a path has nearly its like on the other side of the seams in
the middle. Which of the two is shorter shows only once both are refined.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import AXIS, EDGES, VALUE
from bodymeasure.atlas.topology.neighbors import Crossing, Neighbors, Step, on_side
from bodymeasure.geodesic.across.pieces.refine import RefinedPath
from bodymeasure.geodesic.across.routes.route import Route

# A piece runs along a seam if it is nowhere farther from it, in u or v of its patch.
ALONG_SEAM = 1e-2
# A piece runs beside a seam if it is nowhere farther from it.
BESIDE_SEAM = 0.1
# The other side is tried of seams beside which this part of a path runs, or more. To try it of all
# took nearly as many steps again on 200 pairs of points of a body, and made no other path shorter.
MOSTLY = 0.8


class _Side(NamedTuple):
    """A seam as seen from one of its patches, and where a path joins it and leaves it."""

    edge: int
    patch: int
    side: int
    enter: float
    leave: float


class SeamRun(NamedTuple):
    """A row of pieces that run along seams: the first piece, the last one, and the seams."""

    first: int
    last: int
    sides: list[_Side]


def sides_of_middle(neighbors: Neighbors, refined: RefinedPath) -> Iterator[Route]:
    """Yield routes on either side of the seams beside which most of a path runs."""
    least = MOSTLY * refined.lengths.sum()
    for run in seam_runs(neighbors, refined, BESIDE_SEAM, least):
        if refined.lengths[run.first : run.last + 1].sum() >= least:
            yield from one_sided(neighbors, refined.route, [run])


def seam_runs(
    neighbors: Neighbors, refined: RefinedPath, near: float = ALONG_SEAM, least: float = 0.0
) -> list[SeamRun]:
    """Return all runs of several pieces that are nowhere farther than `near` from their seams.

    Pieces that stay in a corner do not end a run. There is none that is as long as `least` if all
    such pieces together are shorter.
    """
    runs: list[SeamRun] = []
    goes_on = False
    # Within a corner a piece is beside two seams, whichever it runs along.
    moved = np.ptp(refined.values, axis=2).max(axis=1)
    apart = np.abs(refined.values[:, AXIS] - VALUE[:, None]).max(axis=2)
    beside = np.count_nonzero(apart <= near, axis=1)
    counts = (refined.lengths > 0.0) & (moved > ALONG_SEAM)
    ends = counts & (beside == 0)
    if np.count_nonzero(counts & ~ends) < 2 or refined.lengths[~ends].sum() < least:
        return []
    nearest = np.argsort(apart, axis=1, kind="stable")
    for piece in np.flatnonzero(counts).tolist():
        side = _seam(neighbors, refined, piece, nearest[piece, : beside[piece]].tolist())
        if side is not None:
            first, sides = runs.pop()[::2] if goes_on else (piece, [])
            runs.append(SeamRun(first, piece, [*sides, side]))
        goes_on = side is not None
    return [run for run in runs if len(run.sides) > 1]


def one_sided(neighbors: Neighbors, route: Route, runs: Sequence[SeamRun]) -> Iterator[Route]:
    """Yield routes whose pieces along seams are all on one side of them, or all on the other."""
    for run in runs:
        for start in (run.sides[0], _beyond(neighbors, run.sides[0])):
            found = _along(neighbors, route, run, start)
            if found is not None:
                yield found


def _seam(
    neighbors: Neighbors, refined: RefinedPath, piece: int, sides: Sequence[int]
) -> _Side | None:
    """The seam along which a piece runs, of the sides beside which it is; None if along none."""
    patch, values = refined.problem.route.patches[piece], refined.values[piece]
    for number in sides:
        crossings = neighbors.over.get((patch, number), ())
        if len(crossings) == 1:
            enter, leave = values[1 - EDGES[number].fixed_axis, [0, -1]].tolist()
            return _Side(crossings[0].edge, patch, number, enter, leave)
    return None


def _over(neighbors: Neighbors, side: _Side) -> Crossing:
    return neighbors.over[side.patch, side.side][0]


def _beyond(neighbors: Neighbors, side: _Side) -> _Side:
    """The same seam as seen from the other side."""
    crossing = _over(neighbors, side)
    enter, leave = (1.0 - each if crossing.flipped else each for each in side[3:])
    return _Side(side.edge, crossing.to_patch, crossing.to_side, enter, leave)


def _along(neighbors: Neighbors, route: Route, run: SeamRun, start: _Side) -> Route | None:
    """The route with a run on the side that is given for its first piece; None if none exists."""
    first, last, sides = run
    chosen, crossings, along = start, list(route.crossings[:first]), list(route.along[:first])
    assert route.ends is not None
    begin, end = route.ends
    if start != sides[0]:
        on_seam = _on_seam(neighbors, begin, start) if first == 0 else None
        if on_seam is not None:
            begin = on_seam
        else:
            crossings.append(_over(neighbors, sides[0]))
            along.append(sides[0].enter)
    for before, there in pairwise(sides):
        if there.edge == before.edge:
            # The path only changes sides.
            chosen = there if there.patch == chosen.patch else _beyond(neighbors, there)
            continue
        found = _next(neighbors, chosen, there)
        if found is None:
            return None
        steps, chosen = found
        crossings += [step.crossing for step in steps]
        along += [step.along for step in steps]
    if chosen.patch != sides[-1].patch:
        on_seam = _on_seam(neighbors, end, chosen) if last == len(route.crossings) else None
        if on_seam is not None:
            end = on_seam
        else:
            crossings.append(_over(neighbors, chosen))
            along.append(chosen.leave)
    crossings += route.crossings[last:]
    return Route((begin, end), tuple(crossings), (*along, *route.along[last:]))


def _on_seam(neighbors: Neighbors, place: AtlasPoint, side: _Side) -> AtlasPoint | None:
    """The same point on the patch of a side; None if it does not lie there."""
    return next((same for same in neighbors.same(place) if same.patch == side.patch), None)


def _next(
    neighbors: Neighbors, before: _Side, there: _Side
) -> tuple[tuple[Step, ...], _Side] | None:
    """The way round a corner to the next seam that crosses neither, and the side it reaches."""
    corner = AtlasPoint(before.patch, *on_side(before.side, float(round(before.leave))))
    for side in (there, _beyond(neighbors, there)):
        goal = AtlasPoint(side.patch, *on_side(side.side, float(round(side.enter))))
        for way in neighbors.ways(corner, goal):
            if all(step.crossing.edge not in (before.edge, there.edge) for step in way):
                return way, side
    return None
