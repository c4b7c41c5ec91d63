from math import comb

import numpy as np
import pytest
from helpers.surfaces.surfaces import ENNEPER, PARABOLOID, PH_CYLINDER, PLANE

from bodymeasure import Atlas, boundary_lengths
from bodymeasure._typing import Array
from bodymeasure.measure.patches.boundary import curve_lengths


def atlas(*nets: Array) -> Atlas:
    return Atlas.from_control_points(np.stack(nets), "cm")


def parabola(end: float) -> float:
    """The length of (x, x^2) from 0 to `end`."""
    return float(end * np.sqrt(1 + 4 * end**2) / 2 + np.arcsinh(2 * end) / 4)


def test_lengths_in_closed_form() -> None:
    # The order is u = 0, u = 1, v = 0, v = 1. On the cylinder's Pythagorean-hodograph profile the
    # speed is the polynomial 3 + 3u^2.
    lengths = boundary_lengths(atlas(PH_CYLINDER, PARABOLOID, ENNEPER))
    assert lengths.length.shape == lengths.error_estimate.shape == (3, 4)
    # Enneper: |S_u| = |S_v| = 1 + u^2 + v^2.
    exact = np.array([[3, 3, 4, 4], 4 * [parabola(1.0)], [4 / 3, 7 / 3, 4 / 3, 7 / 3]])
    error = np.abs(lengths.length - exact)
    assert (error <= 4e-15 * exact).all()
    assert (error <= lengths.error_estimate).all()
    assert (lengths.error_estimate < 1e-13 * exact).all()


def test_straight_sides_at_uneven_speed() -> None:
    corners = PLANE[[0, 0, 3, 3], [0, 3, 0, 3]]
    a, b, c, _ = corners
    # These are the sides u = 0 and v = 0; the others are curves in the plane.
    chords = [np.linalg.norm(p - a) for p in (b, c)]
    lengths = boundary_lengths(atlas(PLANE)).length[0]
    np.testing.assert_allclose(lengths[[0, 2]], chords, rtol=1e-14)


def test_a_collapsed_side_has_no_length() -> None:
    net = PLANE.copy()
    net[0] = net[0, 0]
    lengths = boundary_lengths(atlas(net))
    assert lengths.length[0, 0] == lengths.error_estimate[0, 0] == 0.0
    assert (lengths.length[0, 1:] > 0.0).all()


@pytest.mark.parametrize("scale", [1e-6, 1e6])
def test_scale_and_direction(scale: float) -> None:
    once = boundary_lengths(atlas(PLANE, ENNEPER))
    scaled = boundary_lengths(atlas(scale * PLANE[::-1], scale * ENNEPER[::-1]))
    np.testing.assert_allclose(scaled.length[:, [1, 0, 2, 3]] / scale, once.length, rtol=4e-15)


def with_cusp(place: float) -> tuple[Array, float]:
    """The control points of (0, (t - t0)^2, (t - t0)^3) and its length."""

    def bezier(*powers: float) -> list[float]:
        return [sum(comb(i, k) / comb(3, k) * a for k, a in enumerate(powers)) for i in range(4)]

    def half(s: float) -> float:
        # The integral of s sqrt(4 + 9 s^2)
        return float(((4 + 9 * s * s) ** 1.5 - 8) / 27)

    second = bezier(place**2, -2 * place, 1.0, 0.0)
    third = bezier(-(place**3), 3 * place**2, -3 * place, 1.0)
    return np.stack([np.zeros(4), second, third], axis=1), half(place) + half(1 - place)


def test_at_a_cusp_the_estimate_is_honest(rng: np.random.Generator) -> None:
    places = np.concatenate([[0.25, 1 / 3, 0.5], rng.uniform(0.02, 0.98, 200)])
    nets, exact = zip(*(with_cusp(place) for place in places.tolist()), strict=True)
    length, estimate = curve_lengths(np.stack(nets))
    error = np.abs(length - np.array(exact))
    assert (error < 1e-7).all()
    # The error depends on where in its part the cusp lies, and so jumps from halving to halving.
    assert (error <= estimate).mean() > 0.95
    assert (error <= 20.0 * estimate).all()
    assert np.median(estimate) < 1e-7


def test_nearly_a_cusp(rng: np.random.Generator) -> None:
    # The speeds nearly vanish; the lengths are compared with those of the same curves in 4000
    # parts.
    net, _ = with_cusp(0.37)
    for beside in (1e-2, 1e-4, 1e-8):
        curve = net + beside * rng.normal(size=net.shape)
        length, estimate = curve_lengths(curve[None])
        t = np.linspace(0.0, 1.0, 200_001)[:, None]
        b = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3]
        points = sum((b[i] * curve[i] for i in range(1, 4)), b[0] * curve[0])
        polygon = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
        assert abs(length[0] - polygon) < 1e-9 + estimate[0]


def test_other_degrees() -> None:
    line = np.array([[[0.0, 0.0, 0.0], [3.0, 4.0, 0.0]]])
    assert curve_lengths(line)[0] == pytest.approx(5.0, rel=1e-15)
