"""Distributed collocation: one batch split over processes, and what that wins."""

import time
from collections.abc import Callable, Sequence
from dataclasses import fields
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.oracle.workers import map_in_processes
from bodymeasure.paper.data.comparison import in_chunks
from bodymeasure.paper.method.two_function_solve import TwoFunctionSolution, solve_two_functions
from bodymeasure.paper.tables.table import Column, Table, rows_of

# So that no speedup is divided by zero where a start takes as long as the work.
LEAST_SECONDS = 1e-3


class Run(NamedTuple):
    """A batch solved by some processes: the solution, and seconds by the clock.

    `start` is what it takes until the processes stand ready, NaN if that was not measured;
    `seconds` is all of it.
    """

    processes: int
    solution: TwoFunctionSolution
    start: float
    seconds: float


def solve_distributed(
    control_points: Array, processes: int, progress: Callable[[int], None] | None = None
) -> TwoFunctionSolution:
    """`solve_two_functions` inside the patch, with the batch split over processes.

    The parts are the same however many processes there are, so that the solution is too, to the
    last bit.

    Parameters
    ----------
    control_points : ndarray, shape (patches, 4, 4, 3)
    processes : int
    progress : callable, optional
        Called with the number of parts that are done.
    """
    parts = map_in_processes(
        _solve_part, in_chunks(control_points), processes=processes, progress=progress, apart=True
    )
    return TwoFunctionSolution(
        **{
            f.name: np.concatenate([getattr(part, f.name) for part in parts])
            for f in fields(TwoFunctionSolution)
        }
    )


def _solve_part(control_points: Array) -> TwoFunctionSolution:
    return solve_two_functions(control_points, "inside")


def _nothing(_number: int) -> None:
    """What a worker does first in `measure_scaling`: load this module."""


def measure_scaling(
    control_points: Array,
    processes: Sequence[int],
    progress: Callable[[int], None] | None = None,
    *,
    with_start: bool = True,
) -> list[Run]:
    """Solve a batch with one number of processes after the other.

    Parameters
    ----------
    progress : callable, optional
        Called with the number of runs that are done.
    with_start : bool
        Whether the start is measured too, which takes as long again.
    """
    runs = []
    for done, number in enumerate(processes, start=1):
        begin = time.perf_counter()
        if with_start:
            map_in_processes(_nothing, list(range(number)), processes=number, apart=True)
        ready = time.perf_counter()
        solution = solve_distributed(control_points, number)
        start = ready - begin if with_start else float("nan")
        runs.append(Run(number, solution, start, time.perf_counter() - ready))
        if progress is not None:
            progress(done)
    return runs


def same_to_the_bit(first: TwoFunctionSolution, second: TwoFunctionSolution) -> bool:
    """Whether two solutions are equal, NaN being equal to NaN."""
    return all(
        np.array_equal(getattr(first, f.name), getattr(second, f.name), equal_nan=True)
        for f in fields(TwoFunctionSolution)
    )


def scaling_table(runs: Sequence[Run]) -> Table:
    """Time, speedup and whether the result is the same."""
    one = runs[0]
    rows = [
        (
            run.processes,
            len(run.solution.length),
            same_to_the_bit(one.solution, run.solution),
            run.seconds,
            run.start,
            one.seconds / run.seconds,
            (one.seconds - one.start) / np.maximum(run.seconds - run.start, LEAST_SECONDS),
        )
        for run in runs
    ]
    return Table(
        "scaling",
        "Distributed collocation",
        (
            Column("processes", "Processes", "count"),
            Column("patches", "Patches", "count"),
            Column("identical", "Same to the last bit as one process", "text"),
            Column("seconds", "Seconds by the clock", "seconds", is_timing=True),
            Column("start_seconds", "of these to start", "seconds", is_timing=True),
            Column("speedup", "Speedup", "factor", is_timing=True),
            Column("speedup_started", "once started", "factor", is_timing=True),
        ),
        rows_of(rows),
        (
            "The batch is cut into the same parts whatever the number of processes, and each "
            "process is one thread. The start is measured by itself, with processes that load "
            "the package and do nothing.",
        ),
    )
