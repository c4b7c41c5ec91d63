"""Tables across all readings of the testing data: what happened, and which is the nearest."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure.paper.data import published
from bodymeasure.paper.data.comparison import Comparison
from bodymeasure.paper.tables.table import Column, Table, rows_of
from bodymeasure.paper.tables.tables_3_and_4 import (
    RULES_IN_WORDS,
    ReadingResult,
    by_rule,
    key,
    mean_or_none,
    median_or_none,
    signed_difference,
)

# A length this much longer than the truth, relative, is wrong in the sixth figure or before.
VISIBLE = 1e-5


def events_table(results: Sequence[ReadingResult]) -> Table:
    """Everything that was counted, a reading a column."""
    rows: list[tuple[Any, ...]] = []

    def count(name: str, values: Sequence[Any]) -> None:
        rows.append((name, *values))

    found = [result.found for result in results]
    count("patches", [len(f) for f in found])
    count("drawn and refused: folded", [r.data.folded for r in results])
    count("drawn and refused: cut through themselves", [r.data.intersecting for r in results])
    count("RBF: real solutions a patch, mean", [float(f.roots.mean()) for f in found])
    count("RBF: real solutions a patch, most", [int(f.roots.max()) for f in found])
    count("RBF: of these inside, mean", [float(f.roots_inside.mean()) for f in found])
    count("RBF: none inside at t = 1/2", [int((f.roots_inside == 0).sum()) for f in found])
    count(
        "RBF: collocation point moved",
        [
            int((np.isfinite(f.collocation_point) & (f.collocation_point != 0.5)).sum())
            for f in found
        ],
    )
    count("RBF: none inside at any point", [int(np.isnan(f.inside_length).sum()) for f in found])
    count("RBF: no solution at all", [int(np.isnan(f.all_length).sum()) for f in found])
    count("RBF: determinant zero", [int((f.degenerate > 0).sum()) for f in found])
    count("Ritz: not under the bound", [int((~f.ritz_stopped).sum()) for f in found])
    count("Ritz: stopped too early", [int(_stopped_early(f).sum()) for f in found])
    count("Ritz: path leaves the patch", [int((~f.ritz_inside).sum()) for f in found])
    count("truth: turns back in u", [int(f.turns_back.sum()) for f in found])
    count("truth: runs along an edge", [int(f.along_edge.sum()) for f in found])
    count("truth: not known", [int(np.isnan(f.true_length).sum()) for f in found])
    return Table(
        "events",
        "What happened, by reading",
        (
            Column("what", "Count", "text"),
            *(Column(key(r.reading.name), r.reading.name, "number") for r in results),
        ),
        rows_of(rows),
        (
            "Ritz stopped too early: under the bound, and yet off by more than 1e-5 of the length, "
            "though the true path neither turns back nor touches an edge. Where the true path "
            "turns back in u or runs along an edge, u = t cannot follow it.",
        ),
    )


def _stopped_early(found: Comparison) -> NDArray[np.bool_]:
    error = np.abs(signed_difference(found.ritz_length, found.true_length))
    return np.asarray(
        found.ritz_stopped & ~found.turns_back & ~found.along_edge & (error > VISIBLE)
    )


def closest_table(results: Sequence[ReadingResult]) -> Table:
    """How near each reading comes to the published figures."""
    low, high = min(published.LENGTHS), max(published.LENGTHS)
    rows = []
    for result in results:
        found = result.found
        losses = {
            rule: signed_difference(by_rule(found, rule), found.ritz_length)
            for rule in RULES_IN_WORDS
        }
        means = {rule: mean_or_none(loss[np.isfinite(loss)]) for rule, loss in losses.items()}
        lengths = found.ritz_length[np.isfinite(found.ritz_length)]
        rows.append(
            (
                result.reading.name,
                result.reading.description,
                means["inside"],
                means["all"],
                None if means["inside"] is None else abs(means["inside"] - published.MEAN_LOSS),
                median_or_none(lengths),
                float(((lengths >= low) & (lengths <= high)).mean()),
            )
        )
    rows.sort(key=lambda row: (row[4] is None, row[4]))
    return Table(
        "closest",
        "The readings of section 6.1, the nearest to the published figures first",
        (
            Column("reading", "Reading", "text"),
            Column("description", "What it is", "text"),
            Column("mean_loss_inside", "Mean loss, inside", "percent"),
            Column("mean_loss_all", "Mean loss, of all", "percent"),
            Column("off", "Off the paper's mean", "share"),
            Column("median_length", "Median length by Ritz", "length"),
            Column("in_range", "Between the lengths of the paper's Table 3", "share"),
        ),
        rows_of(rows),
        (
            f"The mean of the paper's four sets is {100 * published.MEAN_LOSS:.2f} %; its four "
            f"lengths lie between {low} and {high}.",
        ),
    )
