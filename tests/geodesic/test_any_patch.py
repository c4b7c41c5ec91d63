"""Mild random patches against another solver; adversarial ones against what must always hold."""

import numpy as np
import pytest
from helpers.oracles.reference import chebyshev_times, reference_lengths
from helpers.oracles.straight_line import from_straight_line
from helpers.surfaces.adversarial_patches import FLAT, SPOILS, Spoil, adversarial_patch
from hypothesis import given, settings
from hypothesis import strategies as st

from bodymeasure import InputError
from bodymeasure._typing import Array
from bodymeasure.bezier import derivatives, evaluate
from bodymeasure.geodesic import GeodesicSolution, Status, solve_geodesic

parameters = st.tuples(st.floats(0.0, 1.0), st.floats(0.0, 1.0))
seeds = st.integers(0, 2**32 - 1)


@given(seed=seeds, size=st.floats(0.0, 0.12))
@settings(max_examples=10)
def test_mild_patches_agree_with_another_solver(seed: int, size: float) -> None:
    rng = np.random.default_rng(seed)
    nets = FLAT + size * rng.normal(size=(3, 4, 4, 3))
    start = np.array([(0.0, 0.0), (1.0, 0.0), (0.1, 0.4)])
    end = np.array([(1.0, 1.0), (0.0, 1.0), (0.9, 0.7)])
    solution = from_straight_line(nets, start, end, on_failure="status")
    known = reference_lengths(nets, start, end)
    both = solution.converged & np.isfinite(known)
    if size < 0.02:
        assert both.all()
    error = np.abs(solution.length - known)[both]
    assert (error <= solution.error_estimate[both] + 1e-13 * known[both]).all()
    assert (error <= 1e-9 * known[both]).all()


corners = st.sampled_from([(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)])


Ends = tuple[tuple[float, float], tuple[float, float]]


@st.composite
def ends(draw: st.DrawFn) -> Ends:
    start = draw(corners | parameters)
    if draw(st.booleans()):
        return start, draw(corners | parameters)
    # The end is close to the start.
    step = 10.0 ** -draw(st.integers(1, 12))
    u, v = (min(1.0, x + step) for x in start)
    return start, (u, v)


def solved(net: Array, points: Ends) -> GeodesicSolution | None:
    """The solution, or None if the patch is refused because it is collapsed."""
    if np.ptp(net, axis=(0, 1)).max() == 0.0:
        with pytest.raises(InputError, match="degenerate"):
            solve_geodesic(net, *points)
        return None
    before = net.copy()
    # Warnings are errors in these tests.
    solution = from_straight_line(net, *points, on_failure="status")
    np.testing.assert_array_equal(net, before)
    return solution


def doubt(net: Array, solution: GeodesicSolution) -> float:
    """The allowed error of a length: several times its estimate, and the coordinates' rounding.

    The estimate is of leading order: where it is too small, it is so by a small factor.
    """
    return float(10.0 * solution.error_estimate + 1e-14 * np.abs(net).max())


def assert_length_fits(net: Array, points: Ends, solution: GeodesicSolution) -> None:
    """Check that a length is no less than the chord, nor than a polygon inscribed in the path."""
    first, last = evaluate(net, np.array(points))
    assert solution.length >= np.linalg.norm(last - first) - doubt(net, solution)
    polygon = evaluate(net, solution.path(np.linspace(0.0, 1.0, 17)))
    inscribed = np.linalg.norm(np.diff(polygon, axis=0), axis=1).sum()
    # The raw length is that of the path itself.
    assert inscribed <= solution.raw_length * (1 + 1e-12) + doubt(net, solution)


