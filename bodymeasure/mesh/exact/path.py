"""The exact shortest path over a mesh between two places."""

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.mesh.arrays import TriangleMesh, face_spheres, part_of
from bodymeasure.mesh.exact.places import MeshPoint
from bodymeasure.mesh.exact.search import Search
from bodymeasure.mesh.exact.sides import Sides
from bodymeasure.mesh.exact.trace import traced

# The room for rounding in the bound on what a shortest path can reach.
ROOM = 1e-9


def exact_path(mesh: TriangleMesh, start: MeshPoint, end: MeshPoint) -> Array:
    """Return the shortest path over a mesh from one place to another, shape (k, 3).

    Parameters
    ----------
    mesh : TriangleMesh
        An oriented manifold of triangles with areas, with or without a boundary. Faces may touch in
        a vertex alone.
    start, end : MeshPoint

    Returns
    -------
    ndarray, shape (k, 3)
        The ends, and the points where the path crosses sides. Its chain is on the mesh, so that it
        is never too short, but for rounding.

    Raises
    ------
    InputError
        If no edges join the two.
    ConvergenceError
        If the search ends before the path is known to be the shortest.

    Notes
    -----
    No path that is as short as the shortest along the edges leaves the ellipsoid about the two
    points whose axis is that long; faces that are wholly outside are left out.
    """
    start, end = start.rounded, end.rounded
    ends = np.array([start.position(mesh), end.position(mesh)])
    if start.face == end.face:
        return ends
    along = _along_edges(mesh, start)
    corners = mesh.faces[end.face]
    away = np.linalg.norm(mesh.vertices[corners] - ends[1], axis=1)
    longest = float((along[corners] + away).min())
    if not np.isfinite(longest):
        raise InputError(
            "the two points lie on parts of the mesh that no edges join; choose points on one "
            "part, or merge the vertices that should be one (trimesh: merge_vertices, pyvista: "
            "clean)"
        )
    # A path may cross a large face whose vertices are all outside. No point of a face has a sum of
    # distances that is less than the center's by more than twice the radius of the face's sphere.
    center, radius = face_spheres(mesh)
    way = np.linalg.norm(center[:, None] - ends, axis=2).sum(axis=1)
    keep = way - 2.0 * radius <= longest * (1.0 + ROOM)
    keep[[start.face, end.face]] = True
    part, used = part_of(mesh, keep)
    number = np.cumsum(keep) - 1
    first, last = (place._replace(face=int(number[place.face])) for place in (start, end))
    search = Search(Sides.of(part), first, last, along[used])
    search.run()
    return traced(search)


def _along_edges(mesh: TriangleMesh, place: MeshPoint) -> Array:
    """Return the lengths of the shortest paths along edges from a place to all vertices (n,).

    They are infinite where there is none.
    """
    count = len(mesh.vertices)
    first, last = mesh.faces.ravel(), np.roll(mesh.faces, -1, axis=1).ravel()
    # Edges of two faces appear twice; a set of rows would add them up.
    low, high = np.divmod(
        np.unique(np.minimum(first, last) * count + np.maximum(first, last)), count
    )
    length = np.linalg.norm(mesh.vertices[low] - mesh.vertices[high], axis=1)
    # The place is one more node, joined to the corners of its face.
    corners = mesh.faces[place.face]
    away = np.linalg.norm(mesh.vertices[corners] - place.position(mesh), axis=1)
    low, high = np.append(low, corners), np.append(high, np.full(3, count))
    graph = scipy.sparse.csr_array(
        (np.append(length, away), (low, high)), shape=(count + 1, count + 1)
    )
    distance = scipy.sparse.csgraph.dijkstra(graph, directed=False, indices=count)
    return np.asarray(distance[:count], dtype=np.float64)
