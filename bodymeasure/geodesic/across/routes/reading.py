"""Reading a path over a triangle mesh as a route over patches and seams."""

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors, Step
from bodymeasure.geodesic.across.routes.mesh import RouteMesh, at_weights, barycentric
from bodymeasure.geodesic.across.routes.polyhedral import default_segments, polyhedral_path
from bodymeasure.geodesic.across.routes.route import Route, snapped

# A point with a barycentric coordinate below this is on the side of its face. Paths are given by
# positions, whose rounding counts more in small faces.
ON_SIDE = 1e-7
# A point of a path is on none of the faces where it should be if it is farther from them than this
# part of the step to it. Near vertices, the exact algorithm's paths have points slightly off.
OFF = 1e-3
# Steps along each patch edge of the meshes that are tried where a path cannot be read.
COARSER = (5, 4)


class Segments(NamedTuple):
    """A path over a triangle mesh, segment by segment.

    Parameters
    ----------
    places : list of pair of AtlasPoint
        Both ends of each segment, on the patch of a face that holds it; empty for a path that
        stays where it is.
    points : ndarray, shape (segments + 1, 3)
        Positions on the mesh.
    """

    places: list[tuple[AtlasPoint, AtlasPoint]]
    points: Array


def first_route(
    atlas: Atlas,
    neighbors: Neighbors,
    ends: tuple[AtlasPoint, AtlasPoint],
    segments: int | None = None,
) -> Route | None:
    """Return the route of the shortest path over a tessellation; None if none is found.

    Where the path cannot be read, coarser meshes are tried.
    """
    segments = default_segments(len(atlas)) if segments is None else segments
    for steps in (segments, *(coarser for coarser in COARSER if coarser < segments)):
        found = mesh_segments(atlas, *ends, steps)
        if found is None:
            return None
        route = route_along(neighbors, ends, found.places)
        if route is not None:
            return route
    return None


def mesh_segments(
    atlas: Atlas, start: AtlasPoint, end: AtlasPoint, segments: int | None = None
) -> Segments | None:
    """Return the shortest path over a tessellation; None if no path joins the two points."""
    found = polyhedral_path(atlas, start, end, segments)
    if found is None:
        return None
    mesh, points, first = found
    moves = (np.diff(points, axis=0) != 0.0).any(axis=1)
    points = points[np.append(True, moves)]
    return Segments(list(_by_face(mesh, points, first)), points)


def route_along(
    neighbors: Neighbors,
    ends: tuple[AtlasPoint, AtlasPoint],
    segments: list[tuple[AtlasPoint, AtlasPoint]],
) -> Route | None:
    """Return the route of a path over a mesh, given by its segments; None if they are apart."""
    start, end = ends
    if not segments:
        ways = neighbors.ways(start, end) if start.patch != end.patch else [()]
        return Route.of(ends, ways[0]) if ways else None
    start = _nearest(neighbors.same(start), segments[0][0])
    end = _nearest(neighbors.same(end), segments[-1][1])
    # Paths over a mesh leave out the piece between an end and a seam beside which it lies.
    before, after = (
        _across(neighbors, segments[0][0], start),
        _across(neighbors, segments[-1][1], end),
    )
    segments = [*before, *segments, *after]
    steps: list[Step] = []
    for (_, leave), (enter, _) in pairwise(segments):
        # On one patch they are the same place, or beside one that is slightly off.
        if leave.patch == enter.patch:
            continue
        ways = neighbors.ways(leave, enter)
        if not ways:
            return None
        steps += ways[0]
    if (start.patch, end.patch) != (segments[0][0].patch, segments[-1][1].patch):
        return None
    return Route.of((start, end), steps)


def _across(
    neighbors: Neighbors, place: AtlasPoint, end: AtlasPoint
) -> list[tuple[AtlasPoint, AtlasPoint]]:
    """Return the segment that stays at a place but on the patch of an end, unless it is on it."""
    if place.patch == end.patch:
        return []
    return [(same, same) for same in neighbors.same(place) if same.patch == end.patch][:1]


def _nearest(places: list[AtlasPoint], to: AtlasPoint) -> AtlasPoint:
    """The place on the same patch that is nearest, or the first if none is on it."""
    return min(
        places,
        key=lambda place: (place.patch != to.patch, max(abs(place.u - to.u), abs(place.v - to.v))),
    )


def _by_face(mesh: RouteMesh, points: Array, first: int) -> Iterator[tuple[AtlasPoint, AtlasPoint]]:
    """Yield both ends of each segment of the path on the patch of a face that holds it.

    The face is sought among those about the place to which the path has come.
    """
    order = np.argsort(mesh.faces.ravel(), kind="stable")
    begins = np.searchsorted(mesh.faces.ravel()[order], np.arange(len(mesh.vertices) + 1))

    def faces_about(corners: Ints) -> Ints:
        about = order[begins[corners[0]] : begins[corners[0] + 1]] // 3
        hold = np.isin(mesh.faces[about], corners).sum(axis=1) == len(corners)
        return np.asarray(about[hold])

    corners, patch = np.array([first]), -1
    for here, there in pairwise(points):
        faces = faces_about(corners)
        weights, apart = _feet(mesh, faces, there)
        if apart.min(initial=np.inf) > OFF * np.linalg.norm(there - here):
            # The last point was slightly off, near a vertex: look on all faces about it.
            ring = [faces_about(corners[[number]]) for number in range(len(corners))]
            faces = np.unique(np.concatenate(ring))
            weights, apart = _feet(mesh, faces, there)
        # Along an edge both faces hold the segment: stay on the patch if one of them is on it.
        near = apart <= apart.min() + ON_SIDE * np.linalg.norm(there - here)
        stays = near & (mesh.face_patch[faces] == patch)
        row = int(np.flatnonzero(stays if stays.any() else near)[0])
        face = int(faces[row])
        patch = int(mesh.face_patch[face])
        before = barycentric(mesh.vertices[mesh.faces[face]][None], here)[0]
        yield _place(mesh, face, before), _place(mesh, face, weights[row])
        corners = mesh.faces[face][weights[row] > ON_SIDE]


def _feet(mesh: RouteMesh, faces: Ints, point: Array) -> tuple[Array, Array]:
    """The points of faces that are next to a point, in barycentric coordinates, and how far."""
    corners = mesh.vertices[mesh.faces[faces]]
    weights = np.clip(barycentric(corners, point), 0.0, None)
    weights /= weights.sum(axis=1, keepdims=True)
    foot = np.einsum("fk,fkc->fc", weights, corners)
    return weights, np.linalg.norm(foot - point, axis=1)


def _place(mesh: RouteMesh, face: int, weights: Array) -> AtlasPoint:
    weights = np.where(weights > ON_SIDE, weights, 0.0)
    u, v = at_weights(mesh, face, weights / weights.sum())
    return snapped(int(mesh.face_patch[face]), u, v)
