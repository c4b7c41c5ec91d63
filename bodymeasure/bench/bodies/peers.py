"""Lengths on a triangle mesh of a body, by potpourri3d, libigl, pygeodesic and trimesh.

Each function prepares what can be used again or is only needed to state the problem, and returns
the call that is timed.
"""

from collections.abc import Callable

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import ConvexHull

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import AtlasPoint
from bodymeasure.bench.bodies.meshed_body import MeshedBody
from bodymeasure.bench.bodies.problems import Ring
from bodymeasure.oracle.libigl import exact_distance
from bodymeasure.section import Plane

Call = Callable[[], float]
# Ends of segments that differ by less than this part of the body's size are one point.
SAME = 1e-9
# A loop is given to potpourri3d as so many vertices beside the level section that it slides from.
AROUND = 12


def edge_flips(mesh: MeshedBody, ends: tuple[AtlasPoint, AtlasPoint]) -> Call:
    """Return the call of potpourri3d's locally shortest path, on a solver made before."""
    source, target = (mesh.vertex(point) for point in ends)
    solver = mesh.flips
    return lambda: _polygon(solver.find_geodesic_path(source, target))


def igl_exact(mesh: MeshedBody, ends: tuple[AtlasPoint, AtlasPoint]) -> Call:
    """Return the call of libigl's exact distance, on the part of the mesh that counts."""
    vertices, faces, (source, target) = _part(mesh, ends)
    return lambda: exact_distance(vertices, faces, int(source), int(target))


def pygeodesic_exact(mesh: MeshedBody, ends: tuple[AtlasPoint, AtlasPoint]) -> Call:
    """Return the call of pygeodesic's exact distance, on the part of the mesh that counts."""
    from pygeodesic.geodesic import PyGeodesicAlgorithmExact

    vertices, faces, (source, target) = _part(mesh, ends)

    def call() -> float:
        solver = PyGeodesicAlgorithmExact(vertices, faces)
        distance, _ = solver.geodesicDistance(int(source), int(target))
        return np.nan if distance is None else float(distance)

    return call


def _part(mesh: MeshedBody, ends: tuple[AtlasPoint, AtlasPoint]) -> tuple[Array, Ints, Ints]:
    # No shortest path is longer than the one by edge flips.
    numbers = mesh.vertex(ends[0]), mesh.vertex(ends[1])
    return mesh.within_reach(numbers, edge_flips(mesh, ends)())


def trimesh_section(mesh: MeshedBody, ring: Ring) -> Call:
    """Return the call of the length of trimesh's section."""
    return lambda: _length(_trimesh_loop(mesh, ring))


def trimesh_hull(mesh: MeshedBody, ring: Ring) -> Call:
    """Return the call of the perimeter of the convex hull of trimesh's section."""
    return lambda: _perimeter(_trimesh_loop(mesh, ring), ring.plane)


def igl_isoline(mesh: MeshedBody, ring: Ring) -> Call:
    """Return the call of the length of libigl's isoline of the height over the plane."""
    return lambda: _length(_igl_loop(mesh, ring))


def igl_hull(mesh: MeshedBody, ring: Ring) -> Call:
    """Return the call of the perimeter of the convex hull of libigl's isoline."""
    return lambda: _perimeter(_igl_loop(mesh, ring), ring.plane)


def flip_loop(mesh: MeshedBody, place: str) -> Call:
    """Return the call of potpourri3d's geodesic loop, from vertices beside a level section."""
    atlas = mesh.atlas
    position = atlas.position(atlas.landmarks[place])
    level = Ring(Plane(position, atlas.axes.up_vector), position, False)
    points = _trimesh_loop(mesh, level)[:, 0]
    across = (points - points.mean(axis=0)) @ _flat(level.plane).T
    order = np.argsort(np.arctan2(across[:, 1], across[:, 0]))
    some = order[np.linspace(0, len(order), AROUND, endpoint=False).astype(int)]
    vertices = list(dict.fromkeys(mesh.nearest(point) for point in points[some]))
    solver = mesh.flips
    return lambda: _polygon(solver.find_geodesic_loop(vertices))


def _polygon(points: Array) -> float:
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def _length(segments: Array) -> float:
    return float(np.linalg.norm(segments[:, 1] - segments[:, 0], axis=1).sum())


def _perimeter(segments: Array, plane: Plane) -> float:
    # In the plane, scipy's "area" of a hull is its perimeter.
    return float(ConvexHull(segments.reshape(-1, 3) @ _flat(plane).T).area)


def _flat(plane: Plane) -> Array:
    """Two unit vectors in a plane."""
    return np.asarray(np.linalg.svd(plane.normal[None])[2][1:])


def _trimesh_loop(mesh: MeshedBody, ring: Ring) -> Array:
    from trimesh.intersections import mesh_plane

    normal, point = ring.plane.normal, ring.plane.point
    segments = mesh_plane(mesh.trimesh, normal, point)  # type: ignore[no-untyped-call]
    ends = segments.reshape(-1, 3)
    grid = np.round(ends / (SAME * np.ptp(mesh.mesh.vertices))).astype(np.int64)
    _, edges = np.unique(grid, axis=0, return_inverse=True)
    return _nearest_loop(segments, edges.reshape(-1, 2), ring.place)


def _igl_loop(mesh: MeshedBody, ring: Ring) -> Array:
    import igl

    vertices, faces = mesh.mesh.vertices, mesh.mesh.faces
    height = (vertices - ring.plane.point) @ ring.plane.normal
    points, edges, _ = igl.isolines(vertices, faces, height, np.zeros(1))
    return _nearest_loop(points[edges], edges, ring.place)


def _nearest_loop(segments: Array, edges: Ints, place: Array) -> Array:
    """The segments, shape (k, 2, 3), of the curve that comes nearest to a place."""
    size = int(edges.max()) + 1
    graph = coo_array((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(size, size))
    label = connected_components(graph, directed=False)[1][edges[:, 0]]
    nearest = np.argmin(np.linalg.norm(segments[:, 0] - place, axis=1))
    return np.asarray(segments[label == label[nearest]])
