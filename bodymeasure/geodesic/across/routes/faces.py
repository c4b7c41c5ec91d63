"""Triangle meshes with what lies beside each face, as searches over them need it."""

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Complex, Ints
from bodymeasure.native import MeshArrays

# The square of an edge's length is taken as at least this, so that none divides by zero.
SHORTEST = 1e-300


class OnFace(NamedTuple):
    """A point of a mesh: a face that holds it, and its barycentric coordinates there."""

    face: int
    weights: Sequence[float]


@dataclass(frozen=True, eq=False)
class FaceMesh:
    """A triangle mesh, and what lies beside each of its faces.

    The side of a face with number k joins its corners k and k + 1.

    Parameters
    ----------
    arrays : MeshArrays
        The vertices; the three vertices of each face; the face beyond each side of a face, -1 where
        there is none, or more than one; where the third corner of a face lies, seen from each of
        its sides, which leads from 0 to 1 with the corner above it; and the sum of the angles about
        each vertex, infinite on the boundary and where faces fork.
    forks : dict of (int, int) to list of int
        The other faces beyond a side, by face and side, where there are several.
    """

    arrays: MeshArrays
    forks: dict[tuple[int, int], list[int]]

    @classmethod
    def of_faces(cls, vertices: Array, faces: Ints) -> "FaceMesh":
        """Return the mesh of faces, an array of shape (f, 3)."""
        over, forks, single = _beyond(faces, len(vertices))
        apex, angle = _shapes(vertices, faces)
        about = np.bincount(faces.ravel(), angle.ravel(), len(vertices)).astype(np.float64)
        about[single] = np.inf
        faces, over = (np.ascontiguousarray(each, np.int64) for each in (faces, over))
        apex, vertices = np.ascontiguousarray(apex), np.ascontiguousarray(vertices)
        return FaceMesh(MeshArrays(faces, over, apex, about, vertices), forks)

    @property
    def vertices(self) -> Array:
        """The positions of the vertices, shape (n, 3)."""
        return self.arrays.vertices

    # What searches read face by face is kept in lists, too, which Python reads faster than arrays.

    @cached_property
    def faces(self) -> list[list[int]]:
        """The three vertices of each face."""
        faces: list[list[int]] = self.arrays.faces.tolist()
        return faces

    @cached_property
    def over(self) -> list[list[int]]:
        """The face beyond each side of a face."""
        over: list[list[int]] = self.arrays.over.tolist()
        return over

    @cached_property
    def apex(self) -> list[list[complex]]:
        """Where the third corner of a face lies."""
        apex: list[list[complex]] = self.arrays.apex.tolist()
        return apex

    @cached_property
    def angle(self) -> list[float]:
        """The sum of the angles about each vertex."""
        angle: list[float] = self.arrays.angle.tolist()
        return angle

    def beyond(self, face: int, side: int) -> Sequence[int]:
        """Return all faces beyond a side of a face."""
        there = self.over[face][side]
        return (there,) if there >= 0 else self.forks.get((face, side), ())

    def turned(self, vertex: int, face: int, last: int, to: int) -> list[int] | None:
        """Return the fewest faces about a vertex that lead from one of them to another.

        Parameters
        ----------
        vertex, face : int
        last : int
            The face to which they lead, unless `to` is given.
        to : int
            A vertex, which the face has to which they lead; or -1.

        Returns
        -------
        list of int or None
            From the face itself on; None if no such face is joined to it.
        """
        before = {face: -1}
        queue = deque([face])
        while queue:
            here = queue.popleft()
            if here == last if to < 0 else to in self.faces[here]:
                way = [here]
                while before[way[-1]] >= 0:
                    way.append(before[way[-1]])
                return way[::-1]
            corners = self.faces[here]
            for side in range(3):
                if corners[side] == vertex or corners[side - 2] == vertex:
                    for there in self.beyond(here, side):
                        if there not in before:
                            before[there] = here
                            queue.append(there)
        return None


def _beyond(faces: Ints, count: int) -> tuple[Ints, dict[tuple[int, int], list[int]], Bools]:
    """The face beyond each side, the faces where several are, and the vertices on such sides.

    Those on the boundary are among these vertices.
    """
    first, last = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    low, high = np.minimum(first, last), np.maximum(first, last)
    _, edge, uses = np.unique(low * count + high, return_inverse=True, return_counts=True)
    order = np.argsort(edge, kind="stable")
    begins = np.cumsum(uses) - uses
    over = np.full(len(edge), -1)
    pairs = begins[uses == 2]
    one, other = order[pairs], order[pairs + 1]
    over[one], over[other] = other // 3, one // 3
    forks = {}
    for number in np.flatnonzero(uses > 2):
        sides = order[begins[number] : begins[number] + uses[number]].tolist()
        for side in sides:
            forks[divmod(side, 3)] = [each // 3 for each in sides if each != side]
    single = np.zeros(count, bool)
    odd = (uses != 2)[edge]
    single[first[odd]] = single[last[odd]] = True
    return over.reshape(-1, 3), forks, single


def _shapes(vertices: Array, faces: Ints) -> tuple[Complex, Array]:
    """The third corner of each face as seen from each side, and the angles at its corners."""
    corner = vertices[faces]
    side = np.roll(corner, -1, axis=1) - corner
    third = np.roll(corner, -2, axis=1) - corner
    square = np.maximum((side * side).sum(axis=2), SHORTEST)
    along, off = (side * third).sum(axis=2), np.linalg.norm(np.cross(side, third), axis=2)
    return (along + 1j * off) / square, np.arctan2(off, along)
