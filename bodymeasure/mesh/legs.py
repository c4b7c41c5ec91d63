"""The straight legs of a shortest path over a mesh, where the distances of its vertices are known.

A shortest path is a chain of straight legs between vertices, none of which has another vertex
within. A leg from a vertex leads through a strip of faces; unfolded into the plane, the legs
through the same strip are a cone of rays from one point. A cone that a vertex lies in is split
there. The distances from the path's other end bound the length of all paths in a cone from below,
and a cone in which all are longer than the shortest path is left out. This is the search of
J. Chen and Y. Han, "Shortest paths on a polyhedron", Int. J. Comput. Geom. Appl. 6 (1996), with
the distances as its guide.
"""

from heapq import heappop, heappush
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.routes.faces import FaceMesh

# Paths that are longer than the shortest by this part of its length may be the same one, since
# distances are rounded.
ROUNDED = 1e-9
# A path that is as short as the known distance up to this part of it ends the search.
SAME = 1e-13
# The most cones that are unfolded. A path that crosses n triangles of one size takes some n^1.5.
MOST_CONES = 400_000


class _Cone(NamedTuple):
    """The straight legs from a vertex, at 0 in the plane, that enter a face by one side.

    Seen from the vertex, `first` lies to the right and `last` to the left. The rays lie between
    `right` and `left`, which are points of the plane.
    """

    face: int
    side: int
    first: complex
    last: complex
    right: complex
    left: complex
    before: "_Cone | None"


class _Leg(NamedTuple):
    """A straight leg: where it begins, where it ends in the plane, and the last cone, if any."""

    start: int
    end: complex
    cone: _Cone | None


def chain_of_legs(mesh: FaceMesh, least: Array, ends: tuple[int, int]) -> Array:
    """Return the points of the shortest path from one vertex to another, shape (k, 3).

    Parameters
    ----------
    mesh : FaceMesh
        A manifold surface.
    least : ndarray, shape (n,)
        Lower bounds of the distances of the vertices from the first end. That of the second end is
        exact. The more of them are, the less work it is.
    ends : pair of int

    Raises
    ------
    InputError
        If the search finds no path that is as short as the known distance.
    """
    source, target = ends
    search = _Search(mesh, least, target)
    search.run(source)
    if source not in search.legs:
        raise InputError(
            "no path over the mesh was found that is as short as the exact distance of its ends, "
            f"{least[target]:.6g}; some triangles may be too thin"
        )
    points, here = [mesh.vertices[source]], source
    while here != target:
        leg = search.legs[here]
        points += [*_crossings(mesh, leg), mesh.vertices[leg.start]]
        here = leg.start
    return np.array(points)


