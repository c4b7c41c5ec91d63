"""Cloth that hangs over a body, as a string in a plane."""

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.pattern.hollows.hanging import hanging


def string_over(x: Array, height: Array, away: Array | None = None) -> Array:
    """Where an elastic string hangs that lies on a profile, fixed at both ends."""
    positions = np.stack([x, np.zeros_like(x), height], axis=1)
    tangents = np.gradient(positions, axis=0)
    normals = np.stack([-tangents[:, 2], tangents[:, 1], tangents[:, 0]], axis=1)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    count = len(x)
    ones = np.ones(count - 1)
    links = scipy.sparse.diags_array([ones, ones], offsets=[1, -1]).tocsr()
    stiffness = (scipy.sparse.diags_array(links.sum(axis=1)) - links).tocsr()
    free = np.ones(count, dtype=np.bool_)
    free[[0, -1]] = False
    aside = np.zeros_like(positions) if away is None else away
    return hanging(positions, normals, stiffness, free, aside)


def test_a_string_over_a_valley_is_straight() -> None:
    angle = np.linspace(np.pi, 2.0 * np.pi, 41)
    moved = string_over(np.cos(angle), np.sin(angle))
    np.testing.assert_allclose(moved[:, 2], 0.0, atol=1e-12)
    # It is evenly spaced, whatever lay below it.
    np.testing.assert_allclose(np.diff(moved[:, 0]), 2.0 / 40.0, atol=1e-12)


def test_a_string_over_a_hill_stays_where_it_is() -> None:
    angle = np.linspace(np.pi, 0.0, 41)
    moved = string_over(np.cos(angle), np.sin(angle))
    np.testing.assert_array_equal(moved, np.stack([np.cos(angle), 0 * angle, np.sin(angle)], 1))


def test_a_string_rests_on_a_hill_in_a_valley() -> None:
    x = np.linspace(-1.0, 1.0, 201)
    height = np.where(np.abs(x) < 0.25, 0.4 * (1.0 - (x / 0.25) ** 2), 0.0)
    height = height + 0.2 * (np.abs(x) > 0.9) * (np.abs(x) - 0.9) / 0.1
    moved = string_over(x, height)
    # Tangents from both ends to the hill, and nowhere below the ground.
    assert moved[:, 2].max() < 0.4 + 1e-3
    assert (np.interp(moved[:, 0], x, height) < moved[:, 2] + 1e-3).all()
    slopes = np.diff(moved[:90, 2]) / np.diff(moved[:90, 0])
    taut = slopes[moved[:89, 0] < -0.4]
    assert np.ptp(taut) < 1e-2
    assert taut.mean() > 0.1


def test_cloth_peels_off_an_underside() -> None:
    # A profile that hangs over: its underside faces down, and what is below pulls it down.
    angle = np.linspace(0.5 * np.pi, -0.5 * np.pi, 31)
    bulge = np.stack([0.5 + 0.5 * np.cos(angle), 1.0 + 0.5 * np.sin(angle)], axis=1)
    wall = np.stack([np.full(20, 0.5), np.linspace(0.5, -1.5, 21)[1:]], axis=1)
    foot = np.stack([np.linspace(0.5, 1.0, 11)[1:], np.full(10, -1.5)], axis=1)
    profile = np.concatenate([bulge, wall, foot])
    moved = string_over(profile[:, 0], profile[:, 1])
    # From the bulge it hangs straight down to the foot, as both are equally far out.
    hung = moved[(moved[:, 2] > -1.4) & (moved[:, 2] < 0.9)]
    assert len(hung) > 5
    assert hung[:, 0].min() > 0.95


def test_at_a_fold_cloth_does_not_move_aside() -> None:
    angle = np.linspace(np.pi, 2.0 * np.pi, 41)
    away = np.zeros((41, 3))
    away[20] = [1.0, 0.0, 0.0]
    moved = string_over(np.cos(angle) + 0.1 * (1.0 + np.cos(angle)), np.sin(angle), away)
    assert abs(moved[20, 0] - 0.1) < 1e-3
    assert abs(moved[20, 2]) < 1e-3
