"""Patches and atlases to be checked, sound ones and ones with a fault."""

from dataclasses import replace

import numpy as np
from helpers.surfaces.grids import grid_atlas

from bodymeasure._typing import Array
from bodymeasure.atlas import (
    Atlas,
    Finding,
)

ARC = 4 / 3 * (np.sqrt(2) - 1)


def quarter(start: Array, corner: Array, end: Array) -> Array:
    """Control points of the usual cubic quarter circle around `start + end - corner`."""
    return np.stack([start, start + ARC * (corner - start), end + ARC * (corner - end), end])


def half_cylinder(radius: float = 1.0, height: float = 2.0) -> Array:
    """A bicubic patch whose normal turns by nearly 180 degrees along u, (4, 4, 3)."""
    x = np.array([1.0, 1.0, -1.0, -1.0]) * radius
    y = np.array([0.0, 4 / 3, 4 / 3, 0.0]) * radius
    z = np.linspace(0.0, height, 4)
    return np.stack(np.broadcast_arrays(x[:, None], y[:, None], z[None]), axis=-1)


def lid() -> Array:
    """A quarter of a dome, whose edge u = 0 is collapsed to the tip."""
    rim = quarter(np.array([1.0, 0, 0]), np.array([1.0, 1, 0]), np.array([0.0, 1, 0]))
    radius, height = np.array([0.0, ARC, 1.0, 1.0]), np.array([1.0, 1.0, ARC, 0.0])
    return np.asarray(
        rim[None] * radius[:, None, None] + height[:, None, None] * np.array([0.0, 0, 1])
    )


def flat(x: Array, y: Array) -> Array:
    return np.stack([x, y, 0.0 * x], axis=-1)


def bumpy(rng: np.random.Generator, height: float = 0.3) -> Atlas:
    return grid_atlas(3, 3, lambda x, y: np.stack([x, y, height * rng.random(x.shape)], -1))


def only(findings: tuple[Finding, ...]) -> Finding:
    assert len(findings) == 1, [finding.message for finding in findings]
    return findings[0]


def moved(atlas: Atlas, patch: int, i: int, j: int, offset: Array) -> Atlas:
    points = atlas.points.copy()
    points[atlas.index[patch, i, j]] += offset
    return replace(atlas, points=points)


def separated(atlas: Atlas, patch: int, offset: float = 0.0) -> Atlas:
    """The patch moved up, with control points of its own."""
    own = atlas.control_points[patch].reshape(-1, 3) + np.array([0.0, 0.0, offset])
    index = atlas.index.copy()
    index[patch] = len(atlas.points) + np.arange(16).reshape(4, 4)
    return replace(atlas, points=np.concatenate([atlas.points, own]), index=index)
