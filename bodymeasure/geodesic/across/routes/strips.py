"""Strips of triangles over the mesh of an atlas, in which ways are pulled straight.

A way along the mesh's edges becomes a strip of faces. Unfolded into a plane, the shortest path
within it is found by a funnel (D. T. Lee, F. P. Preparata, "Euclidean shortest paths in the
presence of rectilinear barriers", Networks 14 (1984)). Where it bends about a vertex, and the
angle on the other side is less than two right ones, the strip is led round that side, until no
such vertex is left (S.-Q. Xin, G.-J. Wang, "Efficiently determining a locally exact shortest path
on polyhedral surfaces", Computer-Aided Design 39 (2007)). So a way is pulled tight without ever
jumping over an obstacle.
"""

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.across.routes.faces import FaceMesh, OnFace
from bodymeasure.native import is_compiled, unfolded

# The most rounds in which strips are led round vertices. Some three are usual.
MOST_ROUNDS = 60
# The other side of a vertex is shorter if its angle is less than two right ones by this.
STRAIGHT = 1e-9
# Rounds that make the way shorter by less than this part of it are only rounding.
SHORTER = 1e-12
SIDES = "faces in a row share a side"


@dataclass(frozen=True, eq=False)
class StraightWay:
    """The shortest path within a strip of faces.

    Parameters
    ----------
    ends : pair of OnFace
        Its start, on the first face, and its end, on the last one.
    strip : list of int
        The faces that it crosses, in order.
    sides : list of int
        The side by which it leaves each of them but the last.
    along : list of float
        Where it crosses that side: 0 at its first corner, 1 at its second.
    length : float
        On the mesh.
    """

    ends: tuple[OnFace, OnFace]
    strip: list[int]
    sides: list[int]
    along: list[float]
    length: float

    def points(self, mesh: FaceMesh) -> Array:
        """Return the positions of its ends and of where it crosses sides, shape (k, 3)."""
        corners = np.array([mesh.faces[face] for face in self.strip])
        at = np.arange(len(self.sides))
        side = np.array(self.sides, dtype=np.int64)
        first, last = corners[at, side], corners[at, (side + 1) % 3]
        t = np.array(self.along)[:, None]
        inner = (1.0 - t) * mesh.vertices[first] + t * mesh.vertices[last]
        outer = [np.array(end.weights) @ mesh.vertices[mesh.faces[end.face]] for end in self.ends]
        return np.stack([outer[0], *inner, outer[1]])


def straight_way(
    mesh: FaceMesh, ends: tuple[OnFace, OnFace], vertices: Sequence[int]
) -> StraightWay | None:
    """Return the way along a mesh's edges, pulled straight.

    Parameters
    ----------
    mesh : FaceMesh
    ends : pair of OnFace
    vertices : sequence of int
        From a corner of the face that holds the start to a corner of the one that holds the end,
        each joined to the next by an edge.

    Returns
    -------
    StraightWay or None
        None if the faces about a vertex do not hang together, so that no strip leads past it.
    """
    faces = _strip_along(mesh, vertices, ends[0].face, ends[1].face)
    if faces is None:
        return None
    strip = _trimmed(mesh, faces, ends)
    way = _Unfolded.of(mesh, strip)
    for _ in range(MOST_ROUNDS):
        changed = _led_round(mesh, strip.faces, way)
        if changed is None:
            break
        shorter = _trimmed(mesh, changed, (strip.start, strip.end))
        other = _Unfolded.of(mesh, shorter)
        if other.length > way.length * (1.0 - SHORTER):
            break
        strip, way = shorter, other
    return way.straight(mesh, strip)


class _Strip(NamedTuple):
    """Faces in a row, and the ends of a path on the first and the last of them."""

    faces: list[int]
    start: OnFace
    end: OnFace


def _trimmed(mesh: FaceMesh, faces: list[int], ends: tuple[OnFace, OnFace]) -> _Strip:
    """The strip without faces of which a path only has a point, where an end lies on a side."""
    start, end = ends
    first, last = 0, len(faces) - 1
    while first < last:
        beyond = _on_next(mesh, start, faces[first + 1])
        if beyond is None:
            break
        start, first = beyond, first + 1
    while first < last:
        beyond = _on_next(mesh, end, faces[last - 1])
        if beyond is None:
            break
        end, last = beyond, last - 1
    return _Strip(faces[first : last + 1], start, end)


def _on_next(mesh: FaceMesh, place: OnFace, face: int) -> OnFace | None:
    """The same point on the next face, if it lies exactly on the side between both."""
    weights = dict(zip(mesh.faces[place.face], place.weights, strict=True))
    shared = [weights.pop(corner, 0.0) for corner in mesh.faces[face]]
    return OnFace(face, shared) if not any(weights.values()) else None


def _strip_along(
    mesh: FaceMesh, vertices: Sequence[int], first: int, last: int
) -> list[int] | None:
    """The faces along edges of the mesh, from the first face to the last one."""
    strip = [first]
    for number, vertex in enumerate(vertices):
        to = vertices[number + 1] if number + 1 < len(vertices) else -1
        turned = mesh.turned(vertex, strip[-1], last, to)
        if turned is None:
            return None
        strip += turned[1:]
    return _without_returns(strip)


