"""Curves as tubes of triangles."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Ints

SIDES = 8
# Rings of a ball from pole to pole.
RINGS = 6
# Neighboring tangents whose sum is shorter than this are opposite, and no rotation is the least.
OPPOSITE = 1e-9


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles with a color at each vertex.

    Parameters
    ----------
    points, normals : ndarray, shape (n, 3)
    triangles : ndarray of int, shape (m, 3)
    colors : ndarray, shape (n, 3)
        In [0, 1], before shading.
    owner : ndarray of int, shape (m,)
        What each triangle is part of.
    """

    points: Array
    normals: Array
    triangles: Ints
    colors: Array
    owner: Ints


def joined(meshes: Sequence[Mesh]) -> Mesh:
    """Return several meshes as one."""
    if not meshes:
        nothing = np.empty((0, 3))
        none = np.empty(0, dtype=np.int64)
        return Mesh(nothing, nothing, none.reshape(0, 3), nothing, none)
    start = np.cumsum([0] + [len(mesh.points) for mesh in meshes[:-1]])
    return Mesh(
        np.concatenate([mesh.points for mesh in meshes]),
        np.concatenate([mesh.normals for mesh in meshes]),
        np.concatenate([mesh.triangles + first for mesh, first in zip(meshes, start, strict=True)]),
        np.concatenate([mesh.colors for mesh in meshes]),
        np.concatenate([mesh.owner for mesh in meshes]),
    )


def tube(points: Array, radius: float, colors: Array, owner: int = 0) -> Mesh:
    """Return a colored tube around a curve, open at its ends.

    Parameters
    ----------
    points : ndarray, shape (k, 3)
        At least two; one that repeats its predecessor has its direction.
    radius : float
    colors : ndarray, shape (k, 3)
    owner : int
    """
    vertices, normals, triangles = tube_surface(points, radius)
    owners = np.full(len(triangles), owner)
    return Mesh(vertices, normals, triangles, np.repeat(colors, SIDES, axis=0), owners)


def tube_surface(points: Array, radius: float, sides: int = SIDES) -> tuple[Array, Array, Ints]:
    """Return the vertices (n, 3), their normals (n, 3) and the triangles (m, 3) of a tube.

    Ring after ring, each around one of the points (k, 3).
    """
    first, second = frames(points)
    angle = 2.0 * np.pi * np.arange(sides) / sides
    normals = (
        np.cos(angle)[:, None] * first[:, None, :] + np.sin(angle)[:, None] * second[:, None, :]
    )
    ring = sides * np.arange(len(points) - 1)[:, None]
    side = np.arange(sides)
    a, b = ring + side, ring + (side + 1) % sides
    quads = [np.stack([a, b, b + sides], axis=-1), np.stack([a, b + sides, a + sides], axis=-1)]
    triangles = np.stack(quads, axis=2).reshape(-1, 3)
    vertices = points[:, None, :] + radius * normals
    return vertices.reshape(-1, 3), normals.reshape(-1, 3), triangles


def ball(center: Array, radius: float, color: Array, owner: int) -> Mesh:
    """Return a ball: a tube from pole to pole that swells and shrinks."""
    latitude = np.pi * (np.arange(RINGS + 1) / RINGS - 0.5)
    longitude = 2.0 * np.pi * np.arange(SIDES) / SIDES
    normals = np.stack(
        [
            np.cos(latitude)[:, None] * np.cos(longitude),
            np.cos(latitude)[:, None] * np.sin(longitude),
            np.repeat(np.sin(latitude)[:, None], SIDES, axis=1),
        ],
        axis=-1,
    ).reshape(-1, 3)
    axis = np.stack([0.0 * latitude, 0.0 * latitude, latitude], axis=-1)
    shell = tube(axis, 1.0, np.tile(color, (RINGS + 1, 1)), owner)
    return Mesh(center + radius * normals, normals, shell.triangles, shell.colors, shell.owner)


def frames(points: Array) -> tuple[Array, Array]:
    """Return two unit vectors across a curve at each of its points that do not turn about it.

    Parameters
    ----------
    points : ndarray, shape (k, 3)

    Returns
    -------
    first, second : ndarray, shape (k, 3)
        Perpendicular to the curve and to each other. From point to point they follow the least
        rotation that takes one tangent to the next.
    """
    tangent = tangents(points)
    # Any perpendicular serves: its turn about the curve is measured, and taken back.
    axis = np.eye(3)[np.argmin(np.abs(tangent), axis=1)]
    first = _cross(tangent, axis)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second = _cross(tangent, first)
    moved = _least_rotation(tangent[:-1], tangent[1:], first[:-1])
    turn = np.arctan2(
        np.einsum("ki,ki->k", moved, second[1:]), np.einsum("ki,ki->k", moved, first[1:])
    )
    angle = np.concatenate([[0.0], np.cumsum(turn)])[:, None]
    straight = np.cos(angle) * first + np.sin(angle) * second
    return straight, _cross(tangent, straight)


def tangents(points: Array) -> Array:
    """Return unit tangents of a polygon at its points, shape (k, 3), also across a closed joint."""
    step = np.diff(points, axis=0)
    length = np.linalg.norm(step, axis=1)
    if not length.any():
        return np.tile([0.0, 0.0, 1.0], (len(points), 1))
    # A step of no length has the direction of the last one before it, or of the first after it.
    last = np.maximum.accumulate(np.where(length > 0.0, np.arange(len(length)), -1))
    step = step[np.where(last >= 0, last, np.argmax(length > 0.0))]
    step = step / np.linalg.norm(step, axis=1, keepdims=True)
    before, after = np.concatenate([step[:1], step]), np.concatenate([step, step[-1:]])
    if np.array_equal(points[0], points[-1]):
        before[0], after[-1] = step[-1], step[0]
    middle = before + after
    size = np.linalg.norm(middle, axis=1, keepdims=True)
    return np.where(size > OPPOSITE, middle / np.maximum(size, OPPOSITE), after)


def _least_rotation(start: Array, end: Array, vector: Array) -> Array:
    """Turn vectors by the least rotation that takes unit vectors to others, all (k, 3)."""
    axis = _cross(start, end)
    cosine = np.einsum("ki,ki->k", start, end)[:, None]
    once = _cross(axis, vector)
    return np.asarray(vector + once + _cross(axis, once) / np.maximum(1.0 + cosine, OPPOSITE))


def _cross(first: Array, second: Array) -> Array:
    """Return the vector products of rows (k, 3), in a quarter of the time of `numpy.cross`."""
    a, b, c = first.T
    x, y, z = second.T
    return np.stack([b * z - c * y, c * x - a * z, a * y - b * x], axis=1)