@given(
    seed=seeds,
    spoils=st.lists(st.sampled_from(SPOILS), max_size=4),
    size=st.sampled_from([0.0, 0.05, 0.2, 0.5]),
    points=ends(),
)
@settings(max_examples=100)
def test_no_patch_breaks_the_default_settings(
    seed: int, spoils: list[Spoil], size: float, points: Ends
) -> None:
    net = adversarial_patch(seed, spoils, size)
    solution = solved(net, points)
    if solution is None:
        return
    assert solution.converged == (solution.status is Status.CONVERGED)
    path = solution.path(np.linspace(0.0, 1.0, 17))
    np.testing.assert_allclose(path[[0, -1]], points, rtol=0.0, atol=1e-15)
    if not solution.converged:
        assert np.isnan(solution.length)
        return
    assert np.isfinite(solution.length)
    assert np.isfinite(solution.error_estimate)
    assert solution.local_minimum
    assert path.min() >= -1e-9
    assert path.max() <= 1.0 + 1e-9
    assert_length_fits(net, points, solution)
    # The correction makes the length shorter by a small part at most.
    excess = abs(solution.raw_length - solution.length)
    assert excess <= 1.1e-4 * solution.raw_length


@pytest.mark.slow
@given(
    seed=seeds,
    spoils=st.lists(st.sampled_from(SPOILS), max_size=2),
    size=st.sampled_from([0.0, 0.05, 0.2, 0.5]),
    points=ends(),
)
@settings(max_examples=300)
def test_lengths_on_adversarial_patches_are_those_of_another_solver(
    seed: int, spoils: list[Spoil], size: float, points: Ends
) -> None:
    net = adversarial_patch(seed, spoils, size)
    solution = solved(net, points)
    if solution is not None and solution.converged:
        path = solution.path(chebyshev_times(25))
        known = float(reference_lengths(net[None], *points, guess=path[None])[0])
        if np.isfinite(known):
            assert abs(solution.length - known) <= doubt(net, solution) + 1e-13 * known


def straight_length(net: Array, points: Ends, pieces: int) -> float:
    """The length on the patch of the straight line in (u, v)."""
    nodes, weights = np.polynomial.legendre.leggauss(8)
    times = (np.arange(pieces)[:, None] + (nodes + 1.0) / 2.0).ravel() / pieces
    start, end = np.array(points)
    d = derivatives(net, start + times[:, None] * (end - start), 1)
    velocity = d[:, 1, 0] * (end - start)[0] + d[:, 0, 1] * (end - start)[1]
    return float(np.linalg.norm(velocity, axis=1) @ np.tile(weights, pieces) / (2.0 * pieces))


@pytest.mark.slow
@given(
    seed=seeds,
    spoils=st.lists(st.sampled_from(SPOILS), max_size=3),
    size=st.sampled_from([0.0, 0.05, 0.2, 0.5]),
    points=ends(),
)
@settings(max_examples=100)
def test_no_patch_breaks_the_search(
    seed: int, spoils: list[Spoil], size: float, points: Ends
) -> None:
    net = adversarial_patch(seed, spoils, size)
    alone = solved(net, points)
    if alone is None:
        return
    solution = solve_geodesic(net, *points, on_failure="status")
    path = solution.path(np.linspace(0.0, 1.0, 65))
    places, ends_of_path = (evaluate(net, np.array(each)) for each in (points, path[[0, -1]]))
    # On a collapsed edge different parameters give the same point.
    np.testing.assert_allclose(ends_of_path, places, rtol=0.0, atol=1e-14 * np.abs(net).max())
    assert solution.converged == Status(solution.status).has_length == np.isfinite(solution.length)
    assert not alone.converged or solution.converged
    if not solution.converged:
        return
    assert np.isfinite(solution.error_estimate)
    assert np.abs(path - 0.5).max() <= 0.5 + 1e-9
    assert (solution.status is Status.ON_BOUNDARY) == (len(solution.contacts) > 0)
    assert_length_fits(net, points, solution)
    coarse, fine = (straight_length(net, points, pieces) for pieces in (64, 128))
    assert solution.length <= fine + 2.0 * abs(fine - coarse) + doubt(net, solution)
    if alone.converged:
        assert solution.length <= alone.length + doubt(net, solution) + doubt(net, alone)
