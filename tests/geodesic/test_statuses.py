"""Problems without a length that can be trusted, and their statuses."""

from typing import Any

import numpy as np
import pytest
from helpers.oracles.straight_line import from_straight_line
from helpers.surfaces.surfaces import ENNEPER, PARABOLOID, bicubic

from bodymeasure import ConvergenceError
from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic import (
    WU_C2,
    GeodesicSolution,
    Kernel,
    RBFCollocation,
    Status,
    solve_geodesic,
)

# A patch in the plane z = 0: y = v + 3u (1 - u) / 2, so that its lower edge bulges into it by 3/8.
MOON = bicubic({(1, 0): 2}, {(0, 1): 1, (1, 0): 1.5, (2, 0): -1.5}, {})  # type: ignore[dict-item]
# A plane whose x runs forwards, backwards and forwards again, so that x' changes sign twice.
FOLDED = bicubic({(1, 0): 6, (2, 0): -15, (3, 0): 10}, {(0, 1): 1}, {})


def status_of(net: Array, start: object, end: object, **settings: Any) -> GeodesicSolution:
    return from_straight_line(
        net,
        start,
        end,
        method=RBFCollocation(**settings),
        on_failure="status",
    )


def failed(solution: GeodesicSolution, status: Status) -> None:
    """Check that no number that could be taken for a length comes with a failure."""
    assert solution.status is status
    assert not solution.converged
    assert np.isnan(solution.length)


def test_a_geodesic_that_leaves_its_patch() -> None:
    solution = status_of(MOON, (0.0, 0.1), (1.0, 0.1))
    failed(solution, Status.LEAVES_PATCH)
    # The path is defined all the same: the chord y = 0.1, on the plane continued.
    assert solution.raw_length == pytest.approx(2.0, rel=1e-6)
    u, v = solution.path(np.linspace(0.0, 1.0, 101)).T
    np.testing.assert_allclose(v, 0.1 - 1.5 * u * (1 - u), atol=1e-3)
    assert v.min() == pytest.approx(0.1 - 0.375, abs=1e-3)


@pytest.mark.parametrize("v", [0.3, 0.37, 0.38, 0.45, 1.0])
def test_leaving_is_told_from_staying(v: float) -> None:
    # The chord from (0, v) to (1, v) dips by 0.375.
    solution = status_of(MOON, (0.0, v), (1.0, v))
    if v < 0.375:
        failed(solution, Status.LEAVES_PATCH)
    else:
        assert solution.status is Status.CONVERGED
        assert solution.length == pytest.approx(2.0, rel=1e-13)


def test_a_geodesic_along_the_edge_stays() -> None:
    # Straight edges of a plane and Enneper's symmetry curves must not be rejected by rounding.
    flat = bicubic({(1, 0): 2, (2, 0): 1}, {(0, 1): 3}, {(1, 0): 1})
    ends = [((0, 0), (1, 0)), ((0, 0), (0, 1)), ((1, 0), (1, 1)), ((0.2, 1), (0.9, 1))]
    for start, end in ends:
        assert status_of(flat, start, end).status is Status.CONVERGED
        assert status_of(flat, end, start).status is Status.CONVERGED
    assert status_of(ENNEPER, (0, 0), (0, 1)).status is Status.CONVERGED


def test_a_tolerance_that_cannot_be_met() -> None:
    solution = status_of(PARABOLOID, (0, 0), (1, 1), tolerance=1e-300)
    failed(solution, Status.NOT_CONVERGED)
    assert solution.raw_length == pytest.approx(2.56200713706941, rel=1e-13)
    assert solution.functions == 20


def test_too_few_functions(rng: np.random.Generator) -> None:
    u, v = np.meshgrid(np.linspace(0, 1, 4), np.linspace(0, 1, 4), indexing="ij")
    wild = np.stack([u, v, 0 * u], axis=-1) + 0.25 * rng.normal(size=(4, 4, 3))
    few = status_of(wild, (0, 0), (1, 1), functions=3)
    assert not few.converged
    assert np.isnan(few.length)
    many = status_of(wild, (0, 0), (1, 1))
    if many.converged:
        assert abs(few.raw_length - many.length) > 1e-10


def test_a_fold_across_the_way() -> None:
    solution = status_of(FOLDED, (0, 0), (1, 1))
    assert solution.status in (Status.NOT_CONVERGED, Status.SINGULAR)
    assert np.isnan(solution.length)


