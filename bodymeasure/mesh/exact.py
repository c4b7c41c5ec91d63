"""Exact shortest paths over a mesh between two of its vertices."""

import sys

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas.components import connected_components
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.mesh.arrays import TriangleMesh, face_spheres, part_of

# The room for rounding in the bound on what a shortest path can reach.
ROOM = 1e-9
# The first version of Python for which pygeodesic has no wheels, so that the extra leaves it out.
NO_WHEELS = (3, 14)
BUILD_IT = (
    "it has no wheels for Python 3.14 and later: build it, given a C++ compiler, with: pip install "
    "pygeodesic, or use an earlier Python with: pip install 'bodymeasure[routes]'"
)


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
        If no edges join the two.
    MissingExtraError
        If pygeodesic is not installed.

    Notes
    -----
    J. Mitchell, D. Mount and C. Papadimitriou, "The discrete geodesic problem", SIAM J. Comput. 16
    (1987). No path that is as short as the shortest along the edges leaves the ellipsoid about the
    two points whose axis is that long; faces that are wholly outside are left out.
    """
    try:
        from pygeodesic.geodesic import PyGeodesicAlgorithmExact
    except ImportError:
        remedy = BUILD_IT if tuple(sys.version_info) >= NO_WHEELS else ""
        raise MissingExtraError("a path over a mesh", "pygeodesic", "routes", remedy) from None
    if source == target:
        return mesh.vertices[[source]]
    longest = _along_edges(mesh, source, target)
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
    first, last = (int(np.searchsorted(used, number)) for number in (source, target))
    # The solver's tolerances are lengths. A power of 2 rounds nothing.
    scale = float(np.ldexp(1.0, np.frexp(longest)[1]))
    solver = PyGeodesicAlgorithmExact(part.vertices / scale, part.faces)
    # The solver gives the path from its target back to its source.
    return scale * np.asarray(solver.geodesicDistance(last, first)[1], dtype=np.float64)


def _along_edges(mesh: TriangleMesh, source: int, target: int) -> float:
    """Return the length of the shortest path along edges; infinite if there is none."""
    first, last = mesh.faces.ravel(), np.roll(mesh.faces, -1, axis=1).ravel()
    count = len(mesh.vertices)
    low, high = np.minimum(first, last), np.maximum(first, last)
    # Edges of two faces appear twice; a set of rows would add them up.
    _, once = np.unique(low * count + high, return_index=True)
    low, high = low[once], high[once]
    length = np.linalg.norm(mesh.vertices[low] - mesh.vertices[high], axis=1)
    graph = scipy.sparse.csr_array((length, (low, high)), shape=(count, count))
    distance = scipy.sparse.csgraph.dijkstra(graph, directed=False, indices=source)
    return float(distance[target])


def joined_to(mesh: TriangleMesh, vertex: int) -> Bools:
    """Return which vertices are joined to one by edges, shape (n,)."""
    label = connected_components(
        mesh.faces.ravel(), np.roll(mesh.faces, -1, axis=1).ravel(), len(mesh.vertices)
    )
    return np.asarray(label == label[vertex])


def length_of(points: Array) -> float:
    """Length of a chain of points (k, 3)."""
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
