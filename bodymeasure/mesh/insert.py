"""Points of a mesh made vertices of it."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.mesh.arrays import TriangleMesh

# A new vertex keeps this part of a triangle away from its sides, or is on them: the exact
# algorithm does not bear slivers. So far may it be moved, along the surface, in parts of a side.
CLEARANCE = 1e-6


def inserted(mesh: TriangleMesh, face: int, position: Array) -> tuple[TriangleMesh, int]:
    """The mesh with a point of a face as a vertex, and the number of that vertex.

    The face is cut into three; or two, and the one beyond too, if the point is on a side.
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
    # All faces that hold the point: those with both ends of its side, or the one around it.
    split = np.flatnonzero(np.isin(mesh.faces, ends).sum(axis=1) == len(ends))
    parts = [mesh.faces[number].copy() for number in split for _ in ends]
    for part, corner in zip(parts, np.tile(ends, len(split)), strict=True):
        part[part == corner] = len(mesh.vertices)
    return TriangleMesh(vertices, np.vstack([np.delete(mesh.faces, split, axis=0), parts])), len(
        mesh.vertices
    )


def barycentric(corners: Array, position: Array) -> Array:
    """Barycentric coordinates (3,) of a point's foot in a triangle (3, 3)."""
    sides = np.stack([corners[1] - corners[0], corners[2] - corners[0]], axis=1)
    second, third = np.linalg.lstsq(sides, position - corners[0], rcond=None)[0]
    return np.array([1.0 - second - third, second, third])