@pytest.mark.parametrize(
    "net",
    [
        bicubic({(1, 0): 1}, {}, {}),  # a line: no area anywhere
        bicubic({(1, 0): 1, (0, 1): 1}, {(1, 0): 2, (0, 1): 2}, {}),  # the same, slantwise
        bicubic({(1, 0): 1}, {(2, 0): 1}, {(3, 0): 1}),  # a curve
    ],
    ids=["line", "slanted line", "curve"],
)
def test_patches_without_area_have_no_lengths(net: Array) -> None:
    solution = status_of(net, (0, 0), (1, 1))
    assert solution.status is not Status.CONVERGED
    assert np.isnan(solution.length)
    assert not solution.converged


def test_one_bad_patch_does_not_spoil_the_others() -> None:
    line = bicubic({(1, 0): 1}, {}, {})
    nets = np.stack([ENNEPER, line, FOLDED, MOON, PARABOLOID])
    start, end = np.zeros((5, 2)), np.ones((5, 2))
    start[3], end[3] = (0.0, 0.1), (1.0, 0.1)
    solution = status_of(nets, start, end)
    np.testing.assert_array_equal(solution.converged, [True, False, False, False, True])
    np.testing.assert_array_equal(np.isnan(solution.length), ~solution.converged)
    np.testing.assert_allclose(
        solution.length[[0, 4]], [5 * np.sqrt(2) / 3, 2.56200713706941], rtol=1e-13
    )
    assert np.asarray(solution.status)[3] is Status.LEAVES_PATCH


def test_by_default_a_failure_is_raised() -> None:
    with pytest.raises(ConvergenceError) as caught:
        from_straight_line(MOON, (0.0, 0.1), (1.0, 0.1))
    assert str(caught.value) == Status.LEAVES_PATCH.sentence
    assert isinstance(caught.value, ArithmeticError)


def test_many_failures_are_counted_and_some_are_listed() -> None:
    starts = np.array([(0.0, v) for v in (0.5, 0.1, 0.6, 0.1, 0.1, 0.1, 0.1, 0.1, 0.9)])
    with pytest.raises(ConvergenceError) as caught:
        from_straight_line(MOON, starts, starts + np.array([1.0, 0.0]))
    message = str(caught.value)
    assert message.startswith("6 of 9 geodesics have no length that can be trusted: problem 1: ")
    assert "problem 3: " in message
    assert "problem 6: " in message
    assert "problem 7: " not in message
    assert "and 1 more" in message
    assert 'on_failure="status"' in message
    with pytest.raises(ConvergenceError) as caught:
        from_straight_line(MOON, starts[:2], starts[:2] + np.array([1.0, 0.0]))
    assert "more" not in str(caught.value).split(Status.LEAVES_PATCH.sentence)[1]


def test_statuses_are_sentences() -> None:
    for status in Status:
        assert status.sentence == status.value
        assert status.sentence.endswith(".")
        assert status.sentence[0].isupper()
    # The fault is followed by the remedy.
    for status in set(Status) - {Status.CONVERGED}:
        assert ";" in status.sentence or "," in status.sentence


def test_a_kernel_that_is_not_smooth_enough_is_no_trap() -> None:
    # (1 - r)_+ has no second derivative, so that the equations of collocation say nothing.
    hat = Kernel("hat", 1, (1,), 0)
    solution = status_of(ENNEPER, (0.1, 0.3), (1, 0.5), kernel=hat, centers=(0.2, 0.5, 0.8))
    assert not solution.converged
    assert np.isnan(solution.length)


@pytest.mark.parametrize("functions", [1, 2, 3])
def test_very_few_functions_are_honest(functions: int) -> None:
    for net in (ENNEPER, PARABOLOID):
        solution = status_of(
            net, (0.1, 0.0), (1.0, 0.7), functions=functions, tolerance=1e-2, kernel=WU_C2
        )
        exact = from_straight_line(net, (0.1, 0.0), (1.0, 0.7)).length
        assert solution.raw_length >= exact * (1 - 1e-12)
        if solution.converged:
            assert abs(solution.length - exact) <= solution.error_estimate


def test_a_path_that_turns_sharply_between_its_nodes_is_not_trusted() -> None:
    # This plane patch is folded and nearly has a cusp. With 12 functions all formulas agreed on a
    # length below the distance of the ends; the path turned by 5 on a way as long as itself.
    net = np.zeros((4, 4, 3))
    net[..., 0] = np.array([0.0, 0.1, 2.0, 3.0])[:, None]
    net[..., 1] = [0.0, 1.0, 0.0, 3.0]
    net[:, 2] = (3.0, 0.0, 0.0)
    ends = np.array([(0.0, 0.89571258), (0.78298271, 1.0)])
    chord = np.linalg.norm(np.subtract(*evaluate(net, ends)))
    few = solve_geodesic(net, *ends, method=RBFCollocation(functions=12), on_failure="status")
    assert few.residual > 4.0
    assert not few.converged
    solution = solve_geodesic(net, *ends)
    assert solution.residual < 1.0
    assert abs(solution.length - chord) <= solution.error_estimate
