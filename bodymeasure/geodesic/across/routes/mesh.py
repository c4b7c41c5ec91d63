"""Triangle meshes in which two given points of an atlas are vertices."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES, edge_table
from bodymeasure.atlas.tessellation import Tessellation, tessellate
from bodymeasure.bezier import evaluate

# A new vertex keeps away from the sides of its triangle by this part of it, since the exact
# algorithm fails on slivers. That moves the path from which the search starts, but not the point
# that is measured.
CLEARANCE = 1e-3
# A point whose barycentric coordinate is below this is on the side, except for rounding.
ON_SIDE = 1e-12


@dataclass(frozen=True, eq=False)
class RouteMesh:
    """A triangle mesh with the places of its faces on the patches.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    faces : ndarray of int, shape (f, 3)
    face_patch : ndarray of int, shape (f,)
    face_parameters : ndarray, shape (f, 3, 2)
        (u, v) of each face's corners on its patch.
    face_free : ndarray of bool, shape (f, 3, 2)
        Whether u, or v, of a corner is arbitrary, since the corner lies on a collapsed side.
    """

    vertices: Array
    faces: Ints
    face_patch: Ints
    face_parameters: Array
    face_free: Bools

    @classmethod
    def of(cls, atlas: Atlas, mesh: Tessellation) -> "RouteMesh":
        """Return the mesh of a whole tessellation."""
        collapsed = edge_table(atlas.index).collapsed[mesh.face_patch]
        free = np.zeros(mesh.face_parameters.shape, bool)
        for side, edge in enumerate(EDGES):
            on = mesh.face_parameters[..., edge.fixed_axis] == edge.fixed_value
            free[..., 1 - edge.fixed_axis] |= on & collapsed[:, [side]]
        return cls(mesh.vertices, mesh.faces, mesh.face_patch, mesh.face_parameters, free)

    def part(self, keep: Ints) -> "tuple[RouteMesh, Ints]":
        """Return the mesh of some of the faces, and the old numbers of its vertices."""
        used, faces = np.unique(self.faces[keep], return_inverse=True)
        part = RouteMesh(
            self.vertices[used],
            faces.reshape(-1, 3),
            self.face_patch[keep],
            self.face_parameters[keep],
            self.face_free[keep],
        )
        return part, used


@lru_cache(maxsize=4)
def whole_mesh(atlas: Atlas, segments: int) -> RouteMesh:
    """Return the mesh of an atlas's tessellation, which is kept for the next path."""
    return RouteMesh.of(atlas, tessellate(atlas, segments))


def inserted(mesh: RouteMesh, atlas: Atlas, place: AtlasPoint) -> tuple[RouteMesh, int]:
    """Return the mesh with a point as a vertex, and the number of that vertex.

    The face that holds the point is split, together with the face beyond if the point is on a side.
    """
    on_patch = np.flatnonzero(mesh.face_patch == place.patch)
    tip = _collapsed_corner(mesh, on_patch, place)
    if tip is not None:
        return mesh, tip
    weights = barycentric(mesh.face_parameters[on_patch], np.array([place.u, place.v]))
    best = int(np.argmax(weights.min(axis=1)))
    face = int(on_patch[best])
    weight = np.where(weights[best] < ON_SIDE, 0.0, weights[best])
    weight = np.where(weight > 0.0, np.maximum(weight, CLEARANCE), 0.0)
    weight /= weight.sum()
    corners = np.flatnonzero(weight)
    if len(corners) == 1:
        return mesh, int(mesh.faces[face, corners[0]])
    parameters = weight @ mesh.face_parameters[face]
    vertices = np.vstack([mesh.vertices, evaluate(atlas.control_points[place.patch], parameters)])
    split = [face]
    if len(corners) == 2:
        # One face is along the side, or two, or more where the atlas is not a manifold.
        ends = mesh.faces[face, corners]
        split = np.flatnonzero(np.isin(mesh.faces, ends).sum(axis=1) == 2).tolist()
    else:
        ends = mesh.faces[face]
    share = dict(zip(ends.tolist(), weight[corners].tolist(), strict=True))
    return _split(mesh, vertices, split, share), len(mesh.vertices)


def _collapsed_corner(mesh: RouteMesh, faces: Ints, place: AtlasPoint) -> int | None:
    """The vertex of the collapsed side on which a place lies; None if it lies on none."""
    free, parameters = mesh.face_free[faces], mesh.face_parameters[faces]
    for axis in (0, 1):
        on = free[..., axis] & (parameters[..., 1 - axis] == place[2 - axis])
        if on.any():
            return int(mesh.faces[faces][on][0])
    return None


def _split(
    mesh: RouteMesh, vertices: Array, split: list[int], share: dict[int, float]
) -> RouteMesh:
    """The mesh with some faces split at the last vertex, which no face has yet.

    That vertex is a mean of corners of these faces, with weights `share` by vertex.
    """
    faces, patches, parameters, free = [], [], [], []
    for face in split:
        weight = np.array([share.get(int(corner), 0.0) for corner in mesh.faces[face]])
        there = at_weights(mesh, face, weight)
        for corner in np.flatnonzero(weight):
            new_face, new_parameters = mesh.faces[face].copy(), mesh.face_parameters[face].copy()
            new_face[corner], new_parameters[corner] = len(vertices) - 1, there
            new_free = mesh.face_free[face].copy()
            new_free[corner] = False
            free.append(new_free)
            faces.append(new_face)
            parameters.append(new_parameters)
            patches.append(mesh.face_patch[face])
    return RouteMesh(
        vertices,
        np.vstack([np.delete(mesh.faces, split, axis=0), faces]),
        np.append(np.delete(mesh.face_patch, split), patches),
        np.concatenate([np.delete(mesh.face_parameters, split, axis=0), parameters]),
        np.concatenate([np.delete(mesh.face_free, split, axis=0), free]),
    )


def at_weights(mesh: RouteMesh, face: int, weights: Array) -> Array:
    """Return (u, v) of a point of a face, shape (2,).

    A corner on a collapsed side counts with u or v alone, as its other parameter is arbitrary.
    """
    count = np.where(mesh.face_free[face], 0.0, weights[:, None])
    total = count.sum(axis=0)
    count = np.where(total > 0.0, count, weights[:, None])
    return np.asarray((count * mesh.face_parameters[face]).sum(axis=0) / count.sum(axis=0))


def barycentric(corners: Array, point: Array) -> Array:
    """Return the barycentric coordinates of a point in triangles, shape (triangles, 3).

    A point outside the plane of a triangle has those of its orthogonal projection.

    Parameters
    ----------
    corners : ndarray, shape (triangles, 3, dimensions)
    point : ndarray, shape (dimensions,)
    """
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    offset = point - corners[:, 0]
    aa, ab, bb = (a * a).sum(axis=1), (a * b).sum(axis=1), (b * b).sum(axis=1)
    oa, ob = (offset * a).sum(axis=1), (offset * b).sum(axis=1)
    determinant = aa * bb - ab * ab
    second = (bb * oa - ab * ob) / determinant
    third = (aa * ob - ab * oa) / determinant
    return np.stack([1.0 - second - third, second, third], axis=1)
