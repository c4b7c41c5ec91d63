"""The limit of a vertex at which a crease ends, a dart, on a Catmull-Clark surface."""

from functools import lru_cache

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.subdivision.polygon_mesh import PolygonMesh


def dart_limits(mesh: PolygonMesh) -> tuple[Ints, Array]:
    """Return the darts of a mesh of quads and their limits on its surface.

    Returns
    -------
    vertices : ndarray of int, shape (darts,)
    limits : ndarray, shape (darts, 3)

    Notes
    -----
    One step of subdivision takes a dart and the ring of quads round it to a ring of the same kind.
    The weights of the limit are the left eigenvector of that step for the eigenvalue 1: M.
    Halstead, M. Kass, T. DeRose, *Efficient, fair interpolation using Catmull-Clark surfaces*,
    SIGGRAPH 1993, section 4.1.
    """
    (starts,) = np.nonzero(mesh.sharp[mesh.edge] & mesh.darts[mesh.corners])
    if not len(starts):
        return starts, np.empty((0, 3))
    limits = [_limit(mesh, mesh.twin, start) for start in starts.tolist()]
    return mesh.corners[starts], np.array(limits)


def _limit(mesh: PolygonMesh, twin: Ints, start: int) -> Array:
    """The limit of the vertex from which the sharp half-edge `start` leads."""
    around = [start]
    while (following := int(twin[mesh.preceding[around[-1]]])) != start:
        around.append(following)
    opposite = mesh.heads[mesh.following[around]]
    ring = np.concatenate([mesh.corners[[start]], mesh.heads[around], opposite])
    return np.asarray(_weights(len(around)) @ mesh.vertices[ring])


@lru_cache(maxsize=64)
def _weights(valence: int) -> Array:
    """The weights of the dart, its neighbors along edges, the sharp one first, and the opposites.

    Shape (2 valence + 1,); the opposite corner of each quad comes between its two neighbors.
    """
    vertex, k = np.eye(2 * valence + 1)[0], np.arange(valence)
    edges, opposites = np.split(np.eye(2 * valence + 1)[1:], 2)
    face_points = (vertex + edges + edges[(k + 1) % valence] + opposites) / 4.0
    edge_points = (vertex + edges + face_points + face_points[k - 1]) / 4.0
    edge_points[0] = (vertex + edges[0]) / 2.0
    moved = face_points.mean(axis=0) + edges.mean(axis=0) + (valence - 2.0) * vertex
    step = np.concatenate([moved[None] / valence, edge_points, face_points])
    values, vectors = np.linalg.eig(step.T)
    weights = vectors[:, np.argmin(np.abs(values - 1.0))].real
    return np.asarray(weights / weights.sum())
