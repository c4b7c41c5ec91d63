"""Random patches: mild ones against another solver, wicked ones against what must always hold."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from reference import chebyshev_times, reference_lengths
from straight_line import from_straight_line

from bodymeasure import InputError
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic import GeodesicSolution, Status, solve_geodesic

Array = NDArray[np.float64]

GRID = np.linspace(0.0, 1.0, 4)
FLAT = np.stack(np.meshgrid(GRID, GRID, [0.0], indexing="ij"), axis=-1)[:, :, 0]

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


Spoil = Callable[[Array, np.random.Generator], Array]


def collapse_row(net: Array, rng: np.random.Generator) -> Array:
    net[rng.integers(4)] = net[rng.integers(4), rng.integers(4)]
    return net


def collapse_column(net: Array, rng: np.random.Generator) -> Array:
    net[:, rng.integers(4)] = net[rng.integers(4), rng.integers(4)]
    return net


def fold(net: Array, rng: np.random.Generator) -> Array:
    return net[rng.permutation(4)]


def stretch(net: Array, rng: np.random.Generator) -> Array:
    net[..., rng.integers(3)] *= 10.0 ** rng.integers(-9, 7)
    return net


def near_cusp(net: Array, rng: np.random.Generator) -> Array:
    net[1] = net[0] + 10.0 ** -float(rng.integers(1, 12)) * (net[1] - net[0])
    return net


def repeat_a_point(net: Array, rng: np.random.Generator) -> Array:
    i, j, k, m = rng.integers(0, 4, 4)
    net[i, j] = net[k, m]
    return net


def flatten(net: Array, rng: np.random.Generator) -> Array:
    net[..., rng.integers(3)] = 0.0
    return net


def move_away(net: Array, rng: np.random.Generator) -> Array:
    return net + 10.0 ** rng.integers(0, 8)


def throw_a_point(net: Array, rng: np.random.Generator) -> Array:
    net[rng.integers(4), rng.integers(4)] += 10.0 * rng.normal(size=3)
    return net


def crumple(net: Array, rng: np.random.Generator) -> Array:
    return net + 0.4 * rng.normal(size=net.shape)


SPOILS: list[Spoil] = [
    collapse_row,
    collapse_column,
    fold,
    stretch,
    near_cusp,
    repeat_a_point,
    flatten,
    move_away,
    throw_a_point,
    crumple,
]

corners = st.sampled_from([(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)])


Ends = tuple[tuple[float, float], tuple[float, float]]


@st.composite
def ends(draw: st.DrawFn) -> Ends:
    start = draw(corners | parameters)
    if draw(st.booleans()):
        return start, draw(corners | parameters)
    # Close by.
    step = 10.0 ** -draw(st.integers(1, 12))
    u, v = (min(1.0, x + step) for x in start)
    return start, (u, v)


def wicked(seed: int, spoils: list[Spoil], size: float) -> Array:
    rng = np.random.default_rng(seed)
    net = FLAT + size * rng.normal(size=FLAT.shape)
    for spoil in spoils:
        net = spoil(net, rng)
    return net


def solved(net: Array, points: Ends) -> GeodesicSolution | None:
    """None if the patch is collapsed, and refused for it."""
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
    """How far a length may be off: the estimate, with room, and rounding of the coordinates.

    The estimate is one of leading order: where it misses at all, it does so by small factors.
    """
    return float(10.0 * solution.error_estimate + 1e-14 * np.abs(net).max())


@given(
    seed=seeds,
    spoils=st.lists(st.sampled_from(SPOILS), max_size=4),
    size=st.sampled_from([0.0, 0.05, 0.2, 0.5]),
    points=ends(),
)
@settings(max_examples=100)
def test_no_patch_is_wicked_enough(
    seed: int, spoils: list[Spoil], size: float, points: Ends
) -> None:
    net = wicked(seed, spoils, size)
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
    first, last = evaluate(net, np.array(points))
    assert solution.length >= np.linalg.norm(last - first) - doubt(net, solution)
    polygon = np.linalg.norm(np.diff(evaluate(net, path), axis=0), axis=1).sum()
    # The length of the path itself, which the correction makes shorter by a small part at most.
    excess = abs(solution.raw_length - solution.length)
    assert polygon <= solution.raw_length * (1 + 1e-12) + doubt(net, solution)
    assert excess <= 1.1e-4 * solution.raw_length


@pytest.mark.slow
@given(
    seed=seeds,
    spoils=st.lists(st.sampled_from(SPOILS), max_size=2),
    size=st.sampled_from([0.0, 0.05, 0.2, 0.5]),
    points=ends(),
)
@settings(max_examples=300)
def test_lengths_on_wicked_patches_are_those_of_another_solver(
    seed: int, spoils: list[Spoil], size: float, points: Ends
) -> None:
    net = wicked(seed, spoils, size)
    solution = solved(net, points)
    if solution is not None and solution.converged:
        path = solution.path(chebyshev_times(25))
        known = float(reference_lengths(net[None], *points, guess=path[None])[0])
        if np.isfinite(known):
            assert abs(solution.length - known) <= doubt(net, solution) + 1e-13 * known
