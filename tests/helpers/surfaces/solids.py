"""Meshes of solids: a cube, spheres of triangles, irregular blobs of quads."""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.subdivision import PolygonMesh, refined

NO_CREASES = np.empty((0, 2), dtype=np.int64)
_CORNERS = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
_SIDES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
_GOLDEN = (1.0 + np.sqrt(5.0)) / 2.0
_TRIANGLES = (
    "0 11 5 0 5 1 0 1 7 0 7 10 0 10 11 1 5 9 5 11 4 11 10 2 10 7 6 7 1 8 3 9 4 3 4 2 3 2 6 3 6 8 "
    "3 8 9 4 9 5 2 4 11 6 2 10 8 6 7 9 8 1"
)


def quad_mesh(vertices: Array, quads: Ints) -> PolygonMesh:
    """A mesh of quads without creases."""
    return PolygonMesh(vertices, quads.ravel(), np.full(len(quads), 4), NO_CREASES)


CUBE = quad_mesh(_CORNERS, np.array(_SIDES))


def blob(seed: int) -> PolygonMesh:
    """Twenty-four quads of a cube whose vertices are moved at random."""
    mesh = refined(CUBE)
    moves = np.random.default_rng(seed).uniform(-0.15, 0.15, mesh.vertices.shape)
    return quad_mesh(mesh.vertices + moves, mesh.corners.reshape(-1, 4))


def icosphere(levels: int) -> PolygonMesh:
    """The unit sphere as 20 times 4^levels triangles."""
    rows = [(0.0, a, b * _GOLDEN) for a in (-1.0, 1.0) for b in (-1.0, 1.0)]
    vertices = np.array(
        [(-1, _GOLDEN, 0), (1, _GOLDEN, 0), (-1, -_GOLDEN, 0), (1, -_GOLDEN, 0)]
        + [rows[k] for k in (1, 3, 0, 2)]
        + [(_GOLDEN, 0, -1), (_GOLDEN, 0, 1), (-_GOLDEN, 0, -1), (-_GOLDEN, 0, 1)]
    )
    vertices = vertices / np.linalg.norm(vertices, axis=1, keepdims=True)
    faces = np.array(_TRIANGLES.split(), dtype=np.int64).reshape(-1, 3)
    for _ in range(levels):
        sides = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1), axis=-1)
        ends, number = np.unique(sides.reshape(-1, 2), axis=0, return_inverse=True)
        middles = vertices[ends].mean(axis=1)
        middles /= np.linalg.norm(middles, axis=1, keepdims=True)
        (a, b, c), (ab, bc, ca) = faces.T, number.reshape(-1, 3).T + len(vertices)
        parts = [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        faces = np.concatenate([np.stack(part, axis=-1) for part in parts])
        vertices = np.concatenate([vertices, middles])
    return PolygonMesh(vertices, faces.ravel(), np.full(len(faces), 3), NO_CREASES)


def obj_text(mesh: PolygonMesh, size: float = 1.0) -> str:
    """The mesh as a Wavefront OBJ file, its coordinates multiplied by a size."""
    points = (size * mesh.vertices).tolist()
    faces = np.split(mesh.corners + 1, np.cumsum(mesh.sizes)[:-1])
    lines = ["v " + " ".join(map(repr, point)) for point in points]
    lines += ["f " + " ".join(map(str, face.tolist())) for face in faces]
    return "\n".join(lines) + "\n"
