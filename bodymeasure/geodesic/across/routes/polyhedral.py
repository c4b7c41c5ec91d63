"""The exact shortest path over a triangle mesh of the atlas, from which a route is read."""

from collections.abc import Iterator

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.components import connected_components
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.errors import MissingExtraError
from bodymeasure.geodesic.across.routes.graph import patch_graph
from bodymeasure.geodesic.across.routes.mesh import RouteMesh, inserted, whole_mesh

# Steps along each patch edge. The mesh only has to show which way is the shortest: with 4 steps,
# one of 80 paths over a body of 376 patches was too long, by some 1e-4 of its length.
SEGMENTS = 6
# Where patches are many, they are small, and meshes of more triangles than this only take longer.
TRIANGLES = 30_000
# The shortest path is sought among the points through which the patch graph has a way that is
# longer than its shortest way of all by no more than these parts of it. The graph's ways are a few
# percent too long, by different amounts. A wider band is tried where one holds no path.
BANDS = (0.08, 0.5, np.inf)


def default_segments(patches: int) -> int:
    """Return the number of steps along a patch's edge of the mesh from which a route is read."""
    return max(1, min(SEGMENTS, round(float(np.sqrt(TRIANGLES / (2 * patches))))))


def polyhedral_path(
    atlas: Atlas, start: AtlasPoint, end: AtlasPoint, segments: int | None = None
) -> tuple[RouteMesh, Array, int] | None:
    """Return the shortest path over a tessellation, with both points inserted into it.

    Parameters
    ----------
    atlas : Atlas
    start, end : AtlasPoint
    segments : int, optional
        Steps along each patch edge; by default `default_segments`.

    Returns
    -------
    mesh : RouteMesh
        The part of the tessellation that is near the path.
    points : ndarray, shape (k, 3)
        From the start to the end, each on an edge or a vertex of the mesh. A single one where both
        are one vertex.
    first : int
        The vertex from which the path starts.

    None is returned instead of the three if no path joins the two points.

    Raises
    ------
    MissingExtraError
        If pygeodesic is not installed.

    Notes
    -----
    J. Mitchell, D. Mount and C. Papadimitriou, "The discrete geodesic problem", SIAM J. Comput. 16
    (1987). The part of the mesh that is far from all short ways of a coarser graph is left out.
    """
    segments = default_segments(len(atlas)) if segments is None else segments
    mesh, source = inserted(whole_mesh(atlas, segments), atlas, start)
    mesh, target = inserted(mesh, atlas, end)
    if source == target:
        return mesh, mesh.vertices[[source]], source
    for within in _bands(atlas, mesh, start, end):
        part, used = mesh.part(np.flatnonzero(within))
        first, last = (int(np.searchsorted(used, number)) for number in (source, target))
        if max(first, last) >= len(used) or (used[first], used[last]) != (source, target):
            continue
        ways = connected_components(
            part.faces.ravel(), np.roll(part.faces, 1, axis=1).ravel(), len(part.vertices)
        )
        if ways[first] == ways[last]:
            points = _exact(part, first, last)
            # The path is wrong where the band is pinched.
            ends = part.vertices[[first, last]]
            led = points.ndim == 2 and np.array_equal(points[[0, -1]], ends)
            rim = np.intersect1d(mesh.faces[~within], used)
            if led and not _passes(points[1:-1], mesh.vertices[rim]):
                return part, points, first
    return None


def _passes(points: Array, vertices: Array) -> bool:
    """Whether a path passes through some of the vertices, as where the rim of a band holds it."""
    # Few vertices are in the box about the path.
    lower, upper = points.min(axis=0, initial=np.inf), points.max(axis=0, initial=-np.inf)
    close = vertices[((vertices >= lower) & (vertices <= upper)).all(axis=1)]
    return bool((points[:, None] == close).all(axis=2).any())


def _bands(atlas: Atlas, mesh: RouteMesh, start: AtlasPoint, end: AtlasPoint) -> Iterator[Bools]:
    """Wider and wider bands of faces about the shortest ways of the patch graph."""
    graph = patch_graph(atlas)
    through = graph.distances(atlas, start) + graph.distances(atlas, end)
    if not np.isfinite(through).any():
        return
    segments = graph.number.shape[1] - 1
    # All faces about a vertex are taken or left together, so that no parts meet in vertices only.
    row, column = np.moveaxis(np.rint(segments * mesh.face_parameters).astype(np.int64), -1, 0)
    near = through[graph.number[mesh.face_patch[:, None], row, column]].min(axis=1)
    # The patches that hold the ends are always taken: the ends may be closer together than the
    # graph's points are.
    around = np.isin(mesh.face_patch, (start.patch, end.patch))
    for width in BANDS:
        yield around | (near <= (1.0 + width) * through.min())


def _exact(mesh: RouteMesh, source: int, target: int) -> Array:
    try:
        from pygeodesic.geodesic import PyGeodesicAlgorithmExact
    except ImportError:
        raise MissingExtraError("a path across patches", "pygeodesic", "routes") from None
    solver = PyGeodesicAlgorithmExact(mesh.vertices, mesh.faces)
    # The algorithm gives the path from its target back to its source.
    return np.asarray(solver.geodesicDistance(target, source)[1], dtype=np.float64)
