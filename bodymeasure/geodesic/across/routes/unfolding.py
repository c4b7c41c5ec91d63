"""Strips of triangles unfolded into a plane, and the shortest paths within them.

The path is found by a funnel (D. T. Lee, F. P. Preparata, "Euclidean shortest paths in the presence
of rectilinear barriers", Networks 14 (1984)). Places in the plane are complex numbers.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bodymeasure.geodesic.across.routes.faces import FaceMesh, OnFace

SIDES = "faces in a row share a side"


class Strip(NamedTuple):
    """Faces in a row, and the ends of a path on the first and the last of them."""

    faces: list[int]
    start: OnFace
    end: OnFace


@dataclass(frozen=True, eq=False)
class Unfolded:
    """A strip unfolded into a plane, and the shortest path within it.

    Parameters
    ----------
    start, end : complex
    sides : list of int
        The side by which the path leaves each face but the last.
    names : list of (int, int)
        The vertices to the left and to the right there.
    left, right : list of complex
        Where they are in the plane.
    bends : list of (int, int)
        The number of the side at which the path bends, and 0 if it does so to the left, else 1.
    """

    start: complex
    end: complex
    sides: list[int]
    names: list[tuple[int, int]]
    left: list[complex]
    right: list[complex]
    bends: list[tuple[int, int]]

    @classmethod
    def of(cls, mesh: FaceMesh, strip: Strip) -> "Unfolded":
        """Unfold a strip."""
        first = mesh.faces[strip.faces[0]]
        scale = float(np.linalg.norm(mesh.vertices[first[1]] - mesh.vertices[first[0]]))
        places: dict[int, complex] = {first[0]: 0j, first[1]: 1.0 + 0j}
        places[first[2]] = mesh.apex[strip.faces[0]][0]
        places = {vertex: scale * place for vertex, place in places.items()}
        start = sum(
            w * places[vertex] for w, vertex in zip(strip.start.weights, first, strict=True)
        )
        sides, names, left, right = [], [], [], []
        here = strip.faces[0]
        for there in strip.faces[1:]:
            corners, beyond = mesh.faces[here], mesh.faces[there]
            side = shared_side(corners, beyond)
            one, other = corners[side], corners[(side + 1) % 3]
            third = places[corners[side - 1]]
            a, b = places[one], places[other]
            # The third corner lies behind: to the right of the line from the left to the right.
            if ((b - a).conjugate() * (third - a)).imag >= 0.0:
                one, other, a, b = other, one, b, a
            sides.append(side)
            names.append((one, other))
            left.append(a)
            right.append(b)
            entered = beyond.index(one)
            after = (entered + 1) % 3
            if beyond[after] == other:
                new, shape = beyond[entered - 1], mesh.apex[there][entered]
            else:
                # The side runs the other way in this face.
                new, shape = beyond[after], 1.0 - mesh.apex[there][entered - 1].conjugate()
            places = {one: a, other: b, new: a + (b - a) * shape}
            here = there
        end = sum(
            w * places[vertex]
            for w, vertex in zip(strip.end.weights, mesh.faces[here], strict=True)
        )
        return cls(start, end, sides, names, left, right, funnel(start, end, left, right))

    @property
    def places(self) -> list[complex]:
        """The start of the path, where it bends, and its end."""
        return [self.start, *(self.corner(bend) for bend in self.bends), self.end]

    @property
    def length(self) -> float:
        """The length of the path."""
        return sum(abs(there - here) for here, there in pairwise(self.places))

    def corner(self, bend: tuple[int, int]) -> complex:
        """Return the place of a bend."""
        number, side = bend
        return (self.left, self.right)[side][number]


def shared_side(corners: list[int], beyond: list[int]) -> int:
    """The side of a face that another one shares."""
    for side in range(3):
        if corners[side] in beyond and corners[(side + 1) % 3] in beyond:
            return side
    raise AssertionError(SIDES)


def funnel(
    start: complex, end: complex, left: list[complex], right: list[complex]
) -> list[tuple[int, int]]:
    """Where the shortest path bends: the numbers of the sides, and 0 for left or 1 for right."""
    bends: list[tuple[int, int]] = []
    tip, sides, ats = start, [start, start], [-1, -1]
    number, count = 0, len(left)
    while number <= count:
        new = (left[number], right[number]) if number < count else (end, end)
        for which in (0, 1):
            sign = 1.0 if which else -1.0
            mine, other = sides[which] - tip, sides[1 - which] - tip
            turn = new[which] - tip
            # The funnel only gets narrower. A side on which the tip itself is does not limit it.
            if sides[which] != tip and sign * (mine.conjugate() * turn).imag < 0.0:
                continue
            inside = sign * (other.conjugate() * turn).imag < 0.0
            if inside or tip in (new[which], sides[1 - which]) or new[which] == sides[1 - which]:
                sides[which], ats[which] = new[which], number
                continue
            # It closes: the path bends about the other side's corner.
            tip, number = sides[1 - which], ats[1 - which]
            bends.append((number, 1 - which))
            sides, ats = [tip, tip], [number, number]
            break
        number += 1
    return bends
