"""What the reproduction was to reach, and whether it did: misses stand beside the rest."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from bodymeasure.paper.data import published
from bodymeasure.paper.tables.speed import OUR_METHODS, OUR_RITZ
from bodymeasure.paper.tables.table import Column, Table, Value, rows_of
from bodymeasure.paper.tables.tables_3_and_4 import ReadingResult, mean_or_none, signed_difference

# "Of the same order": up to three times the published mean, or down to a third of it; a set's mean
# of heavy-tailed losses is no better known than that.
ORDER = 3.0
# Mean size of the diagonals' errors in Table 5; the paper's four are off by 0.28 to 1.06 %.
TABLE_5_ERROR = 0.002
# Times as fast: as the paper's Ritz in 2007, and as our own two functions with all solutions.
THAN_PAPER, THAN_TWO = 1000.0, 50.0


def accuracy_bars(chosen: ReadingResult, table_5_error: float) -> Table:
    """Means of Table 4's sets, and of Table 5, against what they were to be.

    Parameters
    ----------
    chosen : ReadingResult
        The reading that Table 4 is judged by.
    table_5_error : float
        Mean size of the relative errors of all diagonals in Table 5.
    """
    low, high = published.MEAN_LOSS / ORDER, published.MEAN_LOSS * ORDER
    rows: list[tuple[Value, ...]] = []
    for name, found in chosen.groups[:-1]:
        loss = signed_difference(found.inside_length, found.ritz_length)
        mean = mean_or_none(loss[np.isfinite(loss)])
        met = mean is not None and low <= mean <= high
        rows.append((f"Table 4, set {name}: mean accuracy loss", mean, low, high, met))
    what = "Table 5: mean size of the diagonals' errors"
    rows.append((what, table_5_error, None, TABLE_5_ERROR, table_5_error <= TABLE_5_ERROR))
    return Table(
        "bars_accuracy",
        "Accuracy",
        (
            Column("what", "What", "text"),
            Column("found", "Found", "fine"),
            Column("least", "At least", "fine"),
            Column("most", "At most", "fine"),
            Column("met", "Reached", "text"),
        ),
        rows_of(rows),
        (
            f"Table 4 is that of reading “{chosen.reading.name}” with the solution inside the "
            "patch; it is to be of the order of the paper's mean.",
        ),
    )


def speed_bars(tables: Sequence[Table]) -> Table:
    """Of each set the fastest of our methods that is as accurate as Ritz, and how fast it is.

    Parameters
    ----------
    tables : sequence of Table
        By `speed_table`.
    """
    rows: list[tuple[Value, ...]] = []
    for table in tables:
        of = table.title.partition(": ")[2]
        by_method = {row["method"]: row for row in table.records}
        ritz = by_method[OUR_RITZ]
        accurate = [
            by_method[name] for name, _ in OUR_METHODS if _as_accurate(by_method[name], ritz)
        ]
        if not accurate:
            rows.append((of, *(None,) * 7, False))
            continue
        best = min(accurate, key=lambda row: float(row["seconds"]))
        paper, two = best["than_paper"], best["than_two"]
        errors = (best["nine_in_ten"], ritz["nine_in_ten"])
        fast = paper >= THAN_PAPER and two >= THAN_TWO
        solved = (best["method"], best["solved"])
        rows.append((of, *solved, *errors, 1e6 * best["seconds"], paper, two, fast))
    return Table(
        "bars_speed",
        "Speed",
        (
            Column("patches", "Patches", "text"),
            Column("method", "Our fastest as accurate as Ritz", "text", is_timing=True),
            Column("solved", "Solved", "count", is_timing=True),
            Column("error", "Error: 90 %", "small", is_timing=True),
            Column("ritz_error", "Ritz", "small"),
            Column("microseconds", "Microseconds a patch", "number", is_timing=True),
            Column("than_paper", "Times as fast as the paper", "factor", is_timing=True),
            Column("than_two", "as our two functions", "factor", is_timing=True),
            Column("met", "Reached", "text", is_timing=True),
        ),
        rows_of(rows),
        (
            f"It was to be {THAN_PAPER:,.0f} times as fast as the paper's Ritz, which took "
            f"{published.SECONDS_BY_RITZ} s on a computer of 2007, and {THAN_TWO:.0f} times as "
            "our own two functions with all solutions. As accurate: median error and that of 90 % "
            "of the patches no larger than our Ritz's. Time is of all patches; those that are not "
            "solved would be left to the search for paths along edges, which is slower by far and "
            "is not timed here.",
        ),
    )


def _as_accurate(row: dict[str, Any], ritz: dict[str, Any]) -> bool:
    """Whether a method errs no more than Ritz; what has no error known is not."""
    return all(
        row[name] is not None and ritz[name] is not None and row[name] <= ritz[name]
        for name in ("median", "nine_in_ten")
    )
