"""The aims of the reproduction, and whether it reached them: what missed is shown, too."""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from bodymeasure.paper.data import published
from bodymeasure.paper.tables.speed import OUR_METHODS, OUR_RITZ
from bodymeasure.paper.tables.statistics import known, mean, signed_difference
from bodymeasure.paper.tables.table import Column, Table
from bodymeasure.paper.tables.tables_3_and_4 import ReadingResult

# "Of the same order": up to three times the published mean, or down to a third of it; a set's mean
# of heavy-tailed losses is no better known than that.
ORDER = 3.0
# Mean size of the diagonals' errors in Table 5; the paper's four are off by 0.28 to 1.06 %.
TABLE_5_ERROR = 0.002
# Times as fast: as the paper's Ritz in 2007, and as our own two functions with all solutions.
THAN_PAPER, THAN_TWO = 1000.0, 50.0


class _Accuracy(NamedTuple):
    """A mean that was found, and the bounds between which it was to be."""

    what: str
    found: float | None
    least: float | None
    most: float

    @property
    def met(self) -> bool | None:
        """Whether the aim is reached; None where no patch has a value."""
        return None if self.found is None else (self.least or 0.0) <= self.found <= self.most


def accuracy_bars(chosen: ReadingResult, table_5_error: float) -> Table:
    """Return the means of Table 4's sets, and of Table 5, against what they were to be.

    Parameters
    ----------
    chosen : ReadingResult
        The reading by which Table 4 is assessed.
    table_5_error : float
        Mean size of the relative errors of all diagonals in Table 5.
    """
    low, high = published.MEAN_LOSS / ORDER, published.MEAN_LOSS * ORDER
    rows = [
        _Accuracy(
            f"Table 4, set {name}: mean accuracy loss",
            mean(known(signed_difference(found.inside_length, found.ritz_length))),
            low,
            high,
        )
        for name, found in chosen.groups[:-1]
    ]
    what = "Table 5: mean size of the diagonals' errors"
    rows.append(_Accuracy(what, table_5_error, None, TABLE_5_ERROR))
    return Table.of(
        "bars_accuracy",
        "Accuracy",
        (
            Column("what", "What", "text"),
            Column("found", "Found", "fine"),
            Column("least", "At least", "fine"),
            Column("most", "At most", "fine"),
            Column("met", "Reached", "text"),
        ),
        rows,
        f"Table 4 is taken from the reading “{chosen.reading.name}” with the solution inside the "
        "patch; its means should be of the order of the paper's.",
    )


class _Best(NamedTuple):
    """The records of the best method and of Ritz in the table of speed of one set."""

    patches: str
    best: dict[str, Any]
    ritz: dict[str, Any]

    @property
    def met(self) -> bool | None:
        """Whether the aim is reached; None where Ritz's own errors are not known."""
        if self.ritz["nine_in_ten"] is None:
            return None
        best = self.best
        return bool(best) and best["than_paper"] >= THAN_PAPER and best["than_two"] >= THAN_TWO


def speed_bars(tables: Sequence[Table]) -> Table:
    """Return, for each set, the fastest of our methods that is as accurate as Ritz.

    Parameters
    ----------
    tables : sequence of Table
        The results of `speed_table`.
    """
    rows = []
    for table in tables:
        by_method = {row["method"]: row for row in table.records}
        ritz = by_method[OUR_RITZ]
        accurate = [row for name, _ in OUR_METHODS if _as_accurate(row := by_method[name], ritz)]
        best = min(accurate, key=lambda row: float(row["seconds"]), default={})
        rows.append(_Best(table.title.partition(": ")[2], best, ritz))
    columns = (
        Column("patches", "Patches", "text"),
        Column("method", "Our fastest as accurate as Ritz", "text", _best("method"), True),
        Column("solved", "Solved", "count", _best("solved"), True),
        Column("error", "Error: 90 %", "small", _best("nine_in_ten"), True),
        Column("ritz_error", "Ritz", "small", lambda row: row.ritz["nine_in_ten"]),
        Column("microseconds", "Microseconds a patch", "number", _best("seconds", 1e6), True),
        Column("than_paper", "Times as fast as the paper", "factor", _best("than_paper"), True),
        Column("than_two", "as our two functions", "factor", _best("than_two"), True),
        Column("met", "Reached", "text", is_timing=True),
    )
    return Table.of(
        "bars_speed",
        "Speed",
        columns,
        rows,
        f"The aim was to be {THAN_PAPER:,.0f} times as fast as the paper's Ritz, which took "
        f"{published.SECONDS_BY_RITZ} s on a computer of 2007, and {THAN_TWO:.0f} times as fast "
        "as our own two functions with all solutions. A method is as accurate as Ritz if its "
        "median error and its error on 90 % of the patches are no larger than those of our Ritz. "
        "The time is that of all patches; those that are not solved would be left to the search "
        "for paths along edges, which is slower by far and is not timed here.",
    )


def _best(name: str, factor: float | None = None) -> Callable[[_Best], Any]:
    """Return what gives a value of the best method, if there is one."""

    def value(row: _Best) -> Any:
        found = row.best.get(name)
        return found if found is None or factor is None else factor * found

    return value


def _as_accurate(row: dict[str, Any], ritz: dict[str, Any]) -> bool:
    """Return whether a method errs no more than Ritz; one whose errors are unknown does not."""
    return all(
        row[name] is not None and ritz[name] is not None and row[name] <= ritz[name]
        for name in ("median", "nine_in_ten")
    )
