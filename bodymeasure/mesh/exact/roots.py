"""The vertices that legs lead to, and those about which paths turn."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.mesh.exact.places import MeshPoint
from bodymeasure.mesh.exact.sides import Sides, after, before
from bodymeasure.mesh.exact.windows import GRAZING, Corners, Windows

# Paths turn about vertices whose angles are at least 360 degrees less this. A path through a vertex
# with that much less is longer than those beside it by an eighth of its square.
NEARLY_FLAT = 1e-8


class Arrivals(NamedTuple):
    """Legs that end in vertices. All arrays have shape (k,).

    Parameters
    ----------
    vertex : ndarray of int
    way : ndarray
        The length of the path to it.
    fan : ndarray of int
        The fan about the vertex through which the leg comes.
    place : ndarray
        The place of the leg in the fan.
    number : ndarray of int
        The number of the root where the leg begins.
    parent : ndarray of int
        The last window that it crosses; -1 if there is none.
    """

    vertex: Ints
    way: Array
    fan: Ints
    place: Array
    number: Ints
    parent: Ints

    def take(self, which: Ints | Bools) -> "Arrivals":
        """Return some of them."""
        return Arrivals(
            self.vertex[which],
            self.way[which],
            self.fan[which],
            self.place[which],
            self.number[which],
            self.parent[which],
        )

    @classmethod
    def joined(cls, parts: list["Arrivals"]) -> "Arrivals":
        """Return the arrivals of several batches as one."""
        return cls(*(np.concatenate(each) for each in zip(*parts, strict=True)))


def arrived(sides: Sides, windows: Windows, corner: Corners, parent: Ints) -> Arrivals:
    """Return the legs that end in the third corners of the faces which windows enter."""
    which = np.flatnonzero(corner.seen)
    some = windows.take(which)
    side = before(some.side)
    third = sides.third[some.side]
    # The angle from the side that leads from the corner to the first vertex.
    angle = np.angle((some.root - third) / -third)
    place = sides.place[side] + np.clip(angle, 0.0, sides.angle[side])
    way = some.way + corner.distance[which]
    return Arrivals(sides.first[side], way, sides.fan[side], place, some.number, parent[which])


def from_place(sides: Sides, place: MeshPoint) -> tuple[Windows, Arrivals]:
    """Return the windows and the arrivals of legs from within a face, or on its boundary."""
    side = 3 * place.face + np.arange(3)
    root = (
        place.weights[after(side) % 3] * sides.length[side]
        + place.weights[before(side) % 3] * sides.third[side]
    )
    none = np.full(3, -1)
    angle = np.clip(np.angle(root), 0.0, sides.angle[side])
    arrivals = Arrivals(
        sides.first[side],
        np.abs(root),
        sides.fan[side],
        sides.place[side] + angle,
        np.zeros(3, np.int64),
        none,
    )
    over = sides.over[side]
    # The frame of the same side in the face beyond leads the other way.
    windows = Windows(
        over,
        sides.length[side] - root,
        np.zeros(3),
        sides.length[side],
        np.zeros(3),
        np.zeros(3, np.int64),
        none,
    )
    return windows.take(over >= 0), arrivals


def from_vertices(sides: Sides, at: Arrivals, numbers: Ints) -> tuple[Windows, Arrivals]:
    """Return the windows and the arrivals of legs that go on from vertices, as roots.

    Legs go on only where they turn by 180 degrees or more to both sides, since others are not
    shortest. Where the fan is -1, they begin, and go in all directions.
    """
    count = sides.begins[at.vertex + 1] - sides.begins[at.vertex]
    owner = np.repeat(np.arange(len(count)), count)
    offset = np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)
    side = sides.about[sides.begins[at.vertex][owner] + offset]
    low, high = _ahead(sides, at.take(owner), side)
    some = low <= high
    side, owner, low, high = side[some], owner[some], low[some], high[some]
    opposite, closing = after(side), before(side)
    way, number = at.way[owner], numbers[owner]
    none = np.full(len(side), -1)
    first, last = low <= GRAZING, high >= sides.angle[side] - GRAZING
    arrivals = Arrivals.joined(
        [
            Arrivals(
                sides.last[side],
                way + sides.length[side],
                sides.fan[opposite],
                sides.place[opposite] + sides.angle[opposite],
                number,
                none,
            ).take(first),
            Arrivals(
                sides.first[closing],
                way + sides.length[closing],
                sides.fan[closing],
                sides.place[closing],
                number,
                none,
            ).take(last),
        ]
    )
    over = sides.over[opposite]
    length = sides.length[opposite]
    # In the frame of the opposite side from beyond, the legs' first direction is its last vertex.
    left = np.where(last, 0.0, length - _across(sides, side, high))
    right = np.where(first, length, length - _across(sides, side, low))
    root = sides.length[closing] * sides.turn[closing].conjugate()
    windows = Windows(over, root, left, right, way, number, none)
    return windows.take((over >= 0) & (right > left)), arrivals


def _ahead(sides: Sides, at: Arrivals, side: Ints) -> tuple[Array, Array]:
    """Return the angles, from sides on, between which legs go on from their first vertices.

    The lower one is the greater where none does.
    """
    total, angle, closed = sides.total[side], sides.angle[side], sides.closed[side]
    # From the direction in which a leg comes.
    begin = sides.place[side] - at.place
    begin = np.where(closed, np.mod(begin, np.where(closed, total, 1.0)), begin)
    end = begin + angle
    to_left = np.maximum(begin, np.pi - GRAZING)
    # A fan of just less than 360 degrees still has its one direction ahead.
    half = np.minimum(np.pi, 0.5 * total)
    to_left = np.where(closed, np.maximum(begin, half - GRAZING), to_left)
    up_to = np.where(closed, np.minimum(end, total - half + GRAZING), end)
    convex = closed & (total < 2.0 * np.pi - NEARLY_FLAT)
    # On open fans, legs may turn the other way, too.
    other = ~closed & (begin <= -np.pi + GRAZING)
    low = np.where(other, begin, to_left)
    high = np.where(other, np.minimum(end, -np.pi + GRAZING), up_to)
    anywhere = (at.fan != sides.fan[side]) | (at.fan < 0)
    low = np.where(anywhere, 0.0, np.where(convex, np.inf, np.clip(low - begin, 0.0, np.inf)))
    high = np.where(anywhere, angle, np.minimum(high - begin, angle))
    return low, high


def _across(sides: Sides, side: Ints, angle: Array) -> Array:
    """Return how far from a side's end a ray at an angle to it meets the opposite side."""
    opposite = after(side)
    beyond = np.sin(angle + sides.angle[opposite])
    met = sides.length[side] * np.sin(angle)
    return np.clip(
        np.divide(met, beyond, out=sides.length[opposite].copy(), where=beyond > 0.0),
        0.0,
        sides.length[opposite],
    )
