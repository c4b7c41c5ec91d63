"""Histogram of differences, as the numbers that the page's template draws."""

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

# Two bars a decade: coarse enough to read, fine enough to see the tail.
BINS_PER_DECADE = 2
# Differences below this are rounding; they share the first bar, as exact zeros do.
FLOOR = 1e-13


@dataclass(frozen=True)
class Bar:
    """One bar: how many values, and how many of the reference, lie from `low` up to `high`."""

    low: float
    high: float
    count: int
    reference: int


def histogram(values: Sequence[float], *, reference: Sequence[float] = ()) -> list[Bar]:
    """Count sizes of values in bins of equal width on a logarithmic axis.

    Parameters
    ----------
    values : sequence of float
        Their signs do not matter.
    reference : sequence of float
        Other values, counted in the same bins to compare.

    Returns
    -------
    list of Bar
        From the smallest to the largest without gaps; empty without values.
    """
    counts = Counter(_bin(value) for value in values)
    references = Counter(_bin(value) for value in reference)
    bins = counts.keys() | references.keys()
    if not bins:
        return []
    return [
        Bar(_edge(number), _edge(number + 1), counts[number], references[number])
        for number in range(min(bins), max(bins) + 1)
    ]


def _bin(value: float) -> int:
    return math.floor(math.log10(max(abs(value), FLOOR)) * BINS_PER_DECADE)


def _edge(number: int) -> float:
    return float(10.0 ** (number / BINS_PER_DECADE))
