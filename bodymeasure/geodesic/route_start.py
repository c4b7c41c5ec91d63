"""Where a route starts from: the exact shortest path over a triangle mesh of the atlas."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import scipy
from numpy.typing import NDArray

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.neighbors import Place
from bodymeasure.atlas.tessellation import tessellate
from bodymeasure.errors import MissingExtraError
from bodymeasure.geodesic.route_mesh import RouteMesh, inserted

_Array = NDArray[np.float64]

# Steps along each patch edge. The mesh only has to tell which way is the shortest.
SEGMENTS = 4
# Room for rounding in what a shortest path can reach.
ROOM = 1e-9


@lru_cache(maxsize=4)
def whole_mesh(atlas: Atlas, segments: int) -> RouteMesh:
    """An atlas's tessellation; kept for the next path."""
    return RouteMesh.of(tessellate(atlas, segments))


def polyhedral_path(
    atlas: Atlas, start: Place, end: Place, segments: int = SEGMENTS
) -> tuple[RouteMesh, _Array, int] | None:
    """The shortest path over a tessellation, with both points inserted into it.

    Parameters
    ----------
    atlas : Atlas
    start, end : Place
    segments : int
        Steps along each patch edge.

    Returns
    -------
    mesh : RouteMesh
        The part of the tessellation that such a path can reach.
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
    (1987). No path that is as short as the shortest along the edges leaves the ellipsoid about the
    two points whose axis is that long; what is outside is left out.
    """
    mesh, source = inserted(whole_mesh(atlas, segments), atlas, start)
    mesh, target = inserted(mesh, atlas, end)
    if source == target:
        return mesh, mesh.vertices[[source]], source
    longest = _along_edges(mesh, source, target)
    if not np.isfinite(longest):
        return None
    vertices = mesh.vertices
    way = np.linalg.norm(vertices - vertices[source], axis=1)
    way += np.linalg.norm(vertices - vertices[target], axis=1)
    inside = way <= longest * (1.0 + ROOM)
    part, used = mesh.part(np.flatnonzero(inside[mesh.faces].any(axis=1)))
    first, last = (int(np.searchsorted(used, number)) for number in (source, target))
    return part, _exact(part, first, last), first


def _along_edges(mesh: RouteMesh, source: int, target: int) -> float:
    """The shortest way along the edges of the mesh; infinite if there is none."""
    first, last = mesh.faces.ravel(), np.roll(mesh.faces, -1, axis=1).ravel()
    length = np.linalg.norm(mesh.vertices[first] - mesh.vertices[last], axis=1)
    count = len(mesh.vertices)
    # Edges of two faces appear twice, from either end; a set of rows would add them up.
    low, high = np.minimum(first, last), np.maximum(first, last)
    _, once = np.unique(low * count + high, return_index=True)
    graph = scipy.sparse.csr_array((length[once], (low[once], high[once])), shape=(count, count))
    distance = scipy.sparse.csgraph.dijkstra(graph, directed=False, indices=source)
    return float(distance[target])


def _exact(mesh: RouteMesh, source: int, target: int) -> _Array:
    try:
        from pygeodesic.geodesic import PyGeodesicAlgorithmExact
    except ImportError:
        raise MissingExtraError("a path across patches", "pygeodesic", "routes") from None
    solver = PyGeodesicAlgorithmExact(mesh.vertices, mesh.faces)
    # It gives the path from its target back to its source.
    return np.asarray(solver.geodesicDistance(target, source)[1], dtype=np.float64)
