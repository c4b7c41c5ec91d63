"""Lengths as a tape shows them: to the millimeter, or in inches and fractions of an inch."""

from math import floor

from bodymeasure.atlas import Unit, convert_length
from bodymeasure.report.numbers import MINUS, NONE, SPACE, millimeters
from bodymeasure.report.units import DEGREES, TAPE_DECIMALS

# Marks between two inches on a tape.
SIXTEENTHS = 16

# A length in inches below this is far smaller than what matters to any garment or scan.
SMALLEST_INCHES = 0.0001


def tape_text(value: float | None, unit: str, error: float | None = None) -> str:
    """Return a value without its unit, with the digits that a tape shows and that are certain.

    Parameters
    ----------
    value : float or None
        A dash stands for None.
    unit : str
        m, cm, mm, inch or deg.
    error : float, optional
        Error of `value`; digits are left out while it exceeds half a unit of the last one.
    """
    if value is None:
        return NONE
    decimals = TAPE_DECIMALS[unit]
    while decimals > 0 and error is not None and error > 0.5 * 10.0**-decimals:
        decimals -= 1
    text = f"{value:.{decimals}f}"
    # Zero has no minus sign.
    return text.removeprefix("-") if float(text) == 0.0 else text.replace("-", MINUS)


def small_text(length: float | None, unit: str) -> str:
    """Return the size of a small length with its unit: inches if `unit` is, else millimeters."""
    if unit != "inch" or length is None:
        return millimeters(length, unit)
    if abs(length) < SMALLEST_INCHES:
        return f"<{SPACE}{SMALLEST_INCHES}{SPACE}in"
    return f"{abs(length):.{4 if abs(length) < 0.1 else 2}f}{SPACE}in"


def tailor_inches(value: float | None, error: float | None = None) -> str:
    """Return a length in inches as tailors write it, to the nearest sixteenth: ``33 1/8``.

    Parameters
    ----------
    value : float or None
        Length in inches; a dash stands for None.
    error : float, optional
        Error of `value` in inches; if it is large, eighths, quarters or halves are given.
    """
    if value is None:
        return NONE
    marks = SIXTEENTHS
    while marks > 1 and error is not None and error > 0.5 / marks:
        marks //= 2
    # Halves are rounded away from zero, as on a tape that is read from either end.
    total = floor(abs(value) * marks + 0.5)
    whole, rest = divmod(total, marks)
    while rest and rest % 2 == 0:
        rest, marks = rest // 2, marks // 2
    words = [str(whole)] if whole or not rest else []
    words += [f"{rest}/{marks}"] if rest else []
    return (MINUS if value < 0 and total else "") + SPACE.join(words)


def change_text(unit: str, size: float) -> str:
    """Return the size of a change as a tape shows it."""
    if unit == DEGREES:
        return f"{size:.1f}°"
    if unit == "inch":
        return f"{size:.2f}{SPACE}in"
    millimeters = convert_length(size, Unit.parse(unit), Unit.MM)
    return f"{millimeters:.1f}{SPACE}mm"
