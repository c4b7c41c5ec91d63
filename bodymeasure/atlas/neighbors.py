"""Which places of an atlas are one: steps over seams, and the ways round a corner."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.seams import EDGES, edge_table

# Digits to which the parameters of two places must agree to be the same: they are added up from
# few numbers in [0, 1].
DIGITS = 9


class Place(NamedTuple):
    """A point (u, v) of a patch, for calculating; several places may be one point of the atlas."""

    patch: int
    u: float
    v: float


class Crossing(NamedTuple):
    """A step from one patch over a seam to another.

    Parameters
    ----------
    edge : int
        Number of the seam, as in `EdgeTable`.
    from_side, to_side : int
        The sides that meet there, in the order of `EDGES`.
    to_patch : int
    flipped : bool
        Whether the second side runs against the first.
    """

    edge: int
    from_side: int
    to_side: int
    to_patch: int
    flipped: bool


class Step(NamedTuple):
    """A crossing at a point of its seam.

    Parameters
    ----------
    crossing : Crossing
    along : float
        The parameter that runs along the side that is left.
    place : Place
        The same point on the patch that is entered.
    """

    crossing: Crossing
    along: float
    place: Place


def on_side(side: int, along: float) -> tuple[float, float]:
    """(u, v) of a point of a patch's side."""
    edge = EDGES[side]
    return (edge.fixed_value, along) if edge.fixed_axis == 0 else (along, edge.fixed_value)


class Neighbors:
    """The steps that lead from each patch of an atlas over its seams."""

    def __init__(self, atlas: Atlas) -> None:
        table = edge_table(atlas.index)
        control = table.control_index
        self.collapsed: NDArray[np.bool_] = (control == control[:, :, :1]).all(axis=2)
        on_edge: dict[int, list[tuple[int, int]]] = {}
        for patch, side in np.argwhere(~self.collapsed).tolist():
            on_edge.setdefault(int(table.edge[patch, side]), []).append((patch, side))
        self.over: dict[tuple[int, int], tuple[Crossing, ...]] = {}
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

    def steps(self, place: Place) -> Iterator[Step]:
        """All steps over a seam at a place."""
        parameters = (place.u, place.v)
        for side, edge in enumerate(EDGES):
            if parameters[edge.fixed_axis] != edge.fixed_value:
                continue
            along = parameters[1 - edge.fixed_axis]
            for crossing in self.over.get((place.patch, side), ()):
                there = 1.0 - along if crossing.flipped else along
                to = Place(crossing.to_patch, *on_side(crossing.to_side, there))
                yield Step(crossing, along, to)

    def same(self, place: Place) -> list[Place]:
        """All places that are the same point of the atlas, this one first."""
        found = {_key(place): place}
        queue = [place]
        while queue:
            for step in self.steps(queue.pop()):
                if _key(step.place) not in found:
                    found[_key(step.place)] = step.place
                    queue.append(step.place)
        return list(found.values())

    def ways(self, start: Place, end: Place) -> list[tuple[Step, ...]]:
        """The ways from one place to another that is the same point, fewest steps first.

        One over a seam; two about a corner, or one where the boundary is between.
        """
        found: list[tuple[Step, ...]] = []

        def follow(here: Place, seen: frozenset[Place], way: tuple[Step, ...]) -> None:
            if _key(here) == _key(end):
                found.append(way)
                return
            for step in self.steps(here):
                if _key(step.place) not in seen:
                    follow(step.place, seen | {_key(step.place)}, (*way, step))

        follow(start, frozenset({_key(start)}), ())
        return sorted(found, key=len)


def _key(place: Place) -> Place:
    return Place(place.patch, round(place.u, DIGITS), round(place.v, DIGITS))
