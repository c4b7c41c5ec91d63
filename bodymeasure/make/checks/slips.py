"""Slips of those who write measurements down: other units, swapped digits, a shifted point."""

import re
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Unit
from bodymeasure.make.body.measuring import Readout
from bodymeasure.make.checks.plausible import judged
from bodymeasure.make.input.measurements import Value
from bodymeasure.report.units import DEGREES

# A value is mended by a slip if it is so near to what is expected then, in standard deviations.
MENDED = 2.5
# A whole set is in another unit if its probability then is not smaller than this.
FITS = 1e-3
# Factors by which a point is shifted, or which a half-girth lacks, in words.
FACTORS = (
    (10.0, "a decimal point one place to the left"),
    (0.1, "a decimal point one place to the right"),
    (100.0, "a decimal point two places to the left"),
    (0.01, "a decimal point two places to the right"),
    (2.0, "half of the tape, as of a tape laid double"),
    (0.5, "twice the tape"),
)


class Slip(NamedTuple):
    """A likely slip.

    Parameters
    ----------
    words : str
        What it is.
    value : float
        The value that was meant, in meters or degrees.
    apart : float
        How far that is from what is expected, in standard deviations.
    """

    words: str
    value: float
    apart: float


def unit_of_all(mean: Readout, values: tuple[Value, ...], degrees: Array) -> Unit | None:
    """Return the unit in which a whole set fits, if it does not fit in its own; else None."""
    units = {value.unit for value in values} - {DEGREES}
    if len(units) != 1:
        return None
    own = Unit.parse(next(iter(units)))
    base = np.array([value.base for value in values])
    best: tuple[float, Unit] | None = None
    for unit in Unit:
        factor = np.where(degrees, 1.0, unit.meters / own.meters)
        fits = judged(mean, base * factor, degrees).probability
        if unit is not own and fits > FITS and (best is None or fits > best[0]):
            best = fits, unit
    return None if best is None else best[1]


def slip_of(value: Value, expected: float, spread: float) -> Slip | None:
    """Return the slip by which a value that stands out is explained best, if there is one.

    Parameters
    ----------
    value : Value
    expected, spread : float
        What is expected of it, in meters or degrees, and the standard deviation.
    """
    found = [Slip(words, meant, abs(meant - expected) / spread) for words, meant in _meant(value)]
    found = [slip for slip in found if slip.apart <= MENDED]
    return min(found, key=lambda slip: slip.apart, default=None)


def _meant(value: Value) -> list[tuple[str, float]]:
    meant = [(words, value.base * factor) for factor, words in FACTORS]
    if value.unit != DEGREES:
        own = Unit.parse(value.unit)
        # Other units are shifted points.
        meant += [
            (f"a value in {unit.value}", value.value * unit.meters)
            for unit in Unit
            if unit is not own and Unit.INCH in (unit, own)
        ]
    written = f"{value.value:g}"
    meant += [
        (f"swapped digits: {text} written as {written}", value.base * float(text) / value.value)
        for text in _swapped(written)
    ]
    return meant


def _swapped(text: str) -> list[str]:
    """Return the numbers of which two digits that follow each other are swapped in a text."""
    digits = [match.start() for match in re.finditer(r"\d", text)]
    found = []
    for one, other in pairwise(digits):
        if text[one] != text[other]:
            swapped = list(text)
            swapped[one], swapped[other] = text[other], text[one]
            found.append("".join(swapped))
    return [each for each in found if float(each) > 0.0 and not each.startswith("0")]
