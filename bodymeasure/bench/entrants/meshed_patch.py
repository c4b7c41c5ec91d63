"""A patch as a triangle mesh, which methods on meshes are given."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.bezier import derivatives
from bodymeasure.oracle.grid import PatchGrid


@dataclass(frozen=True, eq=False)
class MeshedPatch:
    """A patch as triangles on an even grid, and the vertices to be joined.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    faces : ndarray of int, shape (f, 3)
    source, target : int
    net : ndarray, shape (4, 4, 3)
    parameters : ndarray, shape (n, 2)
        The (u, v) of the vertices.
    points : int
        The number of points a side.
    """

    vertices: Array
    faces: Ints
    source: int
    target: int
    net: Array
    parameters: Array
    points: int

    @classmethod
    def of(cls, net: Array, start: Array, end: Array, points: int) -> "MeshedPatch":
        """Return a patch with `points` points a side; the ends are at the nearest of them."""
        side = np.linspace(0.0, 1.0, points)
        grid = PatchGrid(side, side)
        vertices, faces, number = grid.mesh(net)
        source, target = (int(number[grid.vertex(point)]) for point in (start, end))
        _, first = np.unique(number, return_index=True)
        parameters = np.stack(np.divmod(first, points), axis=-1) / (points - 1.0)
        return cls(vertices, faces, source, target, net, parameters, points)

    @cached_property
    def normals(self) -> Array:
        """The unit normals of the surface at the vertices, shape (n, 3)."""
        jet = derivatives(self.net, self.parameters, order=1)
        normals = np.cross(jet[:, 1, 0], jet[:, 0, 1])
        return np.asarray(normals / np.linalg.norm(normals, axis=1, keepdims=True))
