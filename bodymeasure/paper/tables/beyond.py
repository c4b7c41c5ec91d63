"""Beyond 2007: accuracy and cost against the number of functions, and where they stand."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

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
from bodymeasure.paper.method.two_functions import even_points, paper_centers
from bodymeasure.paper.tables.table import Column, Table, Value, rows_of

# Every length counts whose correction can be trusted at all.
ANY = 1.0
COUNTS = (2, 3, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24)
FEW_COUNTS = (2, 4, 8, 12)
KERNELS = (WU_C2, WU_C4, WU_C6, WU_C10)
ENDS = {"diagonal": ((0.0, 0.0), (1.0, 1.0))}


@dataclass(frozen=True, eq=False)
class Known:
    """Patches whose diagonal stays inside, and its length."""

    name: str
    control_points: Array
    length: Array


@dataclass(frozen=True)
class Setting:
    """A family of methods by the number of functions."""

    family: str
    make: Callable[[int], Method]


def known_diagonals(name: str, control_points: Array) -> Known:
    """Those of some patches whose diagonal is known by `independent_lengths`."""
    lengths = independent_lengths(control_points)
    rows = np.flatnonzero(np.isfinite(lengths))
    return Known(name, control_points[rows], lengths[rows])


def independent_lengths(control_points: Array) -> Array:
    """Lengths of diagonals that are geodesics inside their patch, NaN for others.

    Found by polynomial collocation and Ritz, which must agree: radial functions are judged by what
    they had no part in.
    """
    solutions = [
        solve_geodesic(control_points, *ENDS["diagonal"], method=method, on_failure="status")
        for method in (
            PolynomialCollocation(degrees=(16, 24, 32), tolerance=1e-12),
            Ritz(order=(16, 24, 32), tolerance=1e-12),
        )
    ]
    first, second = (solution.length for solution in solutions)
    with np.errstate(invalid="ignore"):
        agree = np.abs(first - second) <= 1e-10 * first
    return np.asarray(np.where(agree, first, np.nan))


def settings() -> tuple[Setting, ...]:
    """The families that are compared."""
    families = [Setting(f"RBF {k.name}, centers outside", _outside(k)) for k in KERNELS]
    for kernel in (WU_C2, WU_C10):
        families += [
            Setting(f"RBF {kernel.name}, centers from 1 on, even nodes", _paper(kernel)),
            Setting(f"RBF {kernel.name}, centers from 1 on, Chebyshev nodes", _from_one(kernel)),
            Setting(f"RBF {kernel.name}, centers at Chebyshev points", _chebyshev(kernel)),
            Setting(f"RBF {kernel.name}, centers and nodes even", _even(kernel)),
        ]
    families.append(
        Setting(
            "polynomial collocation",
            lambda n: PolynomialCollocation(degrees=n, tolerance=ANY, form="full"),
        )
    )
    families.append(Setting("Ritz, u and v free", lambda n: Ritz(order=n, tolerance=ANY)))
    families.append(
        Setting("Ritz, u = t", lambda n: Ritz(order=n, tolerance=ANY, parametrization="u"))
    )
    return tuple(families)


def _outside(kernel: Kernel) -> Callable[[int], Method]:
    return lambda n: _rbf(kernel, default_centers(kernel, n).tolist(), None)


def _paper(kernel: Kernel) -> Callable[[int], Method]:
    return lambda n: _rbf(kernel, paper_centers(n), even_points(n))


def _from_one(kernel: Kernel) -> Callable[[int], Method]:
    return lambda n: _rbf(kernel, paper_centers(n), None)


def _chebyshev(kernel: Kernel) -> Callable[[int], Method]:
    return lambda n: _rbf(kernel, [0.0, *chebyshev_points(n - 2), 1.0], None)


def _even(kernel: Kernel) -> Callable[[int], Method]:
    return lambda n: _rbf(kernel, np.linspace(0.0, 1.0, n).tolist(), even_points(n))


def _rbf(kernel: Kernel, centers: Sequence[float], points: Sequence[float] | None) -> Method:
    return RBFCollocation(
        kernel, centers=centers, collocation_points=points, tolerance=ANY, form="full"
    )


def beyond_table(
    problems: Sequence[Known],
    counts: Sequence[int],
    progress: Callable[[int], None] | None = None,
) -> Table:
    """Errors and cost of every family at every number of functions.

    Parameters
    ----------
    problems : sequence of Known
    counts : sequence of int
    progress : callable, optional
        Called with the number of families that are done.
    """
    rows: list[tuple[Value, ...]] = []
    for number, setting in enumerate(settings(), start=1):
        for count in counts:
            rows += [
                (known.name, setting.family, count, *_judged(setting, count, known))
                for known in problems
            ]
        if progress is not None:
            progress(number)
    return Table(
        "beyond",
        "Accuracy and cost against the number of functions",
        (
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
        ),
        rows_of(rows),
        (
            "Relative errors: of the paths as they are, all patches counted; and with the "
            "correction, where it is small enough to be trusted. A polynomial of degree N and "
            "Ritz's of order N have as many unknowns as N functions and a constant. An empty row: "
            "the system is degenerate.",
        ),
    )


def _judged(setting: Setting, count: int, known: Known) -> tuple[float | int | None, ...]:
    try:
        method = setting.make(count)
        solve_geodesic(
            known.control_points[:1], *ENDS["diagonal"], method=method, on_failure="status"
        )
    except InputError:
        return (None, 0, len(known.length), None, None, None, None, None)
    begin = time.thread_time()
    solution = solve_geodesic(
        known.control_points, *ENDS["diagonal"], method=method, on_failure="status"
    )
    seconds = time.thread_time() - begin
    good = solution.converged
    # Where Newton's method went astray, the path may have no length.
    raw = np.abs(solution.raw_length / known.length - 1.0)
    raw = np.where(np.isfinite(raw), raw, np.inf)
    corrected = np.abs(solution.length[good] / known.length[good] - 1.0)
    figures = [
        (float(np.median(error)), float(np.quantile(error, 0.9, method="lower")))
        if len(error)
        else (None, None)
        for error in (raw, corrected)
    ]
    condition = float(solution.condition.max())
    each = 1e6 * seconds / len(known.length)
    return (condition, int(good.sum()), int((~good).sum()), *figures[0], *figures[1], each)
