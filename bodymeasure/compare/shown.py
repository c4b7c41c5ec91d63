"""Differences as people read them on the page and in the terminal."""

from bodymeasure.compare.records import Agreement, Difference
from bodymeasure.report.body.tape import small_text
from bodymeasure.report.numbers import MINUS, NONE, SPACE
from bodymeasure.report.units import DEGREES, TAPE_DECIMALS

# One decimal more than a tape shows, since differences are means of many readings.
EXTRA_DECIMALS = 1


def signed(value: float | None, unit: str) -> str:
    """Return a difference with its sign, one digit finer than a tape; a dash for None."""
    if value is None:
        return NONE
    text = f"{value:+.{TAPE_DECIMALS[unit] + EXTRA_DECIMALS}f}"
    if float(text) == 0.0:
        return text[1:]
    return text.replace("-", MINUS)


def error_text(difference: Difference) -> str:
    """Return the combined error of a difference with its unit; a dash for None."""
    error = difference.combined_error
    if difference.unit == DEGREES:
        return NONE if error is None else f"{error:.1g}°"
    return small_text(error, difference.unit)


def interval(agreement: Agreement) -> str:
    """Return the confidence interval of a mean difference; a dash for None."""
    if agreement.low is None or agreement.high is None:
        return NONE
    low, high = (signed(end, agreement.unit) for end in (agreement.low, agreement.high))
    return f"{low}{SPACE}to {high}"
