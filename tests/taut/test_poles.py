"""Taut tapes on surfaces with poles, the collapsed edges of patches."""

import math

import numpy as np
import pytest
from helpers.surfaces.quadrics import joined, sphere_nets, stretched

import bodymeasure as bm
from bodymeasure.taut.skin import Skin

SPHERE = joined(sphere_nets())
PAIRS = [
    # The string lost its feet near the pole.
    pytest.param(
        (bm.AtlasPoint(7, 0.18782474, 0.39249178), bm.AtlasPoint(5, 0.23189988, 0.84122799)),
        marks=pytest.mark.slow,
    ),
    (bm.AtlasPoint(7, 0.21521817, 0.63933137), bm.AtlasPoint(2, 0.80505483, 0.96367087)),
    # From a pole, and from beside one.
    (bm.AtlasPoint(0, 0.3, 1.0), bm.AtlasPoint(1, 0.4, 0.3)),
    pytest.param(
        (bm.AtlasPoint(0, 0.3, 1.0 - 1e-9), bm.AtlasPoint(2, 0.4, 0.3)), marks=pytest.mark.slow
    ),
]


def great_circle(start: bm.AtlasPoint, end: bm.AtlasPoint) -> float:
    p, q = SPHERE.position(start), SPHERE.position(end)
    return math.atan2(float(np.linalg.norm(np.cross(p, q))), float(p @ q))


def beside_edges(rng: np.random.Generator) -> bm.AtlasPoint:
    """A random point in a patch, on an edge, or a hair off one."""
    off = 10.0 ** rng.uniform(-16.0, -1.0, 2)
    kind = rng.integers(4, size=2)
    choices = np.stack([rng.random(2), off, 1.0 - off, rng.integers(2, size=2)])
    u, v = choices[kind, [0, 1]].tolist()
    return bm.AtlasPoint(int(rng.integers(8)), u, v)


@pytest.mark.parametrize("ends", PAIRS)
def test_on_a_sphere_it_is_a_great_circle(ends: tuple[bm.AtlasPoint, bm.AtlasPoint]) -> None:
    tape = bm.taut_tape(SPHERE, *ends, on_failure="status")
    assert tape.converged
    assert abs(tape.length - great_circle(*ends)) <= tape.error_estimate <= 1e-5


@pytest.mark.slow
def test_random_points_beside_edges_of_a_sphere(rng: np.random.Generator) -> None:
    for _ in range(12):
        ends = beside_edges(rng), beside_edges(rng)
        tape = bm.taut_tape(SPHERE, *ends, on_failure="status")
        assert tape.converged, ends
        assert abs(tape.length - great_circle(*ends)) <= tape.error_estimate + 1e-14, ends
        assert tape.error_estimate <= 1e-5, ends


@pytest.mark.parametrize("factors", [(1.0, 1.0, 1.0), (1.0, 0.7, 0.4)])
def test_feet_are_found_round_poles(
    factors: tuple[float, float, float], rng: np.random.Generator
) -> None:
    skin = Skin(joined(stretched(sphere_nets(), factors)), "determined")
    angle, far = rng.uniform(0.0, 2.0 * np.pi, 200), 10.0 ** rng.uniform(-12.0, -1.0, 200)
    x, y = far * np.cos(angle), far * np.sin(angle)
    z = np.sqrt(1.0 - x**2 - y**2)
    positions = np.stack([x, y, z], axis=1) * factors
    normal = positions / np.square(factors)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    for off in (1e-3, -1e-3):
        feet = skin.feet(positions + off * normal)
        np.testing.assert_allclose(feet.position, positions, atol=1e-9)
        np.testing.assert_allclose(feet.gap, off, rtol=1e-6)
        # The curvatures of an ellipsoid's pole are its height over the squares of its other axes.
        curvatures = factors[2] / np.square(factors[:2])
        np.testing.assert_allclose(
            np.diagonal(feet.bend, axis1=1, axis2=2)[far < 1e-3, :2],
            np.broadcast_to(curvatures, ((far < 1e-3).sum(), 2)),
            rtol=1e-2,
        )
