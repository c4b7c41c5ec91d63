"""Farthest points and girths of smooth surfaces that are known in closed form."""

import numpy as np
import pytest

from bodymeasure._typing import Array
from bodymeasure.extremities.surface import breadth, farthest, girth, patchworks
from bodymeasure.subdivision import QuadMesh

AROUND = 24
RADIUS = 0.1
# On a regular polygon of control vertices, the limit of a vertex of a cubic B-spline curve lies by
# this factor nearer to the center; between vertices, the curve stays within 1e-6 of that circle.
SHRUNK = (2.0 + np.cos(2.0 * np.pi / AROUND)) / 3.0


def tube() -> QuadMesh:
    """A tube along z whose limit surface is a cylinder."""
    angle = 2.0 * np.pi * np.arange(AROUND) / AROUND
    heights = np.linspace(0.0, 0.5, 12)
    rings = [
        np.stack([np.cos(angle), np.sin(angle), np.full(AROUND, z / RADIUS)], 1) for z in heights
    ]
    number = np.arange(len(heights) * AROUND).reshape(-1, AROUND)
    low, high = number[:-1], number[1:]
    quads = np.stack([low, np.roll(low, -1, 1), np.roll(high, -1, 1), high], axis=-1)
    return QuadMesh(RADIUS * np.concatenate(rings), quads.reshape(-1, 4))


MESH = tube()
STEPS = patchworks(MESH, np.ones(len(MESH.vertices), dtype=np.bool_))
MIDDLE = np.array([0.0, 0.0, 0.25])
CURVE = 3e-6


@pytest.mark.parametrize("tilt", [0.0, 0.4, 0.8])
def test_the_girth_of_a_tilted_section_is_that_of_an_ellipse(tilt: float) -> None:
    normal = np.array([0.0, np.sin(tilt), np.cos(tilt)])
    found = girth(STEPS, MIDDLE, normal)
    t = np.linspace(0.0, 2.0 * np.pi, 20001)
    ellipse = np.stack([np.cos(t), np.sin(t) / np.cos(tilt)], axis=1) * RADIUS * SHRUNK
    known = np.linalg.norm(np.diff(ellipse, axis=0), axis=1).sum()
    assert abs(found.value - known) <= found.error + CURVE * known
    assert found.error < 1e-3 * known


def test_breadths_and_farthest_points() -> None:
    up = np.array([0.0, 0.0, 1.0])
    across = breadth(STEPS, MIDDLE, up)
    assert abs(across.value - 2.0 * RADIUS * SHRUNK) <= across.error + CURVE
    # Between two control vertices.
    direction = np.array([np.cos(0.1), np.sin(0.1), 0.0])

    def far(points: Array) -> Array:
        return np.asarray(points @ direction)

    point, distance = farthest(STEPS, far)
    assert abs(distance.value - RADIUS * SHRUNK) <= distance.error + CURVE * RADIUS
    assert point[:2] == pytest.approx(RADIUS * SHRUNK * direction[:2], abs=2e-4)


def test_only_the_part_that_is_meant_counts() -> None:
    lower = patchworks(MESH, MESH.vertices[:, 2] < 0.3)
    top, height = farthest(lower, lambda points: points[:, 2])
    level = np.unique(MESH.vertices[:, 2])
    assert height.value == pytest.approx(level[level < 0.3].max(), abs=1e-12)
    assert top[2] == height.value
