"""Tables 3 and 4 in the paper's form, and the truth beside them, for one reading."""

import re
from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.paper.data import published
from bodymeasure.paper.data.comparison import Comparison
from bodymeasure.paper.data.random_patches import RandomPatches, Reading
from bodymeasure.paper.tables.table import Column, Table, Value, rows_of

# Rows of Table 3.
SAMPLES = 4
RULES_IN_WORDS = {
    "inside": "the shortest solution inside the patch",
    "all": "the shortest of all solutions",
}


@dataclass(frozen=True, eq=False)
class ReadingResult:
    """What was found on the testing data of one reading: groups in order, one after the other."""

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
    """Lengths by radial functions, of the rule ``inside`` or ``all``."""
    return found.inside_length if rule == "inside" else found.all_length


def signed_difference(lengths: Array, reference: Array) -> Array:
    """Equation (15) for each sample by itself: the relative difference with its sign.

    The sum in (15) has one term then. Summed up over samples, signs would be lost, and "mean
    accuracy loss" would not be a mean.
    """
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray((lengths - reference) / reference)


def table_3(result: ReadingResult) -> Table:
    """The first patches: lengths and seconds by both methods, and the truth."""
    found = result.found.take(slice(0, SAMPLES))
    rows = []
    for i in range(len(found)):
        paper: tuple[Value, ...] = (
            published.TABLE_3[i] if i < len(published.TABLE_3) else (None,) * 4
        )
        truth = found.true_length[i]
        rows.append(
            (
                i + 1,
                found.inside_length[i],
                found.rbf_seconds[i],
                found.ritz_length[i],
                found.ritz_seconds[i],
                truth,
                signed_difference(found.inside_length[i], truth),
                signed_difference(found.ritz_length[i], truth),
                *paper,
            )
        )
    return Table(
        f"table_3_{key(result.reading.name)}",
        f"Table 3, reading “{result.reading.name}”: sample data",
        (
            Column("sample", "Sample", "count"),
            Column("rbf_length", "RBF, normalized unit", "length"),
            Column("rbf_seconds", "RBF, seconds", "seconds", is_timing=True),
            Column("ritz_length", "Ritz, normalized unit", "length"),
            Column("ritz_seconds", "Ritz, seconds", "seconds", is_timing=True),
            Column("true_length", "Truth", "length"),
            Column("rbf_error", "RBF against the truth", "percent"),
            Column("ritz_error", "Ritz against the truth", "percent"),
            Column("published_rbf_length", "Paper: RBF", "length"),
            Column("published_rbf_seconds", "seconds", "seconds"),
            Column("published_ritz_length", "Paper: Ritz", "length"),
            Column("published_ritz_seconds", "seconds", "seconds"),
        ),
        rows_of(rows),
        (
            "The first patches of the first set; the paper does not say which patches its rows "
            "are, so that rows do not correspond.",
        ),
    )


def table_4(result: ReadingResult, rule: str) -> Table:
    """Accuracy loss (15) and time ratio (16) of each set, beside the paper's."""
    rows = []
    for number, (name, found) in enumerate(result.groups):
        loss = signed_difference(by_rule(found, rule), found.ritz_length)
        known = loss[np.isfinite(loss)]
        paper = (
            published.TABLE_4[number]
            if name != "all" and number < len(published.TABLE_4)
            else (None, None)
        )
        rows.append(
            (
                name,
                len(found),
                len(known),
                len(found) - len(known),
                mean_or_none(known),
                median_or_none(known),
                _signed_rms(known),
                mean_or_none(found.ritz_seconds / found.rbf_seconds),
                median_or_none(found.ritz_seconds / found.rbf_seconds),
                *paper,
            )
        )
    return Table(
        f"table_4_{key(result.reading.name)}_{rule}",
        f"Table 4, reading “{result.reading.name}”: {RULES_IN_WORDS[rule]}",
        (
            Column("set", "Set", "text"),
            Column("patches", "Patches", "count"),
            Column("compared", "Compared", "count"),
            Column("failed", "No RBF solution", "count"),
            Column("mean_loss", "Mean accuracy loss", "percent"),
            Column("median_loss", "Median", "percent"),
            Column("rms", "Root mean square", "percent"),
            Column("mean_time_ratio", "Mean time ratio", "share", is_timing=True),
            Column("median_time_ratio", "Median", "share", is_timing=True),
            Column("published_loss", "Paper: loss", "percent"),
            Column("published_time_ratio", "Paper: time", "share"),
        ),
        rows_of(rows),
        (
            "Accuracy loss: (g_C - g_R) / g_R of each patch, which is (15) with one term in its "
            "sum; root mean square: (15) with the sum divided by the number of patches. "
            "Time ratio: (16), t_R / t_C, of processor times for one patch by itself; t_C is that "
            "of the solution inside the patch, with all roots.",
        ),
    )


def truth_table(result: ReadingResult) -> Table:
    """Which of the methods erred: each against the converged solution."""
    found = result.found
    rows = []
    for name, lengths in (
        ("RBF, inside", found.inside_length),
        ("RBF, of all", found.all_length),
        ("Ritz", found.ritz_length),
    ):
        error = signed_difference(lengths, found.true_length)
        other = signed_difference(
            found.inside_length if name == "Ritz" else found.ritz_length, found.true_length
        )
        both = np.isfinite(error) & np.isfinite(other)
        error_known = error[np.isfinite(error)]
        rows.append(
            (
                name,
                len(error_known),
                len(found) - len(error_known),
                mean_or_none(error_known),
                median_or_none(error_known),
                median_or_none(np.abs(error_known)),
                error_known.min(initial=np.inf),
                error_known.max(initial=-np.inf),
                int((np.abs(error[both]) < np.abs(other[both])).sum()),
                int(both.sum()),
            )
        )
    return Table(
        f"truth_{key(result.reading.name)}",
        f"Against the truth, reading “{result.reading.name}”",
        (
            Column("method", "Method", "text"),
            Column("compared", "Compared", "count"),
            Column("not_compared", "Not", "count"),
            Column("mean", "Mean difference", "percent"),
            Column("median", "Median", "percent"),
            Column("median_size", "Median of its size", "small"),
            Column("least", "Least", "percent"),
            Column("largest", "Largest", "percent"),
            Column("nearer", "Nearer than the other", "count"),
            Column("of", "of", "count"),
        ),
        rows_of(rows),
        (
            "Truth: the shortest path inside the patch, searched thoroughly; where it has no "
            "length that can be trusted, or the method has none, nothing is compared. A negative "
            "difference is a path that leaves the patch. The other method is Ritz, for Ritz the "
            "solution inside.",
        ),
    )


def key(name: str) -> str:
    """A name for people as a part of names for programs."""
    return re.sub(r"\W+", "_", name).strip("_")


def mean_or_none(values: Array) -> float | None:
    """The mean, None of nothing."""
    return float(values.mean()) if len(values) else None


def median_or_none(values: Array) -> float | None:
    """The median, None of nothing."""
    return float(np.median(values)) if len(values) else None


def _signed_rms(values: Array) -> float | None:
    if len(values) == 0:
        return None
    return float(np.sign(values.mean()) * np.sqrt(np.mean(values**2)))
