"""Ways pulled straight once more, on a mesh so fine that they take the route of the smooth path.

On the mesh that ways are sought on, they pass many a corner on the wrong side, or run along the
wrong side of a seam. Each such place costs the search for the smooth path another route or two. On
a mesh with edges a quarter as long ways are a sixteenth as far from that path.
"""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.geodesic.across.routes.graph import patch_graph
from bodymeasure.geodesic.across.routes.mesh import RouteMesh, whole_mesh
from bodymeasure.geodesic.across.routes.reading import route_of
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.routes.strips import StraightWay, straight_way

# The edges of the fine mesh are this many times shorter, unless that made more than so many cells.
FINER, MOST = 4, 50_000


def fine_route(
    atlas: Atlas, neighbors: Neighbors, ends: tuple[AtlasPoint, AtlasPoint], way: StraightWay
) -> Route | None:
    """Return the route that a way over the mesh of an atlas's graph leads to; None if to none."""
    mesh = patch_graph(atlas).mesh
    segments = mesh.segments * FINER
    if len(atlas) * segments**2 <= MOST:
        fine = whole_mesh(atlas, segments)
        finer = _pulled_straight(mesh, fine, way)
        route = None if finer is None else route_of(neighbors, fine, ends, finer)
        if route is not None:
            return route
    return route_of(neighbors, mesh, ends, way)


def _pulled_straight(mesh: RouteMesh, fine: RouteMesh, way: StraightWay) -> StraightWay | None:
    """Return a way on a finer mesh; None if it cannot be led along its edges."""
    patches: list[int] = mesh.patch[way.strip].tolist()
    enter, leave = _on_patches(mesh, way)
    ends = tuple(
        fine.holding(AtlasPoint(patch, *place))
        for patch, place in ((patches[0], enter[0].tolist()), (patches[-1], leave[-1].tolist()))
    )
    for end, place in zip(ends, (enter[0], leave[-1]), strict=True):
        place[:] = fine.parameters[end.face, int(np.argmax(end.weights))]
    begin, finish = (np.rint(fine.segments * each).astype(np.int64) for each in (enter, leave))
    vertices: list[int] = []
    for patch, here, there in zip(patches, begin.tolist(), finish.tolist(), strict=True):
        vertices += fine.between(patch, here, there)
    return straight_way(fine.surface, (ends[0], ends[1]), np.array(vertices))


def _on_patches(mesh: RouteMesh, way: StraightWay) -> tuple[Array, Array]:
    """Return (u, v) where a way enters and leaves each face of its strip, shape (faces, 2)."""
    faces, corners, count = mesh.corners[way.strip], mesh.parameters[way.strip], len(way.sides)
    first, last = (np.array(end.weights) for end in way.ends)
    side, at, t = way.sides, np.arange(count), way.along[:, None]
    left, right = faces[at, side], faces[at, (side + 1) % 3]
    beyond, after = faces[1:], at + 1
    to_left = np.argmax(beyond == left[:, None], axis=1)
    to_right = np.argmax(beyond == right[:, None], axis=1)
    leave = (1.0 - t) * corners[at, side] + t * corners[at, (side + 1) % 3]
    enter = (1.0 - t) * corners[after, to_left] + t * corners[after, to_right]
    return np.vstack([first @ corners[0], enter]), np.vstack([leave, last @ corners[-1]])
