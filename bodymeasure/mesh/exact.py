"""Exact shortest paths over a mesh between two of its vertices."""

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.components import connected_components
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.routes.faces import FaceMesh
from bodymeasure.mesh.arrays import TriangleMesh, face_spheres, part_of
from bodymeasure.mesh.legs import chain_of_legs
from bodymeasure.oracle.libigl import exact_distances

# The room for rounding in the bound on what a shortest path can reach.
ROOM = 1e-9
# Exact distances are taken of the vertices through which ways along edges are longer than the
# shortest by this part of it at most. Which these are concerns the work only.
BESIDE = 0.2


def exact_path(mesh: TriangleMesh, source: int, target: int) -> Array:
    """Return the shortest path from one vertex to another, shape (k, 3).

    Parameters
    ----------
    mesh : TriangleMesh
        A mesh that `bodymeasure.oracle.validate_mesh` accepts.
    source, target : int

    Raises
    ------
    InputError
        If no edges join the two, or libigl cannot measure this mesh, although it is valid.
    MissingExtraError
        If libigl is not installed.

    Notes
    -----
    J. Mitchell, D. Mount and C. Papadimitriou, "The discrete geodesic problem", SIAM J. Comput. 16
    (1987). No path that is as short as the shortest along the edges leaves the ellipsoid about the
    two points whose axis is that long; faces that are wholly outside are left out. libigl gives the
    exact distances of vertices, and `bodymeasure.mesh.legs` the path that is as short.
    """
    if source == target:
        return mesh.vertices[[source]]
    along = _along_edges(mesh, [source, target])
    longest = float(along[0, target])
    if not np.isfinite(longest):
        raise InputError(
            "the two points lie on parts of the mesh that no edges join; choose points on one "
            "part, or merge the vertices that should be one (trimesh: merge_vertices, pyvista: "
            "clean)"
        )
    # A path may cross a large face whose vertices are all outside. No point of a face has a sum of
    # distances that is less than the center's by more than twice the radius of the face's sphere.
    center, radius = face_spheres(mesh)
    way = np.linalg.norm(center - mesh.vertices[source], axis=1)
    way += np.linalg.norm(center - mesh.vertices[target], axis=1)
    part, used = part_of(mesh, way - 2.0 * radius <= longest * (1.0 + ROOM))
    # Where faces are left out, parts may hang together by a vertex alone, at which libigl stops.
    joined = _faces_joined_to(part, int(np.searchsorted(used, source)))
    part, kept = part_of(part, joined)
    used = used[kept]
    first, last = (int(np.searchsorted(used, number)) for number in (source, target))
    # libigl's tolerances are lengths. A power of 2 rounds nothing.
    scale = float(np.ldexp(1.0, np.frexp(longest)[1]))
    vertices = part.vertices / scale
    # The distance through the air is no longer than that over the mesh.
    least = np.linalg.norm(vertices - vertices[first], axis=1)
    beside = np.flatnonzero(along.sum(axis=0)[used] <= longest * (1.0 + BESIDE))
    least[beside] = exact_distances(vertices, part.faces, first, beside)
    return scale * chain_of_legs(FaceMesh.of_faces(vertices, part.faces), least, (first, last))


def _along_edges(mesh: TriangleMesh, sources: list[int]) -> Array:
    """Return the lengths of the shortest paths along edges, shape (sources, n).

    They are infinite where there is none.
    """
    count = len(mesh.vertices)
    # Edges of two faces appear twice; a set of rows would add them up.
    low, high = np.divmod(np.unique(_sides(mesh)), count)
    length = np.linalg.norm(mesh.vertices[low] - mesh.vertices[high], axis=1)
    graph = scipy.sparse.csr_array((length, (low, high)), shape=(count, count))
    distance = scipy.sparse.csgraph.dijkstra(graph, directed=False, indices=sources)
    return np.asarray(distance, dtype=np.float64)


def _sides(mesh: TriangleMesh) -> Ints:
    """Return a number for each side of each face, the same for both faces of a side."""
    first, last = mesh.faces.ravel(), np.roll(mesh.faces, -1, axis=1).ravel()
    return np.minimum(first, last) * len(mesh.vertices) + np.maximum(first, last)


def _faces_joined_to(mesh: TriangleMesh, vertex: int) -> Bools:
    """Return which faces are joined to those about a vertex by sides, shape (f,)."""
    count = len(mesh.faces)
    _, side = np.unique(_sides(mesh), return_inverse=True)
    face = np.repeat(np.arange(count), 3)
    label = connected_components(face, count + side, count + int(side.max()) + 1)[:count]
    return np.isin(label, label[(mesh.faces == vertex).any(axis=1)])


def joined_to(mesh: TriangleMesh, vertex: int) -> Bools:
    """Return which vertices are joined to one by edges, shape (n,)."""
    label = connected_components(
        mesh.faces.ravel(), np.roll(mesh.faces, -1, axis=1).ravel(), len(mesh.vertices)
    )
    return np.asarray(label == label[vertex])


def length_of(points: Array) -> float:
    """Length of a chain of points (k, 3)."""
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
