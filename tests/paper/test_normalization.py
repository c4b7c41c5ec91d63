import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from bodymeasure import InputError, solve_geodesic
from bodymeasure._typing import Array
from bodymeasure.paper import normalize
from bodymeasure.paper.method.normalization import SIDES, Side

# A few rounding errors of coordinates up to 1000 that are scaled to 1.
ROUNDING = 1e-12

nets = arrays(np.float64, (2, 4, 4, 3), elements=st.floats(-1000.0, 1000.0, width=32)).filter(
    lambda net: float(np.ptp(net, axis=(1, 2)).max(axis=1).min()) > 1.0
)
sides = st.sampled_from(SIDES)


@given(nets, sides)
def test_patches_fill_the_unit_cube_along_at_least_one_axis(net: Array, side: Side) -> None:
    points = normalize(net, side).control_points
    assert points.min() >= 0.0
    assert (points.min(axis=(1, 2)) == 0.0).all()
    assert (points.max(axis=(1, 2, 3)) == 1.0).all()


@given(nets, sides)
def test_the_way_back_leads_to_the_original_points(net: Array, side: Side) -> None:
    normalized = normalize(net, side)
    back = normalized.original_points(normalized.control_points)
    np.testing.assert_allclose(back, net, rtol=0.0, atol=1000.0 * ROUNDING)


@given(nets, sides)
def test_rotations_are_proper(net: Array, side: Side) -> None:
    rotation = normalize(net, side).rotation
    product = rotation @ np.swapaxes(rotation, -1, -2)
    np.testing.assert_allclose(product, np.broadcast_to(np.eye(3), (2, 3, 3)), atol=ROUNDING)
    np.testing.assert_allclose(np.linalg.det(rotation), 1.0, rtol=ROUNDING)


@given(nets)
def test_the_longest_side_of_the_box_lies_along_x(net: Array) -> None:
    normalized = normalize(net)
    extent = np.ptp(normalized.control_points, axis=(1, 2))
    assert (extent[:, 0] == 1.0).all()
    np.testing.assert_allclose(
        normalized.scale, np.ptp(net, axis=(1, 2)).max(axis=1), rtol=ROUNDING
    )


@given(nets)
def test_the_longest_chord_lies_along_x(net: Array) -> None:
    normalized = normalize(net, "chord")
    for patch, scale, original in zip(
        normalized.control_points, normalized.scale, net, strict=True
    ):
        corners = np.array([patch[0, 0], patch[3, 0], patch[3, 3], patch[0, 3]])
        chords = np.roll(corners, -1, axis=0) - corners
        corners = np.array([original[0, 0], original[3, 0], original[3, 3], original[0, 3]])
        lengths = np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1)
        longest = chords[np.linalg.norm(chords, axis=1).argmax()]
        assert np.abs(longest[0]) * scale == pytest.approx(lengths.max(), rel=1e-9, abs=1e-9)


@given(nets, sides)
def test_doing_it_twice_changes_nothing(net: Array, side: Side) -> None:
    once = normalize(net, side)
    twice = normalize(once.control_points, side)
    # Where two sides are the longest, rounding decides which one is chosen; the second turn may
    # then differ by a right angle, and nothing can be said about the points.
    if np.abs(twice.rotation - np.eye(3)).max() < 0.1:
        np.testing.assert_allclose(twice.control_points, once.control_points, atol=1e-6)
        np.testing.assert_allclose(twice.scale, 1.0, rtol=1e-6)


@pytest.mark.parametrize("side", SIDES)
def test_lengths_scale_back(side: Side, rng: np.random.Generator) -> None:
    u, v = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
    net = np.stack([u, 2.0 * v, rng.random((4, 4))], axis=-1) * 7.0 + [100.0, -30.0, 4.0]
    normalized = normalize(net, side)
    there = solve_geodesic(normalized.control_points, (0.0, 0.0), (1.0, 1.0)).length
    here = solve_geodesic(net, (0.0, 0.0), (1.0, 1.0)).length
    assert float(normalized.original_lengths(there)) == pytest.approx(here, rel=1e-11)


def test_a_patch_without_extent_is_refused() -> None:
    with pytest.raises(InputError, match="all its control points are equal"):
        normalize(np.ones((4, 4, 3)))


def test_an_unknown_side_is_refused() -> None:
    side: object = "height"
    with pytest.raises(InputError, match="longest is 'height'; expected one of box, chord"):
        normalize(np.arange(48.0).reshape(4, 4, 3), side)  # type: ignore[arg-type]