class _Search:
    """The search for legs back from a target.

    Parameters
    ----------
    mesh : FaceMesh
    least : ndarray, shape (n,)
    target : int
    """

    def __init__(self, mesh: FaceMesh, least: Array, target: int) -> None:
        self.mesh = mesh
        self.ahead: list[float] = least.tolist()
        self.behind = {target: 0.0}
        self.legs: dict[int, _Leg] = {}
        self.shortest = self.ahead[target]
        self.longest = self.shortest * (1.0 + ROUNDED)
        self.around: dict[int, list[tuple[int, int]]] = {}
        for number, corners in enumerate(mesh.faces):
            for corner, vertex in enumerate(corners):
                self.around.setdefault(vertex, []).append((number, corner))
        # The vertices and cones to go on from, those with the least way left first.
        self.queue: list[tuple[float, int, int, _Cone | None]] = []
        self.count = 0

    def run(self, source: int) -> None:
        """Find the legs of the shortest path from a source."""
        (target,) = self.behind
        self._put(self.shortest, target, None)
        while self.queue and self.count < MOST_CONES:
            _, _, start, cone = heappop(self.queue)
            if cone is None:
                self._leave(start)
            else:
                self._unfold(start, cone)
            if self.behind.get(source, np.inf) <= self.shortest * (1.0 + SAME):
                return

    def _put(self, left: float, start: int, cone: _Cone | None) -> None:
        self.count += 1
        heappush(self.queue, (left, self.count, start, cone))

    def _leave(self, vertex: int) -> None:
        """Begin legs from a vertex into all faces about it."""
        for face, corner in self.around[vertex]:
            corners, side = self.mesh.faces[face], (corner + 1) % 3
            length = float(
                np.linalg.norm(self.mesh.vertices[corners[side]] - self.mesh.vertices[vertex])
            )
            first, last = complex(length), length * self.mesh.apex[face][corner]
            self._reach(corners[side], _Leg(vertex, first, None))
            self._reach(corners[side - 2], _Leg(vertex, last, None))
            self._cross(vertex, _Cone(face, side, first, last, first, last, None))

    def _reach(self, vertex: int, leg: _Leg) -> None:
        """Note a vertex that a leg leads to, if it may be on the shortest path."""
        way = self.behind[leg.start] + abs(leg.end)
        if way + self.ahead[vertex] > self.longest:
            return
        if way < self.behind.get(vertex, np.inf) - SAME * self.shortest:
            self.behind[vertex] = way
            self.legs[vertex] = leg
            self._put(self.ahead[vertex], vertex, None)

    def _cross(self, start: int, cone: _Cone) -> None:
        """Go on with a cone over the side by which it leaves a face, if one of its paths may."""
        first, last = cone.first, cone.last
        one = _met(cone.right, first, last)
        other = _met(cone.left, first, last)
        corners = self.mesh.faces[cone.face]
        at_first, at_last = corners[cone.side], corners[(cone.side + 1) % 3]
        # The bound on the way through a corner is the least at the side's point farthest from it.
        bound = self.behind[start] + max(
            self.ahead[at_first] + abs(other) - abs(other - first),
            self.ahead[at_last] + abs(one) - abs(one - last),
        )
        if bound > self.longest or self.mesh.over[cone.face][cone.side] < 0:
            return
        self._put(self.shortest - self.behind[start] - max(abs(one), abs(other)), start, cone)

    def _unfold(self, start: int, cone: _Cone) -> None:
        """Unfold the face that a cone enters, and split the cone if the new corner lies in it."""
        mesh, first, last = self.mesh, cone.first, cone.last
        face = mesh.over[cone.face][cone.side]
        corners = mesh.faces[face]
        entered = corners.index(mesh.faces[cone.face][(cone.side + 1) % 3])
        corner = last + (first - last) * mesh.apex[face][entered]
        # The sides about the new corner: from the first to it, and from it to the last.
        near, far = (entered + 1) % 3, (entered + 2) % 3
        beyond_right, within_left = _turn(cone.right, corner), _turn(corner, cone.left)
        if beyond_right >= 0.0 and within_left >= 0.0:
            self._reach(corners[far], _Leg(start, corner, cone))
        if beyond_right > 0.0:
            left = corner if within_left > 0.0 else cone.left
            self._cross(start, _Cone(face, near, first, corner, cone.right, left, cone))
        if within_left > 0.0:
            right = corner if beyond_right > 0.0 else cone.right
            self._cross(start, _Cone(face, far, corner, last, right, cone.left, cone))


def _turn(one: complex, other: complex) -> float:
    """Positive if a ray lies to the left of another."""
    return (one.conjugate() * other).imag


def _met(ray: complex, first: complex, last: complex) -> complex:
    """The point in which a ray from 0 meets the side from one point to another."""
    return first + _part(ray, first, last) * (last - first)


def _part(ray: complex, first: complex, last: complex) -> float:
    """The part of a side at which a ray from 0 meets it."""
    before, after = _turn(first, ray), _turn(ray, last)
    whole = before + after
    return min(max(before / whole, 0.0), 1.0) if whole > 0.0 else 0.0


def _crossings(mesh: FaceMesh, leg: _Leg) -> list[Array]:
    """The points in which a leg crosses sides, from its end on."""
    points, cone = [], leg.cone
    while cone is not None:
        corners = mesh.faces[cone.face]
        first = mesh.vertices[corners[cone.side]]
        last = mesh.vertices[corners[(cone.side + 1) % 3]]
        points.append(first + _part(leg.end, cone.first, cone.last) * (last - first))
        cone = cone.before
    return points
