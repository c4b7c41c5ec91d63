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

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.across.routes.faces import FaceMesh, OnFace
from bodymeasure.geodesic.across.routes.unfolding import Strip, Unfolded, shared_side
from bodymeasure.native import WayFound, is_compiled, way_straightened

# The most rounds in which strips are led round vertices. Some three are usual.
MOST_ROUNDS = 60
# The other side of a vertex is shorter if its angle is less than two right ones by this.
STRAIGHT = 1e-9
# Rounds that make the way shorter by less than this part of it are only rounding.
SHORTER = 1e-12


@dataclass(frozen=True, eq=False)
class StraightWay:
    """The shortest path within a strip of faces.

    Parameters
    ----------
    ends : pair of OnFace
        Its start, on the first face, and its end, on the last one.
    strip : ndarray of int
        The faces that it crosses, in order.
    sides : ndarray of int
        The side by which it leaves each of them but the last.
    along : ndarray
        Where it crosses that side: 0 at its first corner, 1 at its second.
    length : float
        On the mesh.
    """

    ends: tuple[OnFace, OnFace]
    strip: Ints
    sides: Ints
    along: Array
    length: float

    @classmethod
    def of(cls, found: WayFound) -> "StraightWay":
        """Return a way that a kernel found."""
        strip, sides, along, length, weights = found
        start, end = map(OnFace, strip[[0, -1]].tolist(), weights)
        return cls((start, end), strip, sides, along, length)

    def points(self, mesh: FaceMesh) -> Array:
        """Return the positions of its ends and of where it crosses sides, shape (k, 3)."""
        faces = mesh.arrays.faces
        corners = faces[self.strip]
        at, side, t = np.arange(len(self.sides)), self.sides, self.along[:, None]
        first, last = corners[at, side], corners[at, (side + 1) % 3]
        inner = (1.0 - t) * mesh.vertices[first] + t * mesh.vertices[last]
        outer = [np.array(end.weights) @ mesh.vertices[faces[end.face]] for end in self.ends]
        return np.vstack([outer[0], inner, outer[1]])


def straight_way(mesh: FaceMesh, ends: tuple[OnFace, OnFace], vertices: Ints) -> StraightWay | None:
    """Return the way along a mesh's edges, pulled straight.

    Parameters
    ----------
    mesh : FaceMesh
    ends : pair of OnFace
    vertices : ndarray of int
        From a corner of the face that holds the start to a corner of the one that holds the end,
        each joined to the next by an edge, or the same.

    Returns
    -------
    StraightWay or None
        None if the faces about a vertex do not hang together, so that no strip leads past it.
    """
    if is_compiled() and not mesh.forks:
        start, end = ends
        on, weights = (start.face, end.face), (start.weights, end.weights)
        found = way_straightened(mesh.arrays, on, weights, vertices)
        if isinstance(found, WayFound):
            return StraightWay.of(found)
        if found == 0:
            return None
    faces = _strip_along(mesh, vertices.tolist(), ends[0].face, ends[1].face)
    if faces is None:
        return None
    strip = _trimmed(mesh, faces, ends)
    way = Unfolded.of(mesh, strip)
    for _ in range(MOST_ROUNDS):
        changed = _led_round(mesh, strip.faces, way)
        if changed is None:
            break
        shorter = _trimmed(mesh, changed, (strip.start, strip.end))
        other = Unfolded.of(mesh, shorter)
        if other.length > way.length * (1.0 - SHORTER):
            break
        strip, way = shorter, other
    return _straight(mesh, strip, way)


def _straight(mesh: FaceMesh, strip: Strip, way: Unfolded) -> StraightWay:
    """Return the shortest path within the strip."""
    places = way.places
    numbers = [*(number for number, _ in way.bends), len(way.left)]
    along, leg = [], 0
    for number, (a, b) in enumerate(zip(way.left, way.right, strict=True)):
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
        forwards = mesh.faces[strip.faces[number]][way.sides[number]] == way.names[number][0]
        along.append(t if forwards else 1.0 - t)
    ends = strip.start, strip.end
    arrays = np.array(strip.faces), np.array(way.sides, np.int64), np.array(along)
    return StraightWay(ends, *arrays, way.length)


def _trimmed(mesh: FaceMesh, faces: list[int], ends: tuple[OnFace, OnFace]) -> Strip:
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
    return Strip(faces[first : last + 1], start, end)


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


def _led_round(mesh: FaceMesh, strip: list[int], way: Unfolded) -> list[int] | None:
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
    came = shared_side(mesh.faces[here], mesh.faces[faces[1]])
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
