"""Where a route starts from: the exact shortest path over a triangle mesh of the atlas."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.components import connected_components
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.errors import MissingExtraError
from bodymeasure.geodesic.across.routes.graph import patch_graph
from bodymeasure.geodesic.across.routes.mesh import RouteMesh, inserted, whole_mesh

# Steps along each patch edge. The mesh only has to tell which way is the shortest: with 4, one of
# 80 paths over a body of 376 patches was not, by some 1e-4 of its length.
SEGMENTS = 6
# Patches that are many are small. Meshes of more triangles than this only take longer.
TRIANGLES = 30_000
# A shortest path passes only points through which the shortest way of the patch graph is longer
# than its shortest of all by no more than these parts; wider bands are for those that hold no path.
# The graph's ways are a few percent too long, and not all alike.
BANDS = (0.08, 0.5, np.inf)


def default_segments(patches: int) -> int:
    """Steps along a patch's edge of the meshes that routes start from."""
    return max(1, min(SEGMENTS, round(float(np.sqrt(TRIANGLES / (2 * patches))))))


def polyhedral_path(
    atlas: Atlas, start: AtlasPoint, end: AtlasPoint, segments: int | None = None
) -> tuple[RouteMesh, Array, int] | None:
    """The shortest path over a tessellation, with both points inserted into it.

    Parameters
    ----------
    atlas : Atlas
    start, end : AtlasPoint
    segments : int, optional
        Steps along each patch edge; by default `default_segments`.

    Returns
    -------
    mesh : RouteMesh
        The part of the tessellation that is near to it.
    points : ndarray, shape (k, 3)
        From the start to the end, each on an edge or a vertex of the mesh. A single one where both
        are one vertex.
    first : int
        The vertex that the path starts from.
        None instead of all three if no path joins the two.

    Raises
    ------
    MissingExtraError
        If pygeodesic is not installed.

    Notes
    -----
    J. Mitchell, D. Mount and C. Papadimitriou, "The discrete geodesic problem", SIAM J. Comput. 16
    (1987). What is far from all short ways of a coarser graph is left out.
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
            # Not so where the band is pinched.
            ends = part.vertices[[first, last]]
            led = points.ndim == 2 and np.array_equal(points[[0, -1]], ends)
            rim = np.intersect1d(mesh.faces[~within], used)
            if led and not _passes(points[1:-1], mesh.vertices[rim]):
                return part, points, first
    return None


def _passes(points: Array, vertices: Array) -> bool:
    """Whether a path passes through some vertices, as where the rim of a band holds it."""
    # Of what is cut off at a coordinate's value, few are left to compare.
    lower, upper = points.min(axis=0, initial=np.inf), points.max(axis=0, initial=-np.inf)
    close = vertices[((vertices >= lower) & (vertices <= upper)).all(axis=1)]
    return bool((points[:, None] == close).all(axis=2).any())


def _bands(
    atlas: Atlas, mesh: RouteMesh, start: AtlasPoint, end: AtlasPoint
) -> Iterator[NDArray[np.bool_]]:
    """Wider and wider bands of faces about the shortest ways of the patch graph."""
    graph = patch_graph(atlas)
    through = graph.distances(atlas, start) + graph.distances(atlas, end)
    if not np.isfinite(through).any():
        return
    segments = graph.number.shape[1] - 1
    # All faces about a vertex together, lest parts of the mesh meet in vertices only.
    row, column = np.moveaxis(np.rint(segments * mesh.face_parameters).astype(np.int64), -1, 0)
    near = through[graph.number[mesh.face_patch[:, None], row, column]].min(axis=1)
    # Where the ends are closer together than the graph's points are, the patches that hold them.
    around = np.isin(mesh.face_patch, (start.patch, end.patch))
    for width in BANDS:
        yield around | (near <= (1.0 + width) * through.min())


def _exact(mesh: RouteMesh, source: int, target: int) -> Array:
    try:
        from pygeodesic.geodesic import PyGeodesicAlgorithmExact
    except ImportError:
        raise MissingExtraError("a path across patches", "pygeodesic", "routes") from None
    solver = PyGeodesicAlgorithmExact(mesh.vertices, mesh.faces)
    # It gives the path from its target back to its source.
    return np.asarray(solver.geodesicDistance(target, source)[1], dtype=np.float64)
