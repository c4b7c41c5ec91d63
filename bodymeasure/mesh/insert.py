"""Insertion of points of a mesh as vertices."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.mesh.arrays import TriangleMesh

# Part of a triangle that a new vertex keeps away from its sides, unless it is on them, since the
# exact algorithm does not bear slivers. By this part of a side it may be moved along the surface.
CLEARANCE = 1e-6


def inserted(mesh: TriangleMesh, face: int, position: Array) -> tuple[TriangleMesh, int]:
    """Return the mesh with a point of a face as a vertex, and the number of that vertex.

    The face is cut into three, or, if the point is on a side, it and the one beyond into two each.
    """
    corners = mesh.faces[face]
    weights = barycentric(mesh.vertices[corners], position)
    weights = np.where(weights < CLEARANCE, 0.0, weights)
    weights /= weights.sum()
    away = np.flatnonzero(weights)
    if len(away) == 1:
        return mesh, int(corners[away[0]])
    vertices = np.vstack([mesh.vertices, weights @ mesh.vertices[corners]])
    ends = corners[away]
    # The faces that hold the point are those with both ends of its side, or the one around it.
    split = np.flatnonzero(np.isin(mesh.faces, ends).sum(axis=1) == len(ends))
    parts = [mesh.faces[number].copy() for number in split for _ in ends]
    for part, corner in zip(parts, np.tile(ends, len(split)), strict=True):
        part[part == corner] = len(mesh.vertices)
    return TriangleMesh(vertices, np.vstack([np.delete(mesh.faces, split, axis=0), parts])), len(
        mesh.vertices
    )


def barycentric(corners: Array, position: Array) -> Array:
    """Return the barycentric coordinates (3,) of a point's foot in a triangle (3, 3)."""
    sides = np.stack([corners[1] - corners[0], corners[2] - corners[0]], axis=1)
    second, third = np.linalg.lstsq(sides, position - corners[0], rcond=None)[0]
    return np.array([1.0 - second - third, second, third])
