"""Bland-Altman plots: the difference of two methods over their mean, for each subject."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from bodymeasure.compare.records import Agreement, Difference
from bodymeasure.report.ticks import ticks

# Size and margins in the drawing's own units, about pixels.
WIDTH, HEIGHT = 380.0, 240.0
LEFT, RIGHT, TOP, BOTTOM = 48.0, 12.0, 10.0, 34.0
# Room beyond the outermost points, as a part of the range.
ROOM = 0.06
# Subjects that are drawn of more: every so many-th, and those beyond the limits.
MOST = 1500


@dataclass(frozen=True)
class Line:
    """A line of a difference.

    Parameters
    ----------
    y : float
        Where it stands.
    value : float
    kind : str
        mean, limit, zero or allowed.
    words : str
    """

    y: float
    value: float
    kind: str
    words: str


@dataclass(frozen=True)
class Plot:
    """A Bland-Altman plot, ready to draw.

    Parameters
    ----------
    agreement : Agreement
    points : tuple of (float, float, str)
        Where each subject stands, and its name.
    bands : tuple of (float, float)
        Top and height of the confidence intervals of the mean and of both limits.
    lines : tuple of Line
    ticks, levels : tuple of (float, float)
        Where labels of the axes stand, and their values.
    """

    agreement: Agreement
    points: tuple[tuple[float, float, str], ...]
    bands: tuple[tuple[float, float], ...]
    lines: tuple[Line, ...]
    ticks: tuple[tuple[float, float], ...]
    levels: tuple[tuple[float, float], ...]
    width: float = WIDTH
    height: float = HEIGHT
    left: float = LEFT
    right: float = WIDTH - RIGHT
    top: float = TOP
    base: float = HEIGHT - BOTTOM

    @property
    def drawn(self) -> int:
        """How many subjects are drawn."""
        return len(self.points)


def plot_of(agreement: Agreement, differences: Sequence[Difference]) -> Plot | None:
    """Return the plot of one measurement; None for fewer than two subjects.

    Parameters
    ----------
    agreement : Agreement
    differences : sequence of Difference
        Those that it is of.
    """
    lower, upper = agreement.lower_limit, agreement.upper_limit
    half = agreement.limit_half_width
    if lower is None or upper is None or half is None:
        return None
    means = [0.5 * (each.a + each.b) for each in differences]
    values = [each.difference for each in differences]
    low, high = agreement.low or 0.0, agreement.high or 0.0
    x = _axis(min(means), max(means), LEFT, WIDTH - RIGHT)
    y = _axis(
        min(*values, lower - half, 0.0), max(*values, upper + half, 0.0), HEIGHT - BOTTOM, TOP
    )
    every = math.ceil(len(values) / MOST)
    shown = [
        place
        for place, value in enumerate(values)
        if place % every == 0 or not lower <= value <= upper
    ]
    lines = [
        Line(y(0.0), 0.0, "zero", "No difference"),
        Line(y(agreement.mean), agreement.mean, "mean", "Mean difference"),
        Line(y(lower), lower, "limit", "Lower limit of agreement"),
        Line(y(upper), upper, "limit", "Upper limit of agreement"),
    ]
    allowed = agreement.maximum_error
    if allowed is not None:
        lines += [
            Line(y(value), value, "allowed", "Allowed mean difference, ISO 20685-1")
            for value in (-allowed, allowed)
            if TOP <= y(value) <= HEIGHT - BOTTOM
        ]
    intervals = ((lower - half, lower + half), (low, high), (upper - half, upper + half))
    return Plot(
        agreement,
        tuple((x(means[place]), y(values[place]), differences[place].subject) for place in shown),
        tuple((y(end), round(y(begin) - y(end), 2)) for begin, end in intervals),
        tuple(lines),
        tuple((x(value), value) for value in ticks(x.low, x.high)),
        tuple((y(value), value) for value in ticks(y.low, y.high)),
    )


@dataclass(frozen=True)
class _Axis:
    """The places of values between two ends of the drawing."""

    low: float
    high: float
    begin: float
    end: float

    def __call__(self, value: float) -> float:
        part = (value - self.low) / (self.high - self.low)
        return round(self.begin + (self.end - self.begin) * part, 2)


def _axis(low: float, high: float, begin: float, end: float) -> _Axis:
    # Equal values stand in the middle.
    room = ROOM * (high - low) or max(abs(low), 1.0) * ROOM
    return _Axis(low - room, high + room, begin, end)
