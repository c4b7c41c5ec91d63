"""Chains of a mesh drawn as smooth curves."""

import numpy as np
import pytest

from bodymeasure._typing import Array
from bodymeasure.pattern.flat.smooth_chain import smooth_chain


def length(points: Array) -> float:
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def chain_of_arcs(radius: float, step: float, count: int) -> Array:
    """A chain whose sides are as long as the arcs of a circle for which they stand."""
    # Its corners lie on a circle that is wider, so that both have the same length.
    turn = step / radius
    wider = 0.5 * step / np.sin(0.5 * turn)
    angle = turn * np.arange(count + 1)
    return np.asarray(wider * np.stack([np.cos(angle), np.sin(angle)], axis=1))


@pytest.mark.parametrize("radius", [30.0, 60.0, 400.0])
def test_the_arc_of_a_circle_comes_back_from_its_sides(radius: float) -> None:
    chain = chain_of_arcs(radius, 8.0, 20)
    curve = smooth_chain(chain)
    assert length(curve) == pytest.approx(160.0, abs=1e-8)
    np.testing.assert_allclose(curve[[0, -1]], chain[[0, -1]])
    # Both ends stay, where other edges meet it; between them it is the circle.
    inner = np.linalg.norm(curve, axis=1)[len(curve) // 5 : -len(curve) // 5]
    assert np.abs(inner - radius).max() < 0.01
    assert np.abs(np.linalg.norm(chain, axis=1) - radius).max() > 2.0 * np.abs(inner - radius).max()


def test_it_turns_little_from_chord_to_chord() -> None:
    chain = chain_of_arcs(40.0, 8.0, 20)
    along = np.diff(smooth_chain(chain), axis=0)
    turn = np.diff(np.unwrap(np.arctan2(along[:, 1], along[:, 0])))
    assert np.degrees(np.abs(turn)).max() < 4.0
    assert np.degrees(8.0 / 40.0) > 11.0


def test_corners_and_straight_parts_stay() -> None:
    arc = chain_of_arcs(60.0, 8.0, 12)
    tail = arc[-1] + np.array([[-400.0, 0.0]])
    curve = smooth_chain(np.concatenate([arc, tail]))
    np.testing.assert_array_equal(curve[-2:], np.concatenate([arc[-1:], tail]))
    corner = np.array([[0.0, 0.0], [8.0, 0.0], [16.0, 0.0], [16.0, 8.0], [16.0, 16.0]])
    np.testing.assert_array_equal(smooth_chain(corner), corner)
    straight = np.stack([np.arange(10.0), np.zeros(10)], axis=1)
    np.testing.assert_allclose(smooth_chain(straight), straight, atol=1e-12)
