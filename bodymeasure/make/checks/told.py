"""What is said of a set of measurements before a body is sought: refusals and warnings."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.make.body.measuring import Readout
from bodymeasure.make.checks.contradictions import Contradiction, contradictions
from bodymeasure.make.checks.plausible import (
    DOUBTED,
    ODD,
    REFUSED,
    STANDS_OUT,
    Judgment,
    judged,
)
from bodymeasure.make.checks.slips import slip_of, unit_of_all
from bodymeasure.make.input.measurements import Value
from bodymeasure.report.units import DEGREES

# The least part of bodies that is stated: a smaller figure means nothing.
RAREST = 1e-9


class Told(NamedTuple):
    """What is said of a set of measurements.

    Parameters
    ----------
    refusal : str
        Why no body is sought; empty if nothing speaks against it.
    warnings : tuple of str
    judgment : Judgment
    """

    refusal: str
    warnings: tuple[str, ...]
    judgment: Judgment


def told(mean: Readout, values: tuple[Value, ...]) -> Told:
    """Judge a set of measurements.

    Parameters
    ----------
    mean : Readout
        The same measurements of the prior's mean body.
    values : tuple of Value
    """
    base = np.array([value.base for value in values])
    degrees = np.array([value.unit == DEGREES for value in values])
    judgment = judged(mean, base, degrees)
    apart = np.abs(judgment.apart(base))
    refused = judgment.probability < REFUSED or bool((apart > STANDS_OUT).any())
    by_key = {value.key: value for value in values}
    lengths = {value.key: value.base for value in values if value.unit != DEGREES}
    faults = [_contradiction(one, by_key, judgment, values) for one in contradictions(lengths)]
    # A set in another unit contradicts itself in nothing, but is far from all bodies.
    if refused and (unit := unit_of_all(mean, values, degrees)) is not None:
        own = next(value.unit for value in values if value.unit != DEGREES)
        words = (
            f"no body has these measurements in {own}, but they fit in {unit.value}: is the unit "
            f"{unit.value}?"
        )
        return Told(words, (), judgment)
    if faults:
        return Told("; ".join(faults), (), judgment)
    if refused:
        return Told(_refusal(judgment, values, base), (), judgment)
    return Told("", _warnings(judgment, values, apart), judgment)


def _contradiction(
    found: Contradiction, by_key: dict[str, Value], judgment: Judgment, values: tuple[Value, ...]
) -> str:
    smaller, larger = by_key[found.smaller], by_key[found.larger]
    words = (
        f"{found.smaller} is {smaller.written(smaller.base)} and {found.larger} only "
        f"{larger.written(larger.base)}, which no body has: {found.because}"
    )
    # The one that stands out more among the others is the likelier slip.
    rows = [row for row, value in enumerate(values) if value in (smaller, larger)]
    worst = max(rows, key=lambda row: judgment.gain[row])
    return f"{words}; {_meant(judgment, values[worst], worst)}"


def _refusal(judgment: Judgment, values: tuple[Value, ...], base: Array) -> str:
    row = judgment.worst
    value = values[row]
    its = value.written(float(base[row]))
    if judgment.probability < REFUSED:
        odds = max(judgment.probability, RAREST)
        rest = judgment.chi_square - float(judgment.gain[row])
        words = (
            f"no body is likely to have these {len(values)} measurements together (chi-square "
            f"{judgment.chi_square:.0f}, of which fewer than 1 in {_rounded(1.0 / odds)} bodies "
            f"have more); without {value.key} ({its}) it is {rest:.0f}"
        )
    else:
        words = f"{value.key} does not go with the other measurements: it is {its}"
    return f"{words}; {_meant(judgment, value, row)}"


def _meant(judgment: Judgment, value: Value, row: int) -> str:
    """Return what a value should be beside the others, and which slip would explain it."""
    low, high = judgment.range_of(row)
    words = (
        f"beside the others, {value.key} is plausible from {value.written(max(low, 0.0))} to "
        f"{value.written(high)}"
    )
    slip = slip_of(value, float(judgment.from_others[row]), float(judgment.beside[row]))
    if slip is not None:
        words += f"; {value.written(slip.value)} would do, which points to {slip.words}"
    return words


def _warnings(judgment: Judgment, values: tuple[Value, ...], apart: Array) -> tuple[str, ...]:
    words = []
    for row in np.argsort(-apart).tolist():
        if apart[row] > ODD:
            value = values[row]
            words.append(
                f"{value.key} ({value.written(value.base)}) is unusual: "
                f"{_meant(judgment, value, row)}"
            )
    if not words and judgment.probability < DOUBTED:
        row = judgment.worst
        words.append(
            f"these measurements are rare together: about 1 in "
            f"{_rounded(1.0 / judgment.probability)} bodies is as far from the mean; "
            f"{values[row].key} most of all: {_meant(judgment, values[row], row)}"
        )
    return tuple(words)


def _rounded(number: float) -> str:
    """Return a large number with one digit that counts."""
    power = 10.0 ** np.floor(np.log10(number))
    return f"{round(number / power) * power:,.0f}"
