"""Triangle meshes in which two given points of an atlas are vertices."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.neighbors import Place
from bodymeasure.atlas.tessellation import Tessellation, tessellate
from bodymeasure.bezier import evaluate

_Array = NDArray[np.float64]

# A new vertex keeps this part of a triangle away from its sides, since the exact algorithm does
# not bear slivers. It only moves the start of the search, not the point that is measured.
CLEARANCE = 1e-3
# Barycentric coordinates below this are rounding: the point is on the side.
ON_SIDE = 1e-12


@dataclass(frozen=True, eq=False)
class RouteMesh:
    """A triangle mesh whose faces know where on their patches they lie.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    faces : ndarray of int, shape (f, 3)
    face_patch : ndarray of int, shape (f,)
    face_parameters : ndarray, shape (f, 3, 2)
        (u, v) of each face's corners on its patch.
    """

    vertices: _Array
    faces: NDArray[np.int64]
    face_patch: NDArray[np.int64]
    face_parameters: _Array

    @classmethod
    def of(cls, mesh: Tessellation) -> RouteMesh:
        """A whole tessellation."""
        return cls(mesh.vertices, mesh.faces, mesh.face_patch, mesh.face_parameters)

    def part(self, keep: NDArray[np.int64]) -> tuple[RouteMesh, NDArray[np.int64]]:
        """Some of the faces, and the old numbers of their vertices."""
        used, faces = np.unique(self.faces[keep], return_inverse=True)
        part = RouteMesh(
            self.vertices[used],
            faces.reshape(-1, 3),
            self.face_patch[keep],
            self.face_parameters[keep],
        )
        return part, used


@lru_cache(maxsize=4)
def whole_mesh(atlas: Atlas, segments: int) -> RouteMesh:
    """An atlas's tessellation; kept for the next path."""
    return RouteMesh.of(tessellate(atlas, segments))


def inserted(mesh: RouteMesh, atlas: Atlas, place: Place) -> tuple[RouteMesh, int]:
    """The mesh with a point as a vertex, and the number of that vertex.

    The face that holds the point is split, and the one beyond if the point is on a side of it.
    """
    on_patch = np.flatnonzero(mesh.face_patch == place.patch)
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
        # All faces along the side: one, two, or more where the atlas is not a manifold.
        ends = mesh.faces[face, corners]
        split = np.flatnonzero(np.isin(mesh.faces, ends).sum(axis=1) == 2).tolist()
    else:
        ends = mesh.faces[face]
    share = dict(zip(ends.tolist(), weight[corners].tolist(), strict=True))
    return _split(mesh, vertices, split, share), len(mesh.vertices)


def _split(
    mesh: RouteMesh, vertices: _Array, split: list[int], share: dict[int, float]
) -> RouteMesh:
    """Faces replaced by those to a new vertex, the last one, at a mean of some of their corners."""
    faces, patches, parameters = [], [], []
    for face in split:
        weight = np.array([share.get(int(corner), 0.0) for corner in mesh.faces[face]])
        there = weight @ mesh.face_parameters[face]
        for corner in np.flatnonzero(weight):
            new_face, new_parameters = mesh.faces[face].copy(), mesh.face_parameters[face].copy()
            new_face[corner], new_parameters[corner] = len(vertices) - 1, there
            faces.append(new_face)
            parameters.append(new_parameters)
            patches.append(mesh.face_patch[face])
    return RouteMesh(
        vertices,
        np.vstack([np.delete(mesh.faces, split, axis=0), faces]),
        np.append(np.delete(mesh.face_patch, split), patches),
        np.concatenate([np.delete(mesh.face_parameters, split, axis=0), parameters]),
    )


def barycentric(corners: _Array, point: _Array) -> _Array:
    """Barycentric coordinates of a point, or of its foot, in triangles; shape (triangles, 3).

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
