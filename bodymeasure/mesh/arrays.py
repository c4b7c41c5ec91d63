"""The vertices and triangles of meshes, in whatever form they come."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError


class TriangleMesh(NamedTuple):
    """A mesh as arrays.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    faces : ndarray of int, shape (f, 3)
    """

    vertices: Array
    faces: Ints


def triangle_mesh(mesh: Any) -> TriangleMesh:
    """Return the arrays of a mesh.

    Parameters
    ----------
    mesh : trimesh.Trimesh, pyvista.PolyData or pair of array_like
        Vertices (n, 3) and faces (f, 3) if a pair. Polygons of a PolyData are cut into triangles.

    Raises
    ------
    InputError
        If it is none of these, or holds no triangles.
    """
    if hasattr(mesh, "cast_to_unstructured_grid") and not hasattr(mesh, "n_strips"):
        raise InputError(
            f"the mesh is a {type(mesh).__name__}, which is no surface; pass its surface, "
            "mesh.extract_surface()"
        )
    if hasattr(mesh, "triangulate") and hasattr(mesh, "n_points"):
        surface = mesh.triangulate()
        vertices, faces = surface.points, np.asarray(surface.faces).reshape(-1, 4)[:, 1:]
    elif hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        vertices, faces = mesh.vertices, mesh.faces
    elif isinstance(mesh, tuple) and len(mesh) == 2:
        vertices, faces = mesh
    else:
        raise InputError(
            f"the mesh is of type {type(mesh).__name__}; expected a trimesh.Trimesh, a "
            "pyvista.PolyData, or a pair (vertices, faces)"
        )
    try:
        points, corners = np.asarray(vertices), np.asarray(faces)
    except (TypeError, ValueError):
        raise InputError("the mesh's vertices or faces are ragged; expected arrays") from None
    if points.dtype.kind not in "fiu" or (corners.dtype.kind not in "iu" and corners.size):
        raise InputError(
            f"the mesh's vertices are {points.dtype} and its faces {corners.dtype}; expected real "
            "numbers, and whole numbers of vertices"
        )
    result = TriangleMesh(points.astype(np.float64), corners.astype(np.int64))
    if result.faces.ndim != 2 or result.faces.shape[1] != 3 or len(result.faces) == 0:
        raise InputError(
            f"the mesh's faces have shape {result.faces.shape}; expected (f, 3): triangles"
        )
    outside = np.flatnonzero(
        ((result.faces < 0) | (result.faces >= len(result.vertices))).any(axis=1)
    )
    if len(outside):
        raise InputError(
            f"mesh face {outside[0]} is {result.faces[outside[0]].tolist()}, but the vertices are "
            f"numbered 0 to {len(result.vertices) - 1}"
        )
    return result


def part_of(mesh: TriangleMesh, keep: NDArray[Any]) -> tuple[TriangleMesh, Ints]:
    """Return the mesh of some of the faces, and the old numbers of its vertices."""
    used, faces = np.unique(mesh.faces[keep], return_inverse=True)
    return TriangleMesh(mesh.vertices[used], faces.reshape(-1, 3).astype(np.int64)), used


def face_spheres(mesh: TriangleMesh) -> tuple[Array, Array]:
    """Return spheres that hold the faces: their centers, shape (f, 3), and their radii (f,)."""
    corners = mesh.vertices[mesh.faces]
    centers = corners.mean(axis=1)
    return centers, np.linalg.norm(corners - centers[:, None], axis=2).max(axis=1)
