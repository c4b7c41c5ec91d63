"""The drawing of a distribution: bars of a histogram, with three percentiles."""

import math
from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.report.ticks import ticks

# Size and margins in the drawing's own units, about pixels.
WIDTH, HEIGHT = 300.0, 130.0
LEFT, RIGHT, TOP, BOTTOM = 10.0, 10.0, 8.0, 24.0
FEWEST_BARS, MOST_BARS = 5, 40
MARKED = (5.0, 50.0, 95.0)


@dataclass(frozen=True)
class Bar:
    """A bar: its rectangle, the range that it counts, and the count."""

    x: float
    y: float
    width: float
    height: float
    low: float
    high: float
    count: int


@dataclass(frozen=True)
class Drawing:
    """A histogram.

    Parameters
    ----------
    bars : tuple of Bar
    ticks : tuple of (float, float)
        Where each label of the axis stands, and its value.
    marks : tuple of (float, float)
        Where each percentile stands, and how many percent it is.
    """

    bars: tuple[Bar, ...]
    ticks: tuple[tuple[float, float], ...]
    marks: tuple[tuple[float, float], ...]
    width: float = WIDTH
    height: float = HEIGHT
    base: float = HEIGHT - BOTTOM


def drawing(values: Array) -> Drawing | None:
    """Return the histogram of values, NaN where there is none; None if all are the same.

    The width of a bar follows Freedman and Diaconis, within limits.
    """
    known = values[np.isfinite(values)]
    if len(known) < 2 or not np.ptp(known) > 0.0:
        return None
    low, high = float(known.min()), float(known.max())
    quarter = float(np.subtract(*np.quantile(known, [0.75, 0.25])))
    width = 2.0 * quarter / len(known) ** (1.0 / 3.0) or high - low
    bars = min(max(math.ceil((high - low) / width), FEWEST_BARS), MOST_BARS)
    counts, edges = np.histogram(known, bins=bars, range=(low, high))
    base, most = HEIGHT - BOTTOM, int(counts.max())

    def x(value: float) -> float:
        return round(LEFT + (WIDTH - LEFT - RIGHT) * (value - low) / (high - low), 2)

    drawn = []
    for begin, end, count in zip(edges[:-1], edges[1:], counts, strict=True):
        tall = (base - TOP) * int(count) / most
        box = (x(begin) + 0.5, round(base - tall, 2), round(x(end) - x(begin) - 1.0, 2))
        drawn.append(Bar(*box, round(tall, 2), float(begin), float(end), int(count)))
    return Drawing(
        tuple(drawn),
        tuple((x(value), value) for value in ticks(low, high)),
        tuple((x(float(np.quantile(known, mark / 100.0))), mark) for mark in MARKED),
    )
