"""The methods on triangle meshes that the paper's introduction names, with exact ones beside."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from time import process_time

import numpy as np

from bodymeasure.bench.entrants.entrants import (
    MESH_METHODS,
    POINTS_A_SIDE,
    entrants,
    points_setting,
)
from bodymeasure.bench.problems.patches import first_diagonals
from bodymeasure.paper.tables.beyond import Known
from bodymeasure.paper.tables.table import Column, Table


@dataclass(frozen=True)
class _Row:
    patches: str
    method: str
    tried: int
    failures: int
    errors: tuple[float, ...]
    order: float
    seconds: float


def named_methods_table(
    sets: Iterable[Known],
    points_a_side: Sequence[int] = POINTS_A_SIDE,
    progress: Callable[[int], object] = lambda _done: None,
) -> Table:
    """Return the errors of each method on meshes of several sizes.

    Parameters
    ----------
    sets : iterable of Known
    points_a_side : sequence of int
        Of those that the benchmark has; at least two.
    progress : callable, optional
        Called with the number of sets that are done.
    """
    rows: list[_Row] = []
    for number, known in enumerate(sets, start=1):
        rows += [_row(known, method, points_a_side) for method in _methods()]
        progress(number)
    errors = [
        Column(f"error_{points}", points_setting(points), "small", _nth_error(number))
        for number, points in enumerate(points_a_side)
    ]
    return Table.of(
        "named_methods",
        "Methods on triangle meshes",
        (
            Column("patches", "Patches"),
            Column("method", "Method"),
            Column("tried", "Diagonals", "count"),
            Column("failures", "No length", "count"),
            *errors,
            Column("order", "Order", "number"),
            Column("seconds", "Time on the finest", "seconds", is_timing=True),
        ),
        rows,
        "Errors are relative, against converged lengths, and medians of the diagonals that have a "
        "length; failures are those on the finest mesh. The order is the power of the mesh's step "
        "with which they fall. [4] is shot at its end; [5] and [6] are written after the paper's "
        "words, since the articles were not at hand.",
    )


def _methods() -> list[str]:
    """Return the methods on meshes that are installed."""
    there = {each.method for each in entrants()}
    return [method for method in MESH_METHODS if method in there]


def _nth_error(number: int) -> Callable[[_Row], float]:
    return lambda row: row.errors[number]


def _row(known: Known, method: str, points_a_side: Sequence[int]) -> _Row:
    problems = first_diagonals(known.control_points)
    every = {(each.method, each.setting): each for each in entrants()}
    errors = []
    for points in points_a_side:
        solve = every[method, points_setting(points)].prepare(problems)
        begin = process_time()
        length = solve()
        seconds = (process_time() - begin) / max(1, len(length))
        away = np.abs(length / known.length - 1.0)
        has_length = np.isfinite(away)
        errors.append(float(np.median(away[has_length])) if has_length.any() else np.nan)
    steps = np.log(np.array(points_a_side) - 1.0)
    # No error is 0, and none is missing.
    order = (
        -float(np.polyfit(steps, np.log(errors), 1)[0])
        if (np.array(errors) > 0.0).all()
        else np.nan
    )
    failures = int((~has_length).sum())
    return _Row(known.name, method, len(length), failures, tuple(errors), order, seconds)
