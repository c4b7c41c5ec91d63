"""Numbers as people read them: rounded sensibly, errors in scientific notation."""

import re
from typing import TYPE_CHECKING

from bodymeasure.atlas import Unit, convert_length
from bodymeasure.report.units import LENGTH_DECIMALS

if TYPE_CHECKING:
    from markupsafe import Markup

# A tenth of a micrometer is far smaller than what matters to any garment or scan.
SMALLEST_MILLIMETERS = 0.0001

NONE = "\N{EN DASH}"
SPACE = "\N{NO-BREAK SPACE}"
MINUS = "\N{MINUS SIGN}"
_TIMES = "\N{MULTIPLICATION SIGN}"
_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def length_text(length: float | None, unit: Unit | str) -> str:
    """Return a length without its unit, to a tenth of a millimeter or so; a dash for None."""
    return NONE if length is None else f"{length:.{LENGTH_DECIMALS[Unit.parse(unit)]}f}"


def fixed(value: float, decimals: int) -> str:
    """Return a number with so many decimals; never minus zero."""
    return f"{round(value, decimals) + 0.0:.{decimals}f}"


def scientific(value: float | None, *, signed: bool = False) -> str:
    """Return a small number as a mantissa and a power of ten; a dash for None."""
    if value is None:
        return NONE
    if value == 0.0:
        return "0"
    mantissa, exponent = f"{abs(value):.1e}".split("e")
    sign = MINUS if value < 0 else "+" if signed else ""
    return f"{sign}{mantissa}{SPACE}{_TIMES}{SPACE}10{str(int(exponent)).translate(_SUPERSCRIPT)}"


def percent(value: float | None, decimals: int = 2) -> str:
    """Return a signed ratio in percent; a dash for None."""
    if value is None:
        return NONE
    text = f"{100.0 * value:+.{decimals}f}"
    # No sign before a zero.
    text = text[1:] if float(text) == 0.0 else text.replace("-", MINUS)
    return f"{text}{SPACE}%"


def millimeters(length: float | None, unit: Unit | str) -> str:
    """Return the size of a small length in millimeters with its unit; a dash for None."""
    if length is None:
        return NONE
    value = abs(convert_length(length, Unit.parse(unit), Unit.MM))
    if value < SMALLEST_MILLIMETERS:
        return f"<{SPACE}{SMALLEST_MILLIMETERS}{SPACE}mm"
    decimals = 4 if value < 0.01 else 3 if value < 1.0 else 1
    return f"{value:.{decimals}f}{SPACE}mm"


def at_most(length: float | None, unit: Unit | str) -> str:
    """Return a bound in words: ``at most 0.012 mm`` or ``less than 0.0001 mm``."""
    return as_bound(millimeters(length, unit))


def as_bound(size: str) -> str:
    """Return the size of a small length as a bound in words."""
    return size.replace("<", "less than") if size.startswith("<") else f"at most {size}"


def with_code(text: str) -> "Markup":
    """Return a text in which the parts between backquotes are marked as code."""
    from markupsafe import Markup, escape

    return Markup(re.sub("`([^`]+)`", r"<code>\1</code>", str(escape(text))))


def unbroken(name: str) -> "Markup":
    """Return a name in which no line is broken inside a number such as ``3-2``."""
    from markupsafe import Markup, escape

    number = r"(?<!\S)(\w{1,4}-\w{1,4})(?!\S)"
    return Markup(re.sub(number, r'<span class="whole">\1</span>', str(escape(name))))
