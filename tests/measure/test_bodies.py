"""All diagonals of the five mannequins, compared with an independent solver."""

import numpy as np
import pytest
from helpers.bodies import BODIES
from helpers.oracles.reference import chebyshev_times, reference_lengths

from bodymeasure import load_sample
from bodymeasure.geodesic import GeodesicSolution, Status, solve_geodesic
from bodymeasure.measure.patches.cross_check import Verdict, cross_check
from bodymeasure.measure.patches.diagonals import DIAGONAL_ENDS, DIAGONAL_STARTS, diagonals

bodies = pytest.mark.parametrize("name", BODIES)


def geodesics(name: str) -> GeodesicSolution:
    return solve_geodesic(
        load_sample(name).control_points[:, None],
        DIAGONAL_STARTS,
        DIAGONAL_ENDS,
        on_failure="status",
        search="straight",
    )


@pytest.mark.slow
@bodies
def test_every_diagonal_is_right_or_says_why_not(name: str) -> None:
    solution = geodesics(name)
    assert solution.shape == (376, 2)
    np.testing.assert_array_equal(np.isnan(solution.length), ~solution.converged)
    assert all(isinstance(status, Status) for status in np.asarray(solution.status).ravel())
    # Few paths leave their patches, and hardly one is not found.
    assert (~solution.converged).sum() <= 20
    assert (np.asarray(solution.status) == Status.NOT_CONVERGED).sum() <= 2

    rows = np.flatnonzero(solution.converged.ravel())
    nets = np.repeat(load_sample(name).control_points, 2, axis=0)[rows]
    start, end = solution.start.reshape(-1, 2)[rows], solution.end.reshape(-1, 2)[rows]
    length = solution.length.ravel()[rows]
    estimate = solution.error_estimate.ravel()[rows]
    known = reference_lengths(nets, start, end)
    # The other solver is given more degrees or a better start where it needs them.
    missing = np.flatnonzero(np.isnan(known))
    assert len(missing) <= 20
    paths = solution.path(chebyshev_times(25)).reshape(-1, 25, 2)[rows[missing]]
    known[missing] = reference_lengths(
        nets[missing], start[missing], end[missing], paths, degrees=(56, 80)
    )
    assert np.isfinite(known).mean() > 0.995
    at_all = np.isfinite(known)
    error, known = np.abs(length - known)[at_all], known[at_all]
    estimate = estimate[at_all]
    assert (error <= 1e-8 * known).all()
    # The rounding errors of either solver.
    rounding = 1e-15 * known
    assert (error <= estimate + rounding).mean() >= 0.99
    assert np.median(estimate / np.maximum(error, rounding)) <= 100.0


@pytest.mark.slow
@bodies
def test_libigl_agrees(name: str) -> None:
    pytest.importorskip("igl")
    atlas = load_sample(name)
    solution = diagonals(atlas)
    # With the search along edges, every diagonal of the samples has a length.
    assert solution.converged.all()
    assert (np.asarray(solution.status) == Status.ON_BOUNDARY).any()
    checked = cross_check(atlas, solution, processes=2)
    relative = np.abs(checked.relative_difference)
    assert np.median(relative) <= 1e-6
    assert relative.max() <= 1e-4
    assert (checked.verdict == Verdict.AGREES).all()
