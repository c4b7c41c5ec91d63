"""Beyond 2007: accuracy and cost against the number of functions, and by their centers."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.geodesic import (
    WU_C2,
    WU_C4,
    WU_C6,
    WU_C10,
    Kernel,
    Method,
    PolynomialCollocation,
    RBFCollocation,
    Ritz,
    solve_geodesic,
)
from bodymeasure.geodesic.methods.rbf_collocation import chebyshev_points, default_centers
from bodymeasure.paper.data.truth import END, START
from bodymeasure.paper.method.two_functions import even_points, paper_centers
from bodymeasure.paper.tables.table import Column, Table

# The tolerance with which every length counts whose correction can be trusted at all.
ANY = 1.0
COUNTS = (2, 3, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24)
FEW_COUNTS = (2, 4, 8, 12)
KERNELS = (WU_C2, WU_C4, WU_C6, WU_C10)


@dataclass(frozen=True, eq=False)
class Known:
    """Patches whose diagonal stays inside, and the length of the diagonal."""

    name: str
    control_points: Array
    length: Array


@dataclass(frozen=True)
class Setting:
    """A family of methods by the number of functions."""

    family: str
    make: Callable[[int], Method]


def known_diagonals(name: str, control_points: Array) -> Known:
    """Return those patches whose diagonal is known by `independent_lengths`."""
    lengths = independent_lengths(control_points)
    rows = np.flatnonzero(np.isfinite(lengths))
    return Known(name, control_points[rows], lengths[rows])


def independent_lengths(control_points: Array) -> Array:
    """Return lengths of diagonals that are geodesics inside their patch, NaN for others.

    They are found by polynomial collocation and Ritz, which must agree, so that radial functions
    are compared with what they had no part in.
    """
    solutions = [
        solve_geodesic(control_points, START, END, method=method, on_failure="status")
        for method in (
            PolynomialCollocation(degrees=(16, 24, 32), tolerance=1e-12),
            Ritz(order=(16, 24, 32), tolerance=1e-12),
        )
    ]
    first, second = (solution.length for solution in solutions)
    with np.errstate(invalid="ignore"):
        agree = np.abs(first - second) <= 1e-10 * first
    return np.asarray(np.where(agree, first, np.nan))


def families() -> tuple[Setting, ...]:
    """Return the families that are compared."""
    radial = [
        Setting(f"RBF {k.name}, centers outside", _rbf(k, partial(_outside, k), None))
        for k in KERNELS
    ]
    for kernel in (WU_C2, WU_C10):
        radial += [
            Setting(f"RBF {kernel.name}, {where}", _rbf(kernel, centers, points))
            for where, centers, points in (
                ("centers from 1 on, even nodes", paper_centers, even_points),
                ("centers from 1 on, Chebyshev nodes", paper_centers, None),
                ("centers at Chebyshev points", _at_chebyshev_points, None),
                ("centers and nodes even", _even, even_points),
            )
        ]
    full = partial(PolynomialCollocation, tolerance=ANY, form="full")
    ritz = partial(Ritz, tolerance=ANY)
    return (
        *radial,
        Setting("polynomial collocation", lambda n: full(degrees=n)),
        Setting("Ritz, u and v free", lambda n: ritz(order=n)),
        Setting("Ritz, u = t", lambda n: ritz(order=n, parametrization="u")),
    )


def _outside(kernel: Kernel, functions: int) -> Sequence[float]:
    centers: list[float] = default_centers(kernel, functions).tolist()
    return centers


def _at_chebyshev_points(functions: int) -> Sequence[float]:
    return [0.0, *chebyshev_points(functions - 2), 1.0]


def _even(functions: int) -> Sequence[float]:
    centers: list[float] = np.linspace(0.0, 1.0, functions).tolist()
    return centers


def _rbf(
    kernel: Kernel,
    centers: Callable[[int], Sequence[float]],
    points: Callable[[int], Sequence[float]] | None,
) -> Callable[[int], Method]:
    """Return what makes the method of so many functions, by centers and collocation points."""
    return lambda n: RBFCollocation(
        kernel,
        centers=centers(n),
        collocation_points=None if points is None else points(n),
        tolerance=ANY,
        form="full",
    )


class _Row(NamedTuple):
    """The result of a method with some number of functions on some patches."""

    patches: str
    family: str
    functions: int
    condition: float | None
    solved: int
    failed: int
    raw_median: float | None
    raw_nine_in_ten: float | None
    median: float | None
    nine_in_ten: float | None
    microseconds: float | None


def beyond_table(
    problems: Sequence[Known],
    counts: Sequence[int],
    progress: Callable[[int], None] | None = None,
) -> Table:
    """Return errors and cost of every family at every number of functions.

    Parameters
    ----------
    problems : sequence of Known
    counts : sequence of int
    progress : callable, optional
        Called with the number of families that are done.
    """
    rows = []
    for number, setting in enumerate(families(), start=1):
        rows += [_row(setting, count, known) for count in counts for known in problems]
        if progress is not None:
            progress(number)
    columns = (
        Column("patches", "Patches", "text"),
        Column("family", "Method", "text"),
        Column("functions", "Functions", "count"),
        Column("condition", "Condition number", "small"),
        Column("solved", "Trusted", "count"),
        Column("failed", "Not", "count"),
        Column("raw_median", "Error of the path's length: median", "small"),
        Column("raw_nine_in_ten", "90 %", "small"),
        Column("median", "With the correction: median", "small"),
        Column("nine_in_ten", "90 %", "small"),
        Column("microseconds", "Microseconds each", "number", is_timing=True),
    )
    return Table.of(
        "beyond",
        "Accuracy and cost against the number of functions",
        columns,
        rows,
        "Relative errors: of the paths as they are, all patches counted; and with the "
        "correction, where it is small enough to be trusted. A polynomial of degree N and "
        "Ritz's of order N have as many unknowns as N functions and a constant. An empty row: "
        "the system is degenerate.",
    )


def _row(setting: Setting, count: int, known: Known) -> _Row:
    of, total = (known.name, setting.family, count), len(known.length)
    try:
        method = setting.make(count)
        # The first call makes the trial spaces, and is not timed.
        solve_geodesic(known.control_points[:1], START, END, method=method, on_failure="status")
    except InputError:
        return _Row(*of, None, 0, total, *[None] * 5)
    begin = time.thread_time()
    solution = solve_geodesic(known.control_points, START, END, method=method, on_failure="status")
    seconds = time.thread_time() - begin
    good = solution.converged
    # Where Newton's method diverged, the path may have no length.
    raw = np.abs(solution.raw_length / known.length - 1.0)
    raw = np.where(np.isfinite(raw), raw, np.inf)
    corrected = np.abs(solution.length[good] / known.length[good] - 1.0)
    return _Row(
        *of,
        solution.condition.max(),
        good.sum(),
        (~good).sum(),
        *_median_and_most(raw),
        *_median_and_most(corrected),
        1e6 * seconds / total,
    )


def _median_and_most(error: Array) -> tuple[float | None, float | None]:
    """Return the median, and what 90 % of the errors do not exceed; None without errors."""
    if not len(error):
        return None, None
    return float(np.median(error)), float(np.quantile(error, 0.9, method="lower"))
