"""Tables across all readings of the testing data: what happened, and which is the nearest."""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from bodymeasure._typing import Bools
from bodymeasure.paper.data import published
from bodymeasure.paper.data.comparison import Comparison
from bodymeasure.paper.data.random_patches import Reading
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


# What is counted for each reading, by its name in the table.
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


class _Nearness(NamedTuple):
    """How near a reading comes to the published figures."""

    reading: Reading
    inside: float | None
    every: float | None
    off: float | None
    median_length: float | None
    in_range: float


def _nearness(result: ReadingResult) -> _Nearness:
    found, (low, high) = result.found, (min(published.LENGTHS), max(published.LENGTHS))
    inside, every = (
        mean(known(signed_difference(by_rule(found, rule), found.ritz_length)))
        for rule in RULES_IN_WORDS
    )
    lengths = known(found.ritz_length)
    off = None if inside is None else abs(inside - published.MEAN_LOSS)
    in_range = float(((lengths >= low) & (lengths <= high)).mean())
    return _Nearness(result.reading, inside, every, off, median(lengths), in_range)


def closest_table(results: Sequence[ReadingResult]) -> Table:
    """Return how near each reading comes to the published figures, the nearest first."""
    rows = [_nearness(result) for result in results]
    return Table.of(
        "closest",
        "The readings of section 6.1, the nearest to the published figures first",
        (
            Column("reading", "Reading", "text", lambda r: r.reading.name),
            Column("description", "What it is", "text", lambda r: r.reading.description),
            Column("mean_loss_inside", "Mean loss, inside", "percent", lambda r: r.inside),
            Column("mean_loss_all", "Mean loss, of all", "percent", lambda r: r.every),
            Column("off", "Off the paper's mean", "share", lambda r: r.off),
            Column("median_length", "Median length by Ritz", "length", lambda r: r.median_length),
            Column(
                "in_range",
                "Between the lengths of the paper's Table 3",
                "share",
                lambda r: r.in_range,
            ),
        ),
        sorted(rows, key=lambda r: (r.off is None, r.off)),
        f"The mean of the paper's four sets is {100 * published.MEAN_LOSS:.2f} %; its four "
        f"lengths lie between {min(published.LENGTHS)} and {max(published.LENGTHS)}.",
    )
