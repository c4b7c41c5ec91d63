"""Lengths on a triangle mesh of a patch, by libigl, potpourri3d and pygeodesic.

The mesh is made beforehand; the time of a library includes what it builds from the mesh for one
pair of points.
"""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.oracle.grid import PatchGrid
from bodymeasure.oracle.libigl import exact_distance, heat_distances


@dataclass(frozen=True, eq=False)
class MeshedPatch:
    """A patch as triangles on an even grid, and the vertices to be joined.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    faces : ndarray of int, shape (f, 3)
    source, target : int
    """

    vertices: Array
    faces: Ints
    source: int
    target: int

    @classmethod
    def of(cls, net: Array, start: Array, end: Array, points: int) -> "MeshedPatch":
        """Return a patch with `points` points a side; the ends are at the nearest of them."""
        side = np.linspace(0.0, 1.0, points)
        grid = PatchGrid(side, side)
        vertices, faces, number = grid.mesh(net)
        source, target = (int(number[grid.vertex(point)]) for point in (start, end))
        return cls(vertices, faces, source, target)


def igl_exact(mesh: MeshedPatch) -> float:
    """Return libigl's exact distance over the polyhedron (Mitchell, Mount and Papadimitriou)."""
    return exact_distance(mesh.vertices, mesh.faces, mesh.source, mesh.target)


def igl_heat(mesh: MeshedPatch) -> float:
    """Return libigl's distance by the heat method, the factorization included."""
    sources = np.array([mesh.source])
    return float(heat_distances(mesh.vertices, mesh.faces, sources)[0, mesh.target])


def edge_flips(mesh: MeshedPatch) -> float:
    """Return potpourri3d's locally shortest path by edge flips, from Dijkstra's along the edges."""
    from potpourri3d import EdgeFlipGeodesicSolver

    solver = EdgeFlipGeodesicSolver(mesh.vertices, mesh.faces)
    path = solver.find_geodesic_path(mesh.source, mesh.target)
    return float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())


def pygeodesic_exact(mesh: MeshedPatch) -> float:
    """Return pygeodesic's exact distance over the polyhedron, by the same algorithm as libigl."""
    from pygeodesic.geodesic import PyGeodesicAlgorithmExact

    solver = PyGeodesicAlgorithmExact(mesh.vertices, mesh.faces)
    distance, _ = solver.geodesicDistance(mesh.source, mesh.target)
    return np.nan if distance is None else float(distance)
