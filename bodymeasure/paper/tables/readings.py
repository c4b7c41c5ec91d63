"""Tables across all readings of the testing data: what happened, and which is the nearest."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

from bodymeasure._typing import Bools
from bodymeasure.paper.data import published
from bodymeasure.paper.data.comparison import Comparison
from bodymeasure.paper.tables.statistics import key, known, mean, median, signed_difference
from bodymeasure.paper.tables.table import Column, Table
from bodymeasure.paper.tables.tables_3_and_4 import RULES_IN_WORDS, ReadingResult, by_rule

# A length that is longer than the truth by this much, relative, is wrong in the sixth figure.
VISIBLE = 1e-5


def _moved(found: Comparison) -> Bools:
    """Return where another collocation point than the middle was taken."""
    point = found.collocation_point
    return np.asarray(np.isfinite(point) & (point != 0.5))


def _stopped_early(found: Comparison) -> Bools:
    error = np.abs(signed_difference(found.ritz_length, found.true_length))
    followed = ~found.turns_back & ~found.along_edge
    return np.asarray(found.ritz_stopped & followed & (error > VISIBLE))


# The counts of each reading, by their names in the table.
EVENTS: dict[str, Callable[[ReadingResult], float]] = {
    "patches": lambda r: len(r.found),
    "drawn and refused: folded": lambda r: r.data.folded,
    "drawn and refused: cut through themselves": lambda r: r.data.intersecting,
    "RBF: real solutions a patch, mean": lambda r: r.found.roots.mean(),
    "RBF: real solutions a patch, most": lambda r: r.found.roots.max(),
    "RBF: of these inside, mean": lambda r: r.found.roots_inside.mean(),
    "RBF: none inside at t = 1/2": lambda r: (r.found.roots_inside == 0).sum(),
    "RBF: collocation point moved": lambda r: _moved(r.found).sum(),
    "RBF: none inside at any point": lambda r: np.isnan(r.found.inside_length).sum(),
    "RBF: no solution at all": lambda r: np.isnan(r.found.all_length).sum(),
    "RBF: determinant zero": lambda r: (r.found.degenerate > 0).sum(),
    "Ritz: not under the bound": lambda r: (~r.found.ritz_stopped).sum(),
    "Ritz: stopped too early": lambda r: _stopped_early(r.found).sum(),
    "Ritz: path leaves the patch": lambda r: (~r.found.ritz_inside).sum(),
    "truth: turns back in u": lambda r: r.found.turns_back.sum(),
    "truth: runs along an edge": lambda r: r.found.along_edge.sum(),
    "truth: not known": lambda r: np.isnan(r.found.true_length).sum(),
}


def events_table(results: Sequence[ReadingResult]) -> Table:
    """Return everything that was counted, with a column for each reading."""

    def counted(result: ReadingResult) -> Callable[[str], Any]:
        return lambda event: EVENTS[event](result)

    return Table.of(
        "events",
        "What happened, by reading",
        (
            Column("what", "Count", "text", str),
            *(Column(key(r.reading.name), r.reading.name, "number", counted(r)) for r in results),
        ),
        EVENTS,
        "Ritz stopped too early: under the bound, and yet off by more than 1e-5 of the length, "
        "though the true path neither turns back nor touches an edge. Where the true path "
        "turns back in u or runs along an edge, u = t cannot follow it.",
    )


def _mean_loss(result: ReadingResult, rule: str) -> float | None:
    lengths, reference = by_rule(result.found, rule), result.found.ritz_length
    return mean(known(signed_difference(lengths, reference)))


def _off(result: ReadingResult) -> float | None:
    loss = _mean_loss(result, "inside")
    return None if loss is None else abs(loss - published.MEAN_LOSS)


def closest_table(results: Sequence[ReadingResult]) -> Table:
    """Return how near each reading comes to the published figures, the nearest first."""
    low, high = min(published.LENGTHS), max(published.LENGTHS)

    def in_range(result: ReadingResult) -> float:
        lengths = known(result.found.ritz_length)
        return float(((lengths >= low) & (lengths <= high)).mean())

    inside, every = (partial(_mean_loss, rule=rule) for rule in RULES_IN_WORDS)
    columns = (
        Column("reading", "Reading", "text", lambda r: r.reading.name),
        Column("description", "What it is", "text", lambda r: r.reading.description),
        Column("mean_loss_inside", "Mean loss, inside", "percent", inside),
        Column("mean_loss_all", "Mean loss, of all", "percent", every),
        Column("off", "Off the paper's mean", "share", _off),
        Column(
            "median_length",
            "Median length by Ritz",
            "length",
            lambda r: median(known(r.found.ritz_length)),
        ),
        Column("in_range", "Between the lengths of the paper's Table 3", "share", in_range),
    )
    return Table.of(
        "closest",
        "The readings of section 6.1, the nearest to the published figures first",
        columns,
        sorted(results, key=lambda r: (_off(r) is None, _off(r))),
        f"The mean of the paper's four sets is {100 * published.MEAN_LOSS:.2f} %; its four "
        f"lengths lie between {low} and {high}.",
    )
