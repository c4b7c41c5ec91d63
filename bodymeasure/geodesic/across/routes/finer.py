"""Ways pulled straight once more, on a mesh so fine that they take the route of the smooth path.

On the mesh that ways are sought on, they pass many a corner on the wrong side, or run along the
wrong side of a seam. Each such place costs the search for the smooth path another route or two. On
a mesh with edges a quarter as long ways are a sixteenth as far from that path.
"""

import numpy as np

from bodymeasure._typing import Array, Ints
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
    patches = mesh.patch[way.strip]
    enter, leave = _on_patches(mesh, way)
    start, end = (
        fine.holding(AtlasPoint(int(patch), *place.tolist()))
        for patch, place in ((patches[0], enter[0]), (patches[-1], leave[-1]))
    )
    for on, place in ((start, enter[0]), (end, leave[-1])):
        place[:] = fine.parameters[on.face, int(np.argmax(on.weights))]
    begin, finish = (np.rint(fine.segments * each).astype(np.int64) for each in (enter, leave))
    i, j = begin.T[:, :, None] + _steps_along_edges(*(finish - begin).T)
    vertices = fine.vertex[patches[:, None], i, j].ravel()
    vertices = vertices[vertices >= 0]
    stays = vertices[1:] == vertices[:-1]
    return straight_way(fine.surface, (start, end), vertices[np.append(True, ~stays)])


def _steps_along_edges(rows: Ints, columns: Ints) -> Ints:
    """Return what `unit_steps` does, of many places: (2, places, k); some stay where they are."""
    count = np.maximum(np.maximum(np.abs(rows), np.abs(columns)), 1)[:, None]
    number = np.minimum(np.arange(count.max() + 1), count)
    i, j = ((2 * each[:, None] * number + count) // (2 * count) for each in (rows, columns))
    # Cells are cut along one diagonal only.
    round_ = np.where(np.diff(i) * np.diff(j) < 0, j[:, :-1], j[:, 1:])
    after = np.stack([round_, j[:, 1:]], axis=2).reshape(len(j), -1)
    return np.stack([np.repeat(i, 2, axis=1)[:, 1:], np.hstack([j[:, :1], after])])


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
