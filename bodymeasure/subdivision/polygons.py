"""Quads instead of polygons, by one step of Catmull-Clark subdivision."""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.subdivision.polygon_mesh import PolygonMesh
from bodymeasure.subdivision.sums import sum_at


def quads_of(mesh: PolygonMesh) -> tuple[PolygonMesh, Ints]:
    """Return a mesh of quads with the same limit surface, which may be the mesh itself.

    Parameters
    ----------
    mesh : PolygonMesh

    Returns
    -------
    mesh : PolygonMesh
        Otherwise each face of k corners becomes k quads, which begin at its corners.
    face : ndarray of int, shape (quads,)
        The face that each comes from.

    Notes
    -----
    E. Catmull and J. Clark (1978); creases and corners as in H. Biermann, A. Levin and D. Zorin,
    "Piecewise smooth subdivision surfaces with normal control", SIGGRAPH 2000.
    """
    if (mesh.sizes == 4).all():
        return mesh, np.arange(len(mesh.sizes))
    return refined(mesh), mesh.face


def refined(mesh: PolygonMesh) -> PolygonMesh:
    """Do one step of Catmull-Clark subdivision: each face of k corners becomes k quads in order."""
    count = len(mesh.vertices)
    edge_number = count + mesh.edge
    face_number = count + len(mesh.ends) + mesh.face
    quads = [mesh.corners, edge_number, face_number, edge_number[mesh.preceding]]
    middle = count + np.arange(len(mesh.ends))
    halves = [np.stack([end, middle], axis=-1) for end in mesh.ends.T]
    creases = np.concatenate([half[mesh.sharp & (mesh.sides == 2)] for half in halves])
    return PolygonMesh.unchecked(
        refined_vertices(mesh),
        np.stack(quads, axis=-1).ravel(),
        np.full(len(mesh.corners), 4),
        creases,
        tagged=mesh.tagged,
        rounded=mesh.rounded,
    )


def refined_vertices(mesh: PolygonMesh) -> Array:
    """Return the vertices of the mesh that `refined` makes: moved ones, edge and face points."""
    face_points = sum_at(mesh.face, mesh.vertices[mesh.corners], len(mesh.sizes))
    face_points /= mesh.sizes[:, None]
    midpoints = mesh.vertices[mesh.ends].mean(axis=1)
    across = sum_at(mesh.edge, face_points[mesh.face], len(mesh.ends)) / 2.0
    edge_points = np.where(mesh.sharp[:, None], midpoints, (midpoints + across) / 2.0)
    return np.concatenate([_moved(mesh, face_points, midpoints), edge_points, face_points])


def _moved(mesh: PolygonMesh, face_points: Array, midpoints: Array) -> Array:
    """Return the vertices in their new places."""
    count = len(mesh.vertices)
    # Round an inner vertex there are as many faces as edges.
    valence = np.maximum(np.bincount(mesh.corners, minlength=count), 1)[:, None]
    face_mean = sum_at(mesh.corners, face_points[mesh.face], count) / valence
    edge_mean = sum_at(mesh.ends.ravel(), np.repeat(midpoints, 2, axis=0), count) / valence
    moved = (face_mean + 2.0 * edge_mean + (valence - 3.0) * mesh.vertices) / valence
    ends = mesh.ends[mesh.sharp]
    neighbors = sum_at(ends.ravel(), mesh.vertices[ends[:, ::-1]].reshape(-1, 3), count)
    curve = (6.0 * mesh.vertices + neighbors) / 8.0
    moved = np.where(mesh.crease_vertices[:, None], curve, moved)
    return np.where(mesh.corner_vertices[:, None], mesh.vertices, moved)
