"""Convergence with the number of functions: rates fitted down to a stated floor."""

import numpy as np
import pytest
from helpers.oracles.straight_line import from_straight_line
from helpers.surfaces.surfaces import PH_CYLINDER, SURFACES, ph_cylinder_length

from bodymeasure.geodesic import (
    WU_C2,
    WU_C4,
    WU_C6,
    WU_C10,
    GeodesicSolution,
    Kernel,
    RBFCollocation,
)

T = np.linspace(0.0, 1.0, 101)
LENGTH = ph_cylinder_length((0.0, 0.0), (1.0, 1.0))
DEVELOPABLE = next(s for s in SURFACES if s.name == "tangent_developable")


def exact_path() -> np.ndarray:
    """(u, v) on the cylinder at constant speed: 3u + u^3 = 4t, v = t."""
    # Cardano, for u^3 + 3u - 4t
    root = np.sqrt(4 * T**2 + 1)
    return np.stack([np.cbrt(2 * T + root) + np.cbrt(2 * T - root), T], axis=-1)


def on_cylinder(method: RBFCollocation) -> GeodesicSolution:
    return from_straight_line(
        PH_CYLINDER, (0.0, 0.0), (1.0, 1.0), method=method, on_failure="status"
    )


def errors(methods: list[RBFCollocation]) -> tuple[np.ndarray, np.ndarray]:
    """The errors of the path and of its uncorrected length."""
    solutions = [on_cylinder(method) for method in methods]
    path = [float(np.abs(s.path(T) - exact_path()).max()) for s in solutions]
    return np.array(path), np.array([abs(s.raw_length / LENGTH - 1.0) for s in solutions])


def order(counts: tuple[int, ...], error: np.ndarray) -> float:
    return float(-np.polyfit(np.log(counts), np.log(error), 1)[0])


@pytest.mark.parametrize(
    ("kernel", "counts", "least", "most"),
    [
        # Kernels that are more often differentiable converge faster; of C2, which is barely
        # smooth enough for collocation, the order 2 is reached; the smoother ones fall faster
        # than algebraically still.
        (WU_C2, (12, 16, 20, 24), 1.7, 2.5),
        (WU_C4, (8, 12, 16, 20), 5.0, 9.0),
        pytest.param(WU_C6, (8, 12, 16, 20), 5.0, 10.0, marks=pytest.mark.slow),
        pytest.param(WU_C10, (8, 12, 16, 20), 6.0, 12.0, marks=pytest.mark.slow),
    ],
    ids=lambda value: value.name if isinstance(value, Kernel) else None,
)
def test_centers_inside_converge_algebraically(
    kernel: Kernel, counts: tuple[int, ...], least: float, most: float
) -> None:
    methods = [
        RBFCollocation(
            kernel,
            centers=tuple(0.5 - 0.5 * np.cos(np.pi * np.arange(n) / (n - 1))),
            form="full",
        )
        for n in counts
    ]
    path, length = errors(methods)
    rate = order(counts, path)
    assert least < rate < most
    # Length is stationary at a geodesic, so that its error is that of the path squared, less where
    # the error lies in the highest frequencies, whose slopes are large.
    assert order(counts, length) > 1.4 * rate
    assert (length < 40.0 * path**1.5).all()


@pytest.mark.parametrize(
    ("kernel", "counts"),
    [
        (WU_C2, range(3, 9)),
        (WU_C4, range(3, 10)),
        (WU_C6, range(3, 13)),
        (WU_C10, range(3, 17)),
    ],
    ids=lambda value: value.name if isinstance(value, Kernel) else None,
)
def test_centers_outside_converge_spectrally(kernel: Kernel, counts: range) -> None:
    # Up to the kernel's degree all centers lie outside, and the functions are polynomials.
    path, length = errors([RBFCollocation(kernel, functions=n, form="full") for n in counts])
    floor = 1e-14
    digits_a_function = -np.polyfit(counts, np.log10(path), 1)[0]
    assert digits_a_function > 0.5
    above = length > floor
    assert above.sum() >= 5
    digits_a_function = -np.polyfit(np.array(counts)[above], np.log10(length[above]), 1)[0]
    assert digits_a_function > 0.9


def test_the_default_kernel_goes_down_to_rounding() -> None:
    path, length = errors([RBFCollocation(functions=n, form="full") for n in (16, 18, 20)])
    assert (path < [2e-9, 2e-10, 2e-11]).all()
    assert (length < 2e-15).all()


@pytest.mark.parametrize("kernel", [WU_C2, WU_C4, WU_C6, WU_C10], ids=lambda k: k.name)
def test_the_correction_about_doubles_the_digits(kernel: Kernel) -> None:
    found = []
    for count in range(4, 9):
        solution = from_straight_line(
            DEVELOPABLE.control_points,
            DEVELOPABLE.start,
            DEVELOPABLE.end,
            method=RBFCollocation(kernel, functions=count, tolerance=1e-2),
            on_failure="status",
        )
        if solution.converged:
            raw = abs(solution.raw_length / DEVELOPABLE.length - 1.0)
            corrected = abs(solution.length / DEVELOPABLE.length - 1.0)
            found.append((raw, corrected))
            assert corrected <= 4e-15 + 20.0 * raw**1.7
    assert len(found) >= 3
    assert max(raw for raw, _ in found) > 1e-7
