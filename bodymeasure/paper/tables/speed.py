"""What twenty years and a better method have won: time a patch, beside accuracy."""

import time

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic import Method, RBFCollocation, solve_geodesic
from bodymeasure.paper.data import published
from bodymeasure.paper.data.truth import END, START
from bodymeasure.paper.tables.beyond import independent_lengths
from bodymeasure.paper.tables.table import Column, Table, rows_of
from bodymeasure.paper.tables.tables_3_and_4 import ReadingResult, signed_difference

# The first call makes the trial spaces; the least of the others is what a batch takes.
REPEATS = 3
# Patches are taken again to make up so many, as on a row of bodies.
BATCH = 2000
PAPERS_RITZ, OUR_RITZ, OUR_TWO = (
    "the paper's Ritz, 2007",
    "our Ritz, Table 2",
    "our two functions, all solutions",
)
OUR_METHODS: tuple[tuple[str, Method], ...] = (
    ("bodymeasure, default", RBFCollocation()),
    ("bodymeasure, to 1e-6", RBFCollocation(functions=(8, 12, 16), tolerance=1e-6)),
)


def speed_table(name: str, result: ReadingResult, batch_size: int = BATCH) -> Table:
    """Seconds a patch by each method on one set of patches, and how accurate it was.

    Parameters
    ----------
    name : str
        Of the table.
    result : ReadingResult
    batch_size : int
        Patches, some of them more than once, that are solved together.
    """
    found, control_points = result.found, result.data.control_points.reshape(-1, 4, 4, 3)
    two, ritz = float(found.rbf_seconds.mean()), float(found.ritz_seconds.mean())
    truth = found.true_length
    rows = [
        (PAPERS_RITZ, None, None, None, published.SECONDS_BY_RITZ),
        (OUR_RITZ, *_accuracy(found.ritz_length, truth), ritz),
        (OUR_TWO, *_accuracy(found.inside_length, truth), two),
    ]
    independent = independent_lengths(control_points)
    times = -(-batch_size // len(control_points))
    batch = np.tile(control_points, (times, 1, 1, 1))
    for label, method in OUR_METHODS:
        seconds = np.inf
        for _ in range(REPEATS):
            begin = time.thread_time()
            solution = solve_geodesic(batch, START, END, method=method, on_failure="status")
            seconds = min(seconds, time.thread_time() - begin)
        lengths = solution.length[: len(control_points)]
        rows.append((label, *_accuracy(lengths, independent), seconds / len(batch)))
    return Table(
        name,
        f"Time a patch: {result.reading.name}",
        (
            Column("method", "Method", "text"),
            Column("solved", "Solved", "count"),
            Column("median", "Error: median", "small"),
            Column("nine_in_ten", "90 %", "small"),
            Column("seconds", "Seconds a patch", "small", is_timing=True),
            Column("than_paper", "Times as fast as the paper", "factor", is_timing=True),
            Column("than_two", "as our two functions", "factor", is_timing=True),
        ),
        rows_of((*row, published.SECONDS_BY_RITZ / row[-1], two / row[-1]) for row in rows),
        (
            "Ritz and two functions: one patch by itself, as in the paper; bodymeasure: all "
            "patches in one batch, straight to the geodesic without a search for shorter ones, one "
            "thread. Errors are relative, against the truth, of the patches that were solved and "
            "whose truth is known; those of bodymeasure, since the truth is its own, against "
            "polynomial collocation and Ritz of high order, where these agree. Against the paper, "
            "most of the factor is twenty years of computers, and compiled arrays instead of "
            "Mathematica.",
        ),
    )


def _accuracy(lengths: Array, truth: Array) -> tuple[int, float | None, float | None]:
    error = np.abs(signed_difference(lengths, truth))
    error = error[np.isfinite(error)]
    solved = int(np.isfinite(lengths).sum())
    if len(error) == 0:
        return solved, None, None
    return solved, float(np.median(error)), float(np.quantile(error, 0.9))
