"""The ways in which one point of an atlas can be written: steps over seams and round corners."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.edges import edges_of

# Digits to which the parameters of two places must agree to be the same. They are sums of a few
# numbers in [0, 1].
DIGITS = 9


class Crossing(NamedTuple):
    """A step from one patch over a seam to another, or over a line within a patch.

    Parameters
    ----------
    edge : int
        Number of the seam, as in `EdgeTable`; -1 for a line within a patch.
    from_side, to_side : int
        The sides that meet there, in the order of `EDGES`.
    to_patch : int
    flipped : bool
        Whether the second side runs against the first.
    within : float or None
        The fixed parameter of a line within the patch, where that of the two sides would be on a
        seam.
    """

    edge: int
    from_side: int
    to_side: int
    to_patch: int
    flipped: bool
    within: float | None = None


class Step(NamedTuple):
    """A crossing at a point of its seam.

    Parameters
    ----------
    crossing : Crossing
    along : float
        The parameter that runs along the side that is left.
    place : AtlasPoint
        The same point on the patch that is entered.
    """

    crossing: Crossing
    along: float
    place: AtlasPoint


def on_side(side: int, along: float) -> tuple[float, float]:
    """Return (u, v) of a point of a patch's side."""
    edge = EDGES[side]
    return (edge.fixed_value, along) if edge.fixed_axis == 0 else (along, edge.fixed_value)


class Neighbors:
    """The steps that lead from each patch of an atlas over its seams."""

    def __init__(self, atlas: Atlas) -> None:
        table = edges_of(atlas)
        self.collapsed = table.collapsed
        on_edge: dict[int, list[tuple[int, int]]] = {}
        for patch, side in np.argwhere(~self.collapsed).tolist():
            on_edge.setdefault(int(table.edge[patch, side]), []).append((patch, side))
        self.over: dict[tuple[int, int], tuple[Crossing, ...]] = {}
        self._round: dict[tuple[AtlasPoint, AtlasPoint], tuple[tuple[Step, ...], ...]] = {}
        for edge, sides in on_edge.items():
            for patch, side in sides:
                self.over[patch, side] = tuple(
                    Crossing(
                        edge,
                        side,
                        to_side,
                        to_patch,
                        bool(table.reversed[patch, side] != table.reversed[to_patch, to_side]),
                    )
                    for to_patch, to_side in sides
                    if (to_patch, to_side) != (patch, side)
                )

    def steps(self, place: AtlasPoint) -> Iterator[Step]:
        """Yield all steps over a seam at a place; at a pole, from both ends of its side."""
        side = self.pole_side(place)
        if side is None:
            yield from self._steps(place)
            return
        for along in (0.0, 1.0):
            yield from self._steps(AtlasPoint(place.patch, *on_side(side, along)))

    def pole_side(self, place: AtlasPoint) -> int | None:
        """Return the collapsed side on which a place lies, if any."""
        for side, edge in enumerate(EDGES):
            if self.collapsed[place.patch, side] and place[1 + edge.fixed_axis] == edge.fixed_value:
                return side
        return None

    def _steps(self, place: AtlasPoint) -> Iterator[Step]:
        parameters = (place.u, place.v)
        for side, edge in enumerate(EDGES):
            if parameters[edge.fixed_axis] != edge.fixed_value:
                continue
            along = parameters[1 - edge.fixed_axis]
            for crossing in self.over.get((place.patch, side), ()):
                there = 1.0 - along if crossing.flipped else along
                to = AtlasPoint(crossing.to_patch, *on_side(crossing.to_side, there))
                yield Step(crossing, along, to)

    def same(self, place: AtlasPoint) -> list[AtlasPoint]:
        """Return all places that are the same point of the atlas, this one first."""
        found = {self.key(place): place}
        queue = [place]
        while queue:
            for step in self.steps(queue.pop()):
                if self.key(step.place) not in found:
                    found[self.key(step.place)] = step.place
                    queue.append(step.place)
        return list(found.values())

    def are_same(self, place: AtlasPoint, other: AtlasPoint) -> bool:
        """Return whether two places are the same point of the atlas, as far as `DIGITS` tell."""
        # Only a place that is exactly on a seam can be written on the other side of it.
        first, second = (map(self.key, self.same(each)) for each in (place, other))
        return self.key(other) in first or self.key(place) in second

    def ways(self, start: AtlasPoint, end: AtlasPoint) -> tuple[tuple[Step, ...], ...]:
        """Return the ways from one place to another that is the same point, the shortest first.

        There is one way over a seam, and two round a corner, or one where the boundary is between.
        Those round corners are kept: a loop passes the same ones again and again as it slides.
        """
        known = self._round.get((start, end))
        if known is not None:
            return known
        ways = self._ways(start, end)
        if {*start[1:], *end[1:]} <= {0.0, 1.0}:
            self._round[start, end] = ways
        return ways

    def _ways(self, start: AtlasPoint, end: AtlasPoint) -> tuple[tuple[Step, ...], ...]:
        found: list[tuple[Step, ...]] = []

        def follow(here: AtlasPoint, seen: frozenset[AtlasPoint], way: tuple[Step, ...]) -> None:
            if self.key(here) == self.key(end):
                found.append(way)
                return
            for step in self.steps(here):
                if self.key(step.place) not in seen:
                    follow(step.place, seen | {self.key(step.place)}, (*way, step))

        follow(start, frozenset({self.key(start)}), ())
        return tuple(sorted(found, key=len))

    def key(self, place: AtlasPoint) -> AtlasPoint:
        """Return a key that all places of a patch at one point share."""
        side = self.pole_side(place)
        if side is not None:
            return AtlasPoint(place.patch, *on_side(side, 0.0))
        return AtlasPoint(place.patch, round(place.u, DIGITS), round(place.v, DIGITS))
