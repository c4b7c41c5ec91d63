"""Meshes as their files number them: neither welded nor cleaned, with their polygons."""

from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Ints
from bodymeasure.arguments import numbers, whole_numbers
from bodymeasure.errors import InputError
from bodymeasure.files import read_bytes
from bodymeasure.fit.scan.load import load, require_bytes
from bodymeasure.formats.mesh_vertices import NUMBERED
from bodymeasure.formats.obj.faces import obj_faces


class Polygons(NamedTuple):
    """A mesh.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
        In the unit and the axes of the file.
    corners : ndarray of int
        The vertices of all polygons, one polygon after the other.
    sizes : ndarray of int, shape (polygons,)
        How many corners each has.
    """

    vertices: Array
    corners: Ints
    sizes: Ints

    @property
    def edges(self) -> Ints:
        """The sides of all polygons, shape (corners, 2); most occur twice."""
        ends = np.cumsum(self.sizes)
        following = np.arange(1, len(self.corners) + 1)
        following[ends - 1] = ends - self.sizes
        return np.stack([self.corners, self.corners[following]], axis=1)

    @property
    def triangles(self) -> Ints:
        """The polygons cut into triangles that share their first corner, shape (m, 3)."""
        first = np.cumsum(self.sizes) - self.sizes
        each = self.sizes - 2
        start = np.repeat(first, each)
        step = np.arange(each.sum()) - np.repeat(np.cumsum(each) - each, each)
        return np.stack(
            [self.corners[start + shift] for shift in (0 * step, step + 1, step + 2)], 1
        )


def read_polygons(path: Path) -> Polygons:
    """Read a mesh with the numbers of its vertices.

    Raises
    ------
    InputError
        If the file is damaged, or of a kind that does not number vertices.
    MissingExtraError
        If trimesh is needed and not installed.
    """
    if path.suffix.lower() not in NUMBERED:
        raise InputError(
            f"{path}: files of the kind {path.suffix!r} do not keep the numbers of vertices, on "
            f"which a topology rests; expected one of {', '.join(NUMBERED)}; export the body again"
        )
    require_bytes(path)
    content = read_bytes(path)
    if path.suffix.lower() == ".obj":
        found = obj_faces(content, str(path))
        proper = found.sizes >= 3
        kept = np.repeat(proper, found.sizes)
        result = Polygons(found.points, found.corners[kept], found.sizes[proper])
    else:
        mesh = load(content, path)
        result = Polygons(mesh.vertices, mesh.triangles.ravel(), np.full(len(mesh.triangles), 3))
    if not len(result.sizes):
        raise InputError(f"{path}: holds no face; expected a mesh, export it again")
    return result


def polygons_of(vertices: ArrayLike, faces: ArrayLike) -> Polygons:
    """Return a mesh in memory.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
    faces : array_like of int, shape (m, 3) or (m, 4)

    Raises
    ------
    InputError
        If the arrays are no mesh.
    """
    points = numbers(vertices, "the vertices", "numbers of shape (n, 3)")
    expected = "whole numbers of vertices, of shape (m, 3) or (m, 4)"
    corners = whole_numbers(faces, "the faces", expected)
    if points.ndim != 2 or points.shape[1] != 3 or not np.isfinite(points).all():
        raise InputError(
            f"the vertices have shape {points.shape}; expected (n, 3), and finite numbers"
        )
    if corners.ndim != 2 or corners.shape[1] not in (3, 4):
        raise InputError(f"the faces have shape {corners.shape}; expected {expected}")
    if not len(corners) or corners.min() < 0 or corners.max() >= len(points):
        raise InputError(
            f"the faces must be at least one and refer to vertices 0 to {len(points) - 1}"
        )
    sizes = np.full(len(corners), corners.shape[1])
    return Polygons(points, corners.ravel(), sizes)
