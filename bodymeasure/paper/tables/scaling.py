"""Distributed collocation: one batch split over processes, and the speedup."""

import time
from collections.abc import Callable, Sequence
from dataclasses import fields
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.oracle.workers import map_in_processes
from bodymeasure.paper.data.comparison import in_chunks, joined
from bodymeasure.paper.method.two_function_solve import TwoFunctionSolution, solve_two_functions
from bodymeasure.paper.tables.table import Column, Table

# Keeps a speedup from being divided by zero where the start takes as long as the work.
LEAST_SECONDS = 1e-3


class Run(NamedTuple):
    """A batch solved by some processes: the solution, and seconds by the clock.

    `start` is the time until the processes are ready, NaN if that was not measured; `seconds` is
    all of the time.
    """

    processes: int
    solution: TwoFunctionSolution
    start: float
    seconds: float


def solve_distributed(
    control_points: Array, processes: int, progress: Callable[[int], None] | None = None
) -> TwoFunctionSolution:
    """Return `solve_two_functions` inside the patch, with the batch split over processes.

    The parts are the same however many processes there are, and so is the solution, to the last
    bit.

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
    return joined(TwoFunctionSolution, parts)


def _solve_part(control_points: Array) -> TwoFunctionSolution:
    return solve_two_functions(control_points, "inside")


def _nothing(_number: int) -> None:
    """Do nothing: a worker that is sent this loads the module, for `measure_scaling`."""


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
        Whether the start is measured too, which doubles the time.
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
    """Return whether two solutions are equal, where NaN is equal to NaN."""
    return all(
        np.array_equal(getattr(first, f.name), getattr(second, f.name), equal_nan=True)
        for f in fields(TwoFunctionSolution)
    )


def scaling_table(runs: Sequence[Run]) -> Table:
    """Return times, speedups, and whether the result is the same."""
    one = runs[0]

    def speedup_started(run: Run) -> float:
        least = np.maximum(run.seconds - run.start, LEAST_SECONDS)
        return float((one.seconds - one.start) / least)

    columns = (
        Column("processes", "Processes", "count"),
        Column("patches", "Patches", "count", lambda run: len(run.solution.length)),
        Column(
            "identical",
            "Same to the last bit as one process",
            "text",
            lambda run: same_to_the_bit(one.solution, run.solution),
        ),
        Column("seconds", "Seconds by the clock", "seconds", is_timing=True),
        Column("start_seconds", "of these to start", "seconds", lambda run: run.start, True),
        Column("speedup", "Speedup", "factor", lambda run: one.seconds / run.seconds, True),
        Column("speedup_started", "once started", "factor", speedup_started, True),
    )
    return Table.of(
        "scaling",
        "Distributed collocation",
        columns,
        runs,
        "The batch is cut into the same parts whatever the number of processes, and each "
        "process is one thread. The start is measured by itself, with processes that load "
        "the package and do nothing.",
    )
