"""Where a path is free, where an edge of its patch holds it, and how its free parts end."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array


@dataclass(frozen=True)
class Contact:
    """One edge of the patch, as a shortest path touches it: a free leg joins it tangentially.

    Parameters
    ----------
    axis : int
        The coordinate that is fixed on the edge: 0 for u, 1 for v.
    value : float
        Its value there, 0 or 1.
    """

    axis: int
    value: float

    @property
    def name(self) -> str:
        """The edge's name, as in `bodymeasure.atlas.EDGES`."""
        return f"{'uv'[self.axis]} = {self.value:g}"

    @property
    def inwards(self) -> float:
        """The sign of the coordinate's change where it leads into the patch."""
        return 1.0 if self.value == 0.0 else -1.0


@dataclass(frozen=True)
class Pole(Contact):
    """An edge that is collapsed to a point: paths may leave it at any of its parameters."""


End = Contact | None
"""The end of a free leg: an edge along which the end may move, or None for a fixed point."""

Ends = tuple[End, End]


@dataclass(frozen=True)
class Leg:
    """One part of a path: free in the patch, or along an edge.

    Parameters
    ----------
    contact : Contact or None
        The edge that it runs along; None for a free leg.
    ends : pair of End
        The ends of a free leg.
    first, last : int
        Its first and last point in the polygon that it was read from.
    """

    contact: Contact | None
    ends: tuple[End, End]
    first: int
    last: int


def read_legs(points: Array, poles: tuple[End, End] = (None, None)) -> list[Leg]:
    """Return the pattern of free legs and contact arcs of a polygon in the box.

    Parameters
    ----------
    points : ndarray, shape (m + 1, 2)
        A polygon from `descend`, which is on an edge exactly where the edge holds it.
    poles : pair of End
        The ends of the path itself.

    Returns
    -------
    list of Leg
        In order. A contact arc that begins or ends at an end of the path is fixed there, and legs
        that meet at a corner of the patch are fixed there.
    """
    last = len(points) - 1
    at_corner = ((points == 0.0) | (points == 1.0)).all(axis=1)
    corners = {number for number in range(1, last) if at_corner[number]}
    legs: list[Leg] = []
    place, held = 0, poles[0]
    for contact, first, final in _arcs(points, corners):
        if first > place:
            legs.append(Leg(None, (held, None if first in corners else contact), place, first))
        legs.append(Leg(contact, (None, None), first, final))
        place, held = final, None if final in corners else contact
    if place < last:
        legs.append(Leg(None, (held, poles[1]), place, last))
    return legs


def _arcs(points: Array, corners: set[int]) -> list[tuple[Contact, int, int]]:
    """The edges that hold the polygon, each with its first and last point, in order."""
    last = len(points) - 1
    arcs: list[tuple[Contact, int, int]] = []
    for axis in (0, 1):
        for value in (0.0, 1.0):
            touching = points[:, axis] == value
            # An end that lies on an edge does not touch it unless the path goes on along it.
            inner = np.flatnonzero(touching[1:-1]) + 1
            for run in np.split(inner, np.flatnonzero(np.diff(inner) > 1) + 1):
                if len(run):
                    first = 0 if run[0] == 1 and touching[0] else int(run[0])
                    final = last if run[-1] == last - 1 and touching[last] else int(run[-1])
                    arcs.append((Contact(axis, value), first, final))
    arcs.sort(key=lambda arc: arc[1:])
    # A corner is on two edges, of which one is enough, or none if an arc leads there.
    reached = {end for _, first, final in arcs if first < final for end in (first, final)}
    kept = []
    for arc in arcs:
        if arc[1] == arc[2] and arc[1] in corners:
            if arc[1] in reached:
                continue
            reached.add(arc[1])
        kept.append(arc)
    return kept
