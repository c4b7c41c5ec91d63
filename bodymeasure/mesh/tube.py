"""A chain of points as a tube of triangles."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.mesh.arrays import TriangleMesh

# Sides of a tube: round enough at any size it is looked at.
SIDES = 12


def tube(points: Array, radius: float) -> TriangleMesh:
    """A tube about a chain of points (k, 3), without lids.

    Notes
    -----
    The ring at each point is the one before, turned by the smallest rotation that takes one
    direction to the next, so that the tube does not twist.
    """
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    points = points[np.concatenate([[True], steps > 0.0])]
    if len(points) < 2:
        return TriangleMesh(np.empty((0, 3)), np.empty((0, 3), dtype=np.int64))
    along = np.gradient(points, axis=0)
    # Where a path goes back the way it came, the tube ends and begins again.
    back = np.flatnonzero((along == 0.0).all(axis=1))
    along[back] = points[back] - points[back - 1]
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    side = np.empty_like(points)
    across = np.eye(3)[np.argmin(np.abs(along[0]))]
    for row, direction in enumerate(along):
        across = across - (across @ direction) * direction
        across = across / np.linalg.norm(across)
        side[row] = across
    up = np.cross(along, side)
    angle = 2.0 * np.pi * np.arange(SIDES) / SIDES
    ring = np.cos(angle)[:, None] * side[:, None] + np.sin(angle)[:, None] * up[:, None]
    vertices = points[:, None] + radius * ring
    number = np.arange(len(points) * SIDES).reshape(-1, SIDES)
    a, b = number[:-1], np.roll(number[:-1], -1, axis=1)
    c, d = np.roll(number[1:], -1, axis=1), number[1:]
    faces = np.concatenate([np.stack([a, b, c], axis=-1), np.stack([a, c, d], axis=-1)])
    return TriangleMesh(vertices.reshape(-1, 3), faces.reshape(-1, 3))
