"""Quad meshes on a grid, and atlases of the bicubic B-spline surfaces that they stand for."""

import numpy as np
from helpers.surfaces.grids import grid_atlas
from scipy.interpolate import BSpline

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.subdivision import QuadMesh


def grid_mesh(points: Array) -> QuadMesh:
    """The quads of a grid of vertices (rows, columns, 3)."""
    rows, columns = points.shape[:2]
    number = np.arange(rows * columns).reshape(rows, columns)
    corners = [number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]]
    return QuadMesh(points.reshape(-1, 3), np.stack(corners, axis=-1).reshape(-1, 4))


def spline_matrix(count: int, places: Array, order: int = 0) -> Array:
    """Values of the cubic B-splines of `count` control points, the i-th centered at i."""
    splines = BSpline(np.arange(count + 4) - 2.0, np.eye(count), 3)
    return np.asarray(splines(places, nu=order))


def spline_atlas(points: Array, margin: int) -> Atlas:
    """The B-spline surface of a grid as Bezier patches, without `margin` rows and columns around.

    There is one patch for each quad that is left; u runs with the rows.
    """
    to_bezier = [_to_bezier(size, margin) for size in points.shape[:2]]
    net = np.einsum("ai,bj,ijc->abc", *to_bezier, points)
    rows, columns = (len(matrix) // 3 for matrix in to_bezier)
    return grid_atlas(rows, columns, lambda _x, _y: net)


def _to_bezier(count: int, margin: int) -> Array:
    """The matrix that gives the Bezier points of the spline's pieces, shared ones once."""
    joints = np.arange(margin, count - margin, dtype=np.float64)
    values = spline_matrix(count, joints)
    thirds = spline_matrix(count, joints, order=1) / 3.0
    rows = np.stack([values - thirds, values, values + thirds], axis=1).reshape(-1, count)
    return rows[1:-1]


def cylinder_net(rows: int, columns: int) -> Array:
    """Control points of a cylinder on a spline curve in the xz plane, which is developable."""
    angle = np.linspace(0.2, 2.4, rows)
    curve = np.stack([-3.0 * np.cos(angle), 0.0 * angle, 2.0 * np.sin(angle)], axis=-1)
    along = 0.3 * np.arange(columns)[:, None] * np.array([0.0, 1.0, 0.0])
    return np.asarray(curve[:, None] + along)


def arc_net(rows: int, columns: int) -> Array:
    """Control points of a cylinder on an arc: of radius 1 to five digits, 15 degrees for each."""
    step = 2.0 * np.pi / 24.0
    angle = step * np.arange(rows)
    # Joints of the spline lie at (2 + cos(step)) / 3 of the control points' radius.
    radius = 3.0 / (2.0 + np.cos(step))
    curve = radius * np.stack([-np.cos(angle), 0.0 * angle, np.sin(angle)], axis=-1)
    along = 0.3 * np.arange(columns)[:, None] * np.array([0.0, 1.0, 0.0])
    return np.asarray(curve[:, None] + along)


def hilly_net(rows: int, columns: int) -> Array:
    """Control points of a surface with hills and hollows."""
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    heights = 0.4 * np.sin(0.9 * i + 0.3) * np.cos(0.7 * j)
    return np.asarray(np.stack([i + 0.1 * np.sin(j), 1.1 * j, heights], axis=-1))
