"""Tables 3 and 4 in the paper's form, and the truth beside them, for one reading."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.paper.data import published
from bodymeasure.paper.data.comparison import Comparison
from bodymeasure.paper.data.random_patches import RandomPatches, Reading
from bodymeasure.paper.tables.statistics import (
    key,
    known,
    mean,
    median,
    signed_difference,
    signed_rms,
)
from bodymeasure.paper.tables.table import Column, Table

RULES_IN_WORDS = {
    "inside": "the shortest solution inside the patch",
    "all": "the shortest of all solutions",
}


@dataclass(frozen=True, eq=False)
class ReadingResult:
    """The results on the testing data of one reading: all groups, one after the other."""

    reading: Reading
    data: RandomPatches
    found: Comparison

    @property
    def groups(self) -> tuple[tuple[str, Comparison], ...]:
        """Each set by its number, and all together."""
        count, size = self.data.control_points.shape[:2]
        sets = [
            (str(g + 1), self.found.take(slice(g * size, (g + 1) * size))) for g in range(count)
        ]
        return (*sets, ("all", self.found))


def by_rule(found: Comparison, rule: str) -> Array:
    """Return the lengths by radial functions for the rule ``inside`` or ``all``."""
    return found.inside_length if rule == "inside" else found.all_length


def table_3(result: ReadingResult) -> Table:
    """Return the first patches: lengths and seconds by both methods, and the truth."""
    found = result.found.take(slice(len(published.TABLE_3)))
    rbf_error, ritz_error = (
        signed_difference(lengths, found.true_length)
        for lengths in (found.inside_length, found.ritz_length)
    )

    def printed(column: int) -> Callable[[int], float]:
        return lambda i: published.TABLE_3[i][column]

    return Table.of(
        f"table_3_{key(result.reading.name)}",
        f"Table 3, reading “{result.reading.name}”: sample data",
        (
            Column("sample", "Sample", "count", lambda i: i + 1),
            Column("rbf_length", "RBF, normalized unit", "length", found.inside_length.item),
            Column("rbf_seconds", "RBF, seconds", "seconds", found.rbf_seconds.item, True),
            Column("ritz_length", "Ritz, normalized unit", "length", found.ritz_length.item),
            Column("ritz_seconds", "Ritz, seconds", "seconds", found.ritz_seconds.item, True),
            Column("true_length", "Truth", "length", found.true_length.item),
            Column("rbf_error", "RBF against the truth", "percent", rbf_error.item),
            Column("ritz_error", "Ritz against the truth", "percent", ritz_error.item),
            Column("published_rbf_length", "Paper: RBF", "length", printed(0)),
            Column("published_rbf_seconds", "seconds", "seconds", printed(1)),
            Column("published_ritz_length", "Paper: Ritz", "length", printed(2)),
            Column("published_ritz_seconds", "seconds", "seconds", printed(3)),
        ),
        range(len(found)),
        "The first patches of the first set; the paper does not say which patches its rows "
        "are, so that rows do not correspond.",
    )


class _Set(NamedTuple):
    """A set of patches in Table 4: accuracy losses that are known, time ratios, printed figures."""

    set: str
    patches: int
    loss: Array
    ratio: Array
    printed: tuple[float | None, float | None]


def table_4(result: ReadingResult, rule: str) -> Table:
    """Return accuracy loss (15) and time ratio (16) of each set, beside the paper's."""
    printed = {str(number): row for number, row in enumerate(published.TABLE_4, start=1)}
    rows = [
        _Set(
            name,
            len(found),
            known(signed_difference(by_rule(found, rule), found.ritz_length)),
            found.ritz_seconds / found.rbf_seconds,
            printed.get(name, (None, None)),
        )
        for name, found in result.groups
    ]
    return Table.of(
        f"table_4_{key(result.reading.name)}_{rule}",
        f"Table 4, reading “{result.reading.name}”: {RULES_IN_WORDS[rule]}",
        (
            Column("set", "Set", "text"),
            Column("patches", "Patches", "count"),
            Column("compared", "Compared", "count", lambda r: len(r.loss)),
            Column("failed", "No RBF solution", "count", lambda r: r.patches - len(r.loss)),
            Column("mean_loss", "Mean accuracy loss", "percent", lambda r: mean(r.loss)),
            Column("median_loss", "Median", "percent", lambda r: median(r.loss)),
            Column("rms", "Root mean square", "percent", lambda r: signed_rms(r.loss)),
            Column("mean_time_ratio", "Mean time ratio", "share", lambda r: mean(r.ratio), True),
            Column("median_time_ratio", "Median", "share", lambda r: median(r.ratio), True),
            Column("published_loss", "Paper: loss", "percent", lambda r: r.printed[0]),
            Column("published_time_ratio", "Paper: time", "share", lambda r: r.printed[1]),
        ),
        rows,
        "Accuracy loss: (g_C - g_R) / g_R of each patch, which is (15) with one term in its "
        "sum; root mean square: (15) with the sum divided by the number of patches. "
        "Time ratio: (16), t_R / t_C, of processor times for one patch by itself; t_C is that "
        "of the solution inside the patch, with all roots.",
    )


class _Errors(NamedTuple):
    """The errors of a method that are known, and how often it is nearer to the truth."""

    method: str
    errors: Array
    nearer: int
    both: int


def _errors(method: str, error: Array, other: Array) -> _Errors:
    both = np.isfinite(error) & np.isfinite(other)
    nearer = int((np.abs(error[both]) < np.abs(other[both])).sum())
    return _Errors(method, known(error), nearer, int(both.sum()))


def truth_table(result: ReadingResult) -> Table:
    """Return the errors of each method against the converged solution."""
    found = result.found
    inside, every, ritz = (
        signed_difference(lengths, found.true_length)
        for lengths in (found.inside_length, found.all_length, found.ritz_length)
    )
    return Table.of(
        f"truth_{key(result.reading.name)}",
        f"Against the truth, reading “{result.reading.name}”",
        (
            Column("method", "Method", "text"),
            Column("compared", "Compared", "count", lambda row: len(row.errors)),
            Column("not_compared", "Not", "count", lambda row: len(found) - len(row.errors)),
            Column("mean", "Mean difference", "percent", lambda row: mean(row.errors)),
            Column("median", "Median", "percent", lambda row: median(row.errors)),
            Column(
                "median_size", "Median of its size", "small", lambda row: median(np.abs(row.errors))
            ),
            Column("least", "Least", "percent", lambda row: row.errors.min(initial=np.inf)),
            Column("largest", "Largest", "percent", lambda row: row.errors.max(initial=-np.inf)),
            Column("nearer", "Nearer than the other", "count"),
            Column("of", "of", "count", lambda row: row.both),
        ),
        (
            _errors("RBF, inside", inside, ritz),
            _errors("RBF, of all", every, ritz),
            _errors("Ritz", ritz, inside),
        ),
        "Truth: the shortest path inside the patch, searched thoroughly; where it has no "
        "length that can be trusted, or the method has none, nothing is compared. A negative "
        "difference is a path that leaves the patch. The other method is Ritz, for Ritz the "
        "solution inside.",
    )
