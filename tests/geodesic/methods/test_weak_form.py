"""The weak form with radial functions: closer than collocation, and with centers inside, too."""

from typing import Any

import numpy as np
import pytest
from helpers.surfaces.surfaces import SURFACES, Surface

import bodymeasure as bm
from bodymeasure._typing import Array, Bools
from bodymeasure.bench.problems.patches import mild_patches
from bodymeasure.geodesic import Method

# Only rounding puts a length below that of the geodesic.
ROUNDING = 1e-15
# The error of the quadrature that gives the length of a path on few functions.
QUADRATURE = 1e-12


def raw_errors(method: Method, nets: Array, truth: Array) -> tuple[Array, Bools]:
    """By how much the paths are too long, relatively, and which of them were solved."""
    solution = bm.solve_geodesic(nets, (0, 0), (1, 1), method=method, on_failure="status")
    solved = np.zeros(len(nets), bool)
    for batch in solution.batches:
        solved[batch.problems] = batch.converged
    return np.asarray(solution.raw_length / truth - 1.0), solved


@pytest.mark.parametrize(
    ("functions", "ratio"), [(4, 2.0), (6, 2.0), (8, 2.0), (12, 1.6), (16, 1.5)]
)
def test_paths_are_closer_than_by_collocation(functions: int, ratio: float) -> None:
    nets = mild_patches(np.random.default_rng(5), 60, 0.5)
    truth = np.asarray(bm.solve_geodesic(nets, (0, 0), (1, 1)).length)
    settings: Any = {"functions": functions, "tolerance": 1.0}
    strong, _ = raw_errors(bm.RBFCollocation(**settings, form="full"), nets, truth)
    weak, _ = raw_errors(bm.RBFRitz(**settings), nets, truth)
    assert np.median(strong / weak) >= ratio
    assert weak.min() >= -ROUNDING


@pytest.mark.parametrize("kernel", [bm.WU_C2, bm.WU_C4, bm.WU_C6, bm.WU_C10], ids=str)
def test_centers_inside_serve_the_weak_form(kernel: bm.Kernel) -> None:
    nets = mild_patches(np.random.default_rng(6), 60, 0.3)
    truth = np.asarray(bm.solve_geodesic(nets, (0, 0), (1, 1)).length)
    medians = []
    for functions in (6, 12, 24):
        method = bm.RBFRitz(kernel, centers=tuple(np.linspace(0.0, 1.0, functions)), tolerance=1.0)
        errors, solved = raw_errors(method, nets, truth)
        assert solved.sum() >= 55
        assert errors[solved].min() >= -ROUNDING
        medians.append(np.median(errors[solved]))
    # More functions go on helping, which they do not in collocation.
    assert medians[0] > 4.0 * medians[1] > 16.0 * medians[2]


@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
def test_no_length_is_below_the_truth(surface: Surface) -> None:
    for functions in (8, 10, 12):
        for centers in (None, tuple(np.linspace(0.0, 1.0, functions))):
            method = bm.RBFRitz(bm.WU_C4, functions, centers=centers, tolerance=1.0)
            solution = bm.solve_geodesic(
                surface.control_points,
                surface.start,
                surface.end,
                method=method,
                on_failure="status",
            )
            assert solution.raw_length >= surface.length * (1.0 - QUADRATURE)
            # A finer rule than that which was minimized puts all of them above.
            assert solution.bounds.upper >= surface.length * (1.0 - ROUNDING)


def test_wrong_settings_are_refused() -> None:
    with pytest.raises(bm.InputError, match="functions"):
        bm.RBFRitz(functions=0)
    with pytest.raises(bm.InputError, match="expected a Kernel"):
        bm.RBFRitz("C2")  # type: ignore[arg-type]
    with pytest.raises(bm.InputError, match="centers is"):
        bm.RBFRitz(centers=(0.0, np.nan))
    with pytest.raises(bm.InputError, match="tolerance"):
        bm.RBFRitz(tolerance=0.0)


def test_one_function_is_refused() -> None:
    for settings in ({"functions": 1}, {"functions": (4, 1)}, {"centers": [0.5]}):
        with pytest.raises(bm.InputError, match="given 1 function; expected at least 2"):
            bm.RBFRitz(**settings)
