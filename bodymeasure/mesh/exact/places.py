"""Places on a mesh."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.mesh.arrays import TriangleMesh

# Weights below this move a place by less than the rounding of its coordinates. They would make a
# place beside a vertex or a side, from which no leg can be seen to leave, of one that is there.
ROUNDING = 4.0 * float(np.finfo(np.float64).eps)


class MeshPoint(NamedTuple):
    """A place on a mesh.

    Parameters
    ----------
    face : int
    weights : ndarray, shape (3,)
        Its barycentric coordinates there: none is negative, and their sum is 1.
    """

    face: int
    weights: Array

    @classmethod
    def at_vertex(cls, mesh: TriangleMesh, vertex: int) -> "MeshPoint":
        """Return the place of a vertex, in one of its faces."""
        face, corner = np.argwhere(mesh.faces == vertex)[0]
        return cls(int(face), np.eye(3)[corner])

    @classmethod
    def at_foot(cls, mesh: TriangleMesh, face: int, position: Array) -> "MeshPoint":
        """Return the place of a point of a face, except for rounding."""
        weights = np.maximum(barycentric(mesh.vertices[mesh.faces[face]], position), 0.0)
        return cls(face, weights / weights.sum())

    def position(self, mesh: TriangleMesh) -> Array:
        """Return its coordinates, shape (3,)."""
        return np.asarray(self.weights @ mesh.vertices[mesh.faces[self.face]])

    @property
    def rounded(self) -> "MeshPoint":
        """The same place at a vertex or on a side, if it is there except for rounding."""
        weights = np.where(self.weights > ROUNDING, self.weights, 0.0)
        return MeshPoint(self.face, weights / weights.sum())

    def vertex(self, mesh: TriangleMesh) -> int:
        """Return the vertex that it is; -1 if it is none."""
        away = np.flatnonzero(self.weights)
        return int(mesh.faces[self.face, away[0]]) if len(away) == 1 else -1


def barycentric(corners: Array, position: Array) -> Array:
    """Return the barycentric coordinates (3,) of a point's foot in a triangle (3, 3)."""
    sides = np.stack([corners[1] - corners[0], corners[2] - corners[0]], axis=1)
    second, third = np.linalg.lstsq(sides, position - corners[0], rcond=None)[0]
    return np.array([1.0 - second - third, second, third])
