"""Times a patch, beside accuracies: what twenty years and a better method have gained."""

import time
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic import Method, RBFCollocation, solve_geodesic
from bodymeasure.paper.data import published
from bodymeasure.paper.data.truth import END, START
from bodymeasure.paper.tables.beyond import independent_lengths
from bodymeasure.paper.tables.statistics import known, signed_difference
from bodymeasure.paper.tables.table import Column, Table
from bodymeasure.paper.tables.tables_3_and_4 import ReadingResult

# The first call makes the trial spaces; the shortest of the calls is the time of a batch.
REPEATS = 3
# The patches are repeated until there are so many, as on several bodies.
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


class _Speed(NamedTuple):
    """Seconds a patch of a method, and how accurate it was; None where nothing is known."""

    method: str
    solved: int | None
    median: float | None
    nine_in_ten: float | None
    seconds: float


def speed_table(name: str, result: ReadingResult, batch_size: int = BATCH) -> Table:
    """Return seconds a patch by each method on one set of patches, and how accurate it was.

    Parameters
    ----------
    name : str
        Name of the table.
    result : ReadingResult
    batch_size : int
        Patches, some of them more than once, that are solved together.
    """
    found, control_points = result.found, result.data.control_points.reshape(-1, 4, 4, 3)
    two, ritz = float(found.rbf_seconds.mean()), float(found.ritz_seconds.mean())
    truth, papers = found.true_length, published.SECONDS_BY_RITZ
    rows = [
        _Speed(PAPERS_RITZ, None, None, None, papers),
        _Speed(OUR_RITZ, *_accuracy(found.ritz_length, truth), ritz),
        _Speed(OUR_TWO, *_accuracy(found.inside_length, truth), two),
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
        rows.append(_Speed(label, *_accuracy(lengths, independent), seconds / len(batch)))
    columns = (
        Column("method", "Method", "text"),
        Column("solved", "Solved", "count"),
        Column("median", "Error: median", "small"),
        Column("nine_in_ten", "90 %", "small"),
        Column("seconds", "Seconds a patch", "small", is_timing=True),
        Column(
            "than_paper", "Times as fast as the paper", "factor", lambda r: papers / r.seconds, True
        ),
        Column("than_two", "as our two functions", "factor", lambda r: two / r.seconds, True),
    )
    return Table.of(
        name,
        f"Time a patch: {result.reading.name}",
        columns,
        rows,
        "Ritz and two functions: one patch by itself, as in the paper; bodymeasure: all "
        "patches in one batch, straight to the geodesic without a search for shorter ones, one "
        "thread. Errors are relative, against the truth, of the patches that were solved and "
        "whose truth is known; those of bodymeasure, since the truth is its own, against "
        "polynomial collocation and Ritz of high order, where these agree. Against the paper, "
        "most of the factor is twenty years of computers, and compiled arrays instead of "
        "Mathematica.",
    )


def _accuracy(lengths: Array, truth: Array) -> tuple[int, float | None, float | None]:
    error = np.abs(known(signed_difference(lengths, truth)))
    solved = int(np.isfinite(lengths).sum())
    if len(error) == 0:
        return solved, None, None
    return solved, float(np.median(error)), float(np.quantile(error, 0.9))