def _without_returns(strip: list[int]) -> list[int]:
    """The strip without faces that it only enters and leaves by the same side."""
    result: list[int] = []
    for face in strip:
        if result and result[-1] == face:
            continue
        if len(result) > 1 and result[-2] == face:
            result.pop()
        else:
            result.append(face)
    return result


@dataclass(frozen=True, eq=False)
class _Unfolded:
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
    def of(cls, mesh: FaceMesh, strip: _Strip) -> "_Unfolded":
        """Unfold a strip."""
        first = mesh.faces[strip.faces[0]]
        scale = float(np.linalg.norm(mesh.vertices[first[1]] - mesh.vertices[first[0]]))
        if is_compiled():
            return cls._compiled(mesh, strip, scale)
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
            side = _shared(corners, beyond)
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
        return cls(start, end, sides, names, left, right, _funnel(start, end, left, right))

    @classmethod
    def _compiled(cls, mesh: FaceMesh, strip: _Strip, scale: float) -> "_Unfolded":
        """What `of` returns, by compiled kernels."""
        weights = np.array(strip.start.weights), np.array(strip.end.weights)
        found = unfolded(mesh.arrays, np.array(strip.faces), scale, weights)
        assert found is not None, SIDES
        start, end = found.ends.tolist()
        names, bends = ([(a, b) for a, b in rows.tolist()] for rows in (found.names, found.bends))
        left, right = found.left.tolist(), found.right.tolist()
        return cls(start, end, found.sides.tolist(), names, left, right, bends)

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

    def straight(self, mesh: FaceMesh, strip: _Strip) -> StraightWay:
        """Return the shortest path within the strip."""
        places = self.places
        numbers = [*(number for number, _ in self.bends), len(self.left)]
        along, leg = [], 0
        for number, (a, b) in enumerate(zip(self.left, self.right, strict=True)):
            while number > numbers[leg]:
                leg += 1
            p, q = places[leg], places[leg + 1]
            # A path along a side is on it everywhere: it may count as crossing at either corner.
            if p in (a, b):
                t = float(p == b)
            elif number == numbers[leg]:
                t = float(q == b)
            else:
                across = ((q - p).conjugate() * (b - a)).imag
                t = -((q - p).conjugate() * (a - p)).imag / across if across else 0.0
                t = min(max(t, 0.0), 1.0)
            forwards = mesh.faces[strip.faces[number]][self.sides[number]] == self.names[number][0]
            along.append(t if forwards else 1.0 - t)
        ends = strip.start, strip.end
        return StraightWay(ends, strip.faces, self.sides, along, self.length)


def _shared(corners: list[int], beyond: list[int]) -> int:
    """The side of a face that another one shares."""
    for side in range(3):
        if corners[side] in beyond and corners[(side + 1) % 3] in beyond:
            return side
    raise AssertionError(SIDES)


def _funnel(
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


def _led_round(mesh: FaceMesh, strip: list[int], way: _Unfolded) -> list[int] | None:
    """The strip led round the other side of vertices where that is shorter; None if nowhere."""
    result: list[int] = []
    done = 0
    places = way.places
    for number, (at, side) in enumerate(way.bends):
        vertex = way.names[at][side]
        first = last = at
        while first > 0 and way.names[first - 1][side] == vertex:
            first -= 1
        while last + 1 < len(way.names) and way.names[last + 1][side] == vertex:
            last += 1
        if first < done:
            continue
        before, there, after = places[number : number + 3]
        if there in (before, after):
            # An end lies in the vertex.
            continue
        bend = abs(cmath.phase((before - there) * (after - there).conjugate()))
        # The path bends towards the strip's outside, whose angle is what the strip leaves of all.
        if not mesh.angle[vertex] - (2.0 * math.pi - bend) < math.pi - STRAIGHT:
            continue
        round_ = _other_side(mesh, vertex, strip[first : last + 2])
        if round_ is None:
            continue
        result += strip[done:first]
        result += round_
        done = last + 2
    if not done:
        return None
    return _without_returns(result + strip[done:])


def _other_side(mesh: FaceMesh, vertex: int, faces: list[int]) -> list[int] | None:
    """The faces about a vertex from the first of some to the last, round the other way."""
    here, goal = faces[0], faces[-1]
    came = _shared(mesh.faces[here], mesh.faces[faces[1]])
    result = [here]
    while here != goal or len(result) == 1:
        corners = mesh.faces[here]
        (side,) = (
            each
            for each in range(3)
            if each != came and vertex in (corners[each], corners[(each + 1) % 3])
        )
        there = mesh.over[here][side]
        if there < 0 or len(result) > MOST_ROUNDS:
            return None
        came = mesh.over[there].index(here) if mesh.over[there].count(here) == 1 else -1
        if came < 0:
            return None
        result.append(there)
        here = there
    return result
