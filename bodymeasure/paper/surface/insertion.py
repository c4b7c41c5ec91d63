"""Points made vertices of a triangle mesh, so that distances between them can be measured."""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.oracle.libigl import closest_on_mesh

# A point that is closer to a vertex or an edge than this part of a face's height makes no thin
# face, which libigl might not measure. Nothing is lost, since the mesh is moved to the point.
NEAR = 0.05


def insert_point(vertices: Array, faces: Ints, point: Array) -> tuple[Array, Ints, int]:
    """Return a mesh that has a given point among its vertices.

    The face closest to it is split in three; the two at an edge, if it lies near one, are split in
    two each; a vertex near it is moved to it.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    faces : ndarray of int, shape (f, 3)
    point : ndarray, shape (3,)
        A point of the surface that the mesh follows, so that the vertices still lie on that.

    Returns
    -------
    vertices, faces : ndarray
    number : int
        Number of the point.
    """
    foot, found = closest_on_mesh(vertices, faces, point[None])
    face = faces[found[0]]
    weights = _barycentric(vertices[face], foot[0])
    far = weights > NEAR
    if far.sum() == 1:
        number = int(face[far][0])
        vertices = vertices.copy()
        vertices[number] = point
        return vertices, faces, number
    # Every face that has the corners between which the point lies is split.
    corners = face[far]
    split = np.isin(faces, corners).sum(axis=1) == len(corners)
    number = len(vertices)
    pieces = []
    for corner in corners:
        piece = faces[split]
        pieces.append(np.where(piece == corner, number, piece))
    return np.vstack([vertices, point]), np.concatenate([faces[~split], *pieces]), number


def _barycentric(corners: Array, point: Array) -> Array:
    """Return weights of a triangle's corners (3, 3), with sum 1, that give a point of its plane."""
    sides = np.stack([corners[1] - corners[0], corners[2] - corners[0]], axis=-1)
    second, third = np.linalg.lstsq(sides, point - corners[0], rcond=None)[0]
    return np.array([1.0 - second - third, second, third])
