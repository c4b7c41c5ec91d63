"""The histogram of differences: its counts, and the geometry of its drawing in the page."""

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from bodymeasure.report.patches.records import Document
from bodymeasure.report.ticks import round_step

# Two bars a decade are coarse enough to read, and fine enough to show the tail.
BINS_PER_DECADE = 2
# Differences below this are rounding errors; they share the first bar with exact zeros.
FLOOR = 1e-13
# Size and margins of the drawing in its own units, which are about pixels on a phone.
WIDTH, HEIGHT = 440.0, 230.0
LEFT, RIGHT, TOP, BOTTOM = 40.0, 24.0, 12.0, 44.0


@dataclass(frozen=True)
class Bar:
    """The numbers of values and of reference values from `low` up to `high`."""

    low: float
    high: float
    count: int
    reference: int


@dataclass(frozen=True)
class DrawnBar(Bar):
    """A bar with its rectangle in the drawing."""

    x: float
    y: float
    width: float
    height: float


@dataclass(frozen=True)
class HistogramDrawing:
    """A histogram of the sizes of relative differences, ready to draw.

    Parameters
    ----------
    bars : tuple of DrawnBar
    reference : str
        The outline of the reference's counts, as a path of SVG.
    decades, counts : tuple of (float, int)
        The labels of the axes: where each stands, and its power of ten or its count.
    """

    bars: tuple[DrawnBar, ...]
    reference: str
    decades: tuple[tuple[float, int], ...]
    counts: tuple[tuple[float, int], ...]
    width: float = WIDTH
    height: float = HEIGHT
    left: float = LEFT
    right: float = WIDTH - RIGHT
    base: float = HEIGHT - BOTTOM


def histogram(values: Sequence[float], *, reference: Sequence[float] = ()) -> list[Bar]:
    """Count the sizes of values in bins of equal width on a logarithmic axis.

    Parameters
    ----------
    values : sequence of float
        Their signs do not matter.
    reference : sequence of float
        Other values, which are counted in the same bins to compare.

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


def draw_histogram(document: Document) -> HistogramDrawing | None:
    """Return the histogram of a document's differences beside the mesh check's own uncertainty.

    It is None if nothing was compared.
    """
    compared = [m for m in document.measurements if m.relative_difference is not None]
    bars = histogram(
        [m.relative_difference for m in compared if m.relative_difference is not None],
        reference=[
            m.exact_uncertainty / m.exact
            for m in compared
            if m.exact and m.exact_uncertainty is not None
        ],
    )
    if not bars:
        return None
    most = max(max(bar.count, bar.reference) for bar in bars)
    step = _step(most)
    top = step * math.ceil(most / step)
    width = (WIDTH - LEFT - RIGHT) / len(bars)
    base = HEIGHT - BOTTOM

    def y(count: int) -> float:
        return round(base - (base - TOP) * count / top, 2)

    def x(number: int) -> float:
        return round(LEFT + width * number, 2)

    outline = [f"M{x(0)} {base}"]
    outline += [f"V{y(bar.reference)}H{x(number)}" for number, bar in enumerate(bars, start=1)]
    edges = [(x(number), math.log10(bar.low)) for number, bar in enumerate(bars)]
    edges.append((x(len(bars)), math.log10(bars[-1].high)))
    return HistogramDrawing(
        bars=tuple(
            DrawnBar(
                bar.low,
                bar.high,
                bar.count,
                bar.reference,
                x=x(number) + 1.0,
                y=y(bar.count),
                width=round(width - 2.0, 2),
                height=round(base - y(bar.count), 2),
            )
            for number, bar in enumerate(bars)
        ),
        reference="".join([*outline, f"V{base}"]),
        decades=tuple((at, round(power)) for at, power in edges if abs(power % 1.0) < 1e-6),
        counts=tuple((y(count), count) for count in range(0, top + 1, step)),
    )


def _step(largest: int) -> int:
    """Return the distance of grid lines, for about four lines."""
    return int(round_step(max(largest / 4.0, 1.0)))
