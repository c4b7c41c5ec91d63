"""Tables for charts: how differences and numbers of solutions are distributed."""

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from bodymeasure.paper.tables.table import Column, Table, Value, rows_of
from bodymeasure.paper.tables.tables_3_and_4 import ReadingResult, signed_difference

LEVELS = tuple(range(0, 101, 5))


def distribution_table(results: Sequence[ReadingResult]) -> Table:
    """Quantiles of the sizes of differences, by reading."""
    rows = []
    for result in results:
        found = result.found
        for name, lengths, reference in (
            ("RBF inside against Ritz", found.inside_length, found.ritz_length),
            ("RBF inside against the truth", found.inside_length, found.true_length),
            ("RBF of all against the truth", found.all_length, found.true_length),
            ("Ritz against the truth", found.ritz_length, found.true_length),
        ):
            rows.append(
                spread_row(result.reading.name, name, signed_difference(lengths, reference))
            )
    return spread_table("distribution", rows)


def spread_row(of: str, name: str, differences: NDArray[np.float64]) -> Sequence[Value]:
    """Quantiles of the sizes of differences, those that are not known left out.

    Parameters
    ----------
    of : str
        What set of lengths this is about.
    name : str
        Of the difference.
    differences : ndarray, shape (k,)
    """
    size = np.abs(differences[np.isfinite(differences)])
    figures = np.quantile(size, np.array(LEVELS) / 100.0) if len(size) else [None] * len(LEVELS)
    return (of, name, len(size), *figures)


def spread_table(name: str, rows: Iterable[Sequence[Value]]) -> Table:
    """A table of rows by `spread_row`."""
    return Table(
        name,
        "How the differences are distributed",
        (
            Column("of", "Of", "text"),
            Column("difference", "Difference", "text"),
            Column("count", "Lengths", "count"),
            *(Column(f"quantile_{level}", f"{level} %", "small") for level in LEVELS),
        ),
        rows_of(rows),
        ("Quantiles of the relative difference without its sign.",),
    )


def roots_table(results: Sequence[ReadingResult]) -> Table:
    """How many patches have how many real solutions at t = 1/2."""
    most = max(int(result.found.roots.max(initial=0)) for result in results)
    counts = [np.bincount(result.found.roots, minlength=most + 1) for result in results]
    inside = [np.bincount(result.found.roots_inside, minlength=most + 1) for result in results]
    rows = [
        (number, *(int(c[number]) for c in counts), *(int(c[number]) for c in inside))
        for number in range(most + 1)
    ]
    return Table(
        "roots",
        "Real solutions of the system for two functions",
        (
            Column("solutions", "Solutions", "count"),
            *(
                Column(f"real_{i}", f"Patches, {r.reading.name}", "count")
                for i, r in enumerate(results)
            ),
            *(
                Column(f"inside_{i}", f"Inside, {r.reading.name}", "count")
                for i, r in enumerate(results)
            ),
        ),
        rows_of(rows),
        ("How many patches have so many real solutions, and so many inside the patch.",),
    )
