"""The smooth surface that a mesh stands for, as far as its vertices determine it."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.mesh.arrays import TriangleMesh


def vertex_normals(mesh: TriangleMesh) -> Array:
    """Return the means of the faces' unit normals at vertices (n, 3), weighted by the angles.

    They are 0 where the faces' normals cancel out.

    G. Thuermer and C. Wuethrich, J. Graphics Tools 3 (1998) 43-46.
    """
    corners = mesh.vertices[mesh.faces]
    ahead = np.roll(corners, -1, axis=1) - corners
    behind = np.roll(corners, 1, axis=1) - corners
    normal = np.cross(ahead[:, 0], behind[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), np.finfo(float).tiny)
    sine = np.linalg.norm(np.cross(ahead, behind), axis=2)
    angle = np.arctan2(sine, (ahead * behind).sum(axis=2))
    total = np.zeros_like(mesh.vertices)
    for corner in range(3):
        np.add.at(total, mesh.faces[:, corner], angle[:, corner, None] * normal)
    length = np.linalg.norm(total, axis=1, keepdims=True)
    return np.asarray(np.divide(total, length, out=np.zeros_like(total), where=length > 0.0))


def curved(mesh: TriangleMesh, normals: Array) -> tuple[TriangleMesh, Array]:
    """Cut each triangle into four, with new vertices on curves that meet the vertices' normals.

    Parameters
    ----------
    mesh : TriangleMesh
    normals : ndarray, shape (n, 3)

    Returns
    -------
    finer : TriangleMesh
        The old vertices first, in their order.
    sag : ndarray, shape (sides,)
        How far the middle of each side is moved, over the side's length.

    Notes
    -----
    The new vertices are the middles of the sides of the triangles of A. Vlachos et al., *Curved PN
    triangles*, Symposium on Interactive 3D Graphics (2001): cubics whose ends are perpendicular to
    both normals.
    """
    first, second = mesh.faces, np.roll(mesh.faces, -1, axis=1)
    pairs = np.stack([np.minimum(first, second), np.maximum(first, second)], axis=-1)
    sides, number = np.unique(pairs.reshape(-1, 2), axis=0, return_inverse=True)
    start, end = mesh.vertices[sides[:, 0]], mesh.vertices[sides[:, 1]]
    rise = [
        ((end - start) * normals[sides[:, 0]]).sum(axis=1, keepdims=True) * normals[sides[:, 0]],
        ((start - end) * normals[sides[:, 1]]).sum(axis=1, keepdims=True) * normals[sides[:, 1]],
    ]
    moves = (rise[0] + rise[1]) / 8.0
    middles = 0.5 * (start + end) - moves
    sag = np.linalg.norm(moves, axis=1) / np.linalg.norm(end - start, axis=1)
    middle = number.reshape(-1, 3) + len(mesh.vertices)
    a, b, c = mesh.faces.T
    ab, bc, ca = middle.T
    faces = np.concatenate(
        [np.stack(part, axis=1) for part in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
    )
    return TriangleMesh(np.vstack([mesh.vertices, middles]), faces), sag
