"""Geometry of the histogram in the page."""

import math
from dataclasses import dataclass

from bodymeasure.report.patches.histogram import histogram
from bodymeasure.report.patches.records import Document

# User units of the drawing, about pixels on a phone.
WIDTH, HEIGHT = 440.0, 230.0
LEFT, RIGHT, TOP, BOTTOM = 40.0, 24.0, 12.0, 44.0


@dataclass(frozen=True)
class ChartBar:
    """A bar of the drawing, and what it says."""

    x: float
    y: float
    width: float
    height: float
    low: float
    high: float
    count: int
    reference: int


@dataclass(frozen=True)
class Chart:
    """Histogram of |relative differences|, ready to draw."""

    bars: tuple[ChartBar, ...]
    reference: str
    decades: tuple[tuple[float, int], ...]
    counts: tuple[tuple[float, int], ...]
    width: float = WIDTH
    height: float = HEIGHT
    left: float = LEFT
    right: float = WIDTH - RIGHT
    base: float = HEIGHT - BOTTOM


def chart(document: Document) -> Chart | None:
    """The histogram of a document's differences beside the mesh check's own uncertainty.

    None if nothing was compared.
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
    step = _step(max(max(bar.count, bar.reference) for bar in bars))
    top = step * math.ceil(max(max(bar.count, bar.reference) for bar in bars) / step)
    width = (WIDTH - LEFT - RIGHT) / len(bars)
    base = HEIGHT - BOTTOM

    def y(count: int) -> float:
        return round(base - (base - TOP) * count / top, 2)

    def x(number: int) -> float:
        return round(LEFT + width * number, 2)

    outline = [f"M{x(0)} {base}"]
    for number, bar in enumerate(bars):
        outline.append(f"V{y(bar.reference)}H{x(number + 1)}")
    edges = [(x(number), math.log10(bar.low)) for number, bar in enumerate(bars)]
    edges.append((x(len(bars)), math.log10(bars[-1].high)))
    return Chart(
        bars=tuple(
            ChartBar(
                x=x(number) + 1.0,
                y=y(bar.count),
                width=round(width - 2.0, 2),
                height=round(base - y(bar.count), 2),
                low=bar.low,
                high=bar.high,
                count=bar.count,
                reference=bar.reference,
            )
            for number, bar in enumerate(bars)
        ),
        reference="".join([*outline, f"V{base}"]),
        decades=tuple((at, round(power)) for at, power in edges if abs(power % 1.0) < 1e-6),
        counts=tuple((y(count), count) for count in range(0, top + 1, step)),
    )


def _step(largest: int) -> int:
    """Distance of grid lines: 1, 2 or 5 times a power of ten, for four lines or so."""
    rough = max(largest, 1) / 4.0
    power = 10 ** math.floor(math.log10(max(rough, 1.0)))
    return next(int(factor * power) for factor in (1, 2, 5, 10) if factor * power >= rough)
