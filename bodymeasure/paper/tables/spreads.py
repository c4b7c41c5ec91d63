"""Tables for charts: how differences and numbers of solutions are distributed."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.paper.tables.statistics import known, signed_difference
from bodymeasure.paper.tables.table import Column, Table
from bodymeasure.paper.tables.tables_3_and_4 import ReadingResult

LEVELS = tuple(range(0, 101, 5))


class SpreadRow(NamedTuple):
    """Quantiles of the sizes of differences at `LEVELS`, None where no difference is known."""

    of: str
    difference: str
    known: int
    quantiles: Array | list[None]


def distribution_table(results: Sequence[ReadingResult]) -> Table:
    """Return quantiles of the sizes of differences, by reading."""
    rows = []
    for result in results:
        found = result.found
        for name, lengths, reference in (
            ("RBF inside against Ritz", found.inside_length, found.ritz_length),
            ("RBF inside against the truth", found.inside_length, found.true_length),
            ("RBF of all against the truth", found.all_length, found.true_length),
            ("Ritz against the truth", found.ritz_length, found.true_length),
        ):
            difference = signed_difference(lengths, reference)
            rows.append(spread_row(result.reading.name, name, difference))
    return spread_table("distribution", rows)


def spread_row(of: str, name: str, differences: Array) -> SpreadRow:
    """Return quantiles of the sizes of differences, those that are not known left out.

    Parameters
    ----------
    of : str
        The set of lengths.
    name : str
        Name of the difference.
    differences : ndarray, shape (k,)
    """
    size = np.abs(known(differences))
    figures = np.quantile(size, np.array(LEVELS) / 100.0) if len(size) else [None] * len(LEVELS)
    return SpreadRow(of, name, len(size), figures)


def spread_table(name: str, rows: Iterable[SpreadRow]) -> Table:
    """Return a table of rows by `spread_row`."""

    def quantile(number: int, level: int) -> Column:
        return Column(f"quantile_{level}", f"{level} %", "small", lambda row: row.quantiles[number])

    columns = (
        Column("of", "Of", "text"),
        Column("difference", "Difference", "text"),
        Column("count", "Lengths", "count", lambda row: row.known),
        *(quantile(number, level) for number, level in enumerate(LEVELS)),
    )
    note = "Quantiles of the relative difference without its sign."
    return Table.of(name, "How the differences are distributed", columns, rows, note)


def roots_table(results: Sequence[ReadingResult]) -> Table:
    """Return how many patches have how many real solutions at t = 1/2."""
    most = max(int(result.found.roots.max(initial=0)) for result in results)
    columns = [Column("solutions", "Solutions", "count", lambda number: number)]
    for start, label in (("real", "Patches"), ("inside", "Inside")):
        for i, result in enumerate(results):
            roots = result.found.roots if start == "real" else result.found.roots_inside
            count = np.bincount(roots, minlength=most + 1).item
            columns.append(
                Column(f"{start}_{i}", f"{label}, {result.reading.name}", "count", count)
            )
    return Table.of(
        "roots",
        "Real solutions of the system for two functions",
        columns,
        range(most + 1),
        "How many patches have so many real solutions, and so many inside the patch.",
    )
