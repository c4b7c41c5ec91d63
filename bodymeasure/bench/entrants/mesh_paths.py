"""Lengths on a triangle mesh of a patch, by libigl, potpourri3d and pygeodesic.

The mesh is made beforehand; the time of a library includes what it builds from the mesh for one
pair of points.
"""

import numpy as np

from bodymeasure.bench.entrants.meshed_patch import MeshedPatch
from bodymeasure.oracle.libigl import exact_distance, heat_distances


def igl_exact(mesh: MeshedPatch) -> float:
    """Return libigl's exact distance over the polyhedron (Mitchell, Mount and Papadimitriou)."""
    return exact_distance(mesh.vertices, mesh.faces, mesh.source, mesh.target)


def igl_heat(mesh: MeshedPatch) -> float:
    """Return libigl's distance by the heat method, the factorization included."""
    sources = np.array([mesh.source])
    return float(heat_distances(mesh.vertices, mesh.faces, sources)[0, mesh.target])


def fast_marching(mesh: MeshedPatch) -> float:
    """Return potpourri3d's distance by fast marching, the paper's reference [7]."""
    from potpourri3d import MeshFastMarchingDistanceSolver

    solver = MeshFastMarchingDistanceSolver(mesh.vertices, mesh.faces)
    return float(solver.compute_distance([[(mesh.source, [])]])[mesh.target])


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
