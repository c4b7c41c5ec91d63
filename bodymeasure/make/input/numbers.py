"""Values as people write them: with a unit, with a decimal comma, in inches and fractions."""

import math
import re
from fractions import Fraction

from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError
from bodymeasure.report.units import DEGREES

_FORM = re.compile(
    r"(?P<number>[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+))?\s*(?P<fraction>\d+/\d+)?\s*"
    r"(?P<unit>m|cm|mm|inch|inches|in|\"|\u2033|deg|\u00b0)?",
    re.ASCII | re.IGNORECASE,
)
_UNITS = {"in": "inch", "inches": "inch", '"': "inch", "\u2033": "inch", "\u00b0": DEGREES}
# In any unit: far beyond what bodies have, and its square is finite in the judgment of a set.
LARGEST = 1e6
UNITS = (*(unit.value for unit in Unit), DEGREES)


def parsed(text: str, unit: str | None, place: str) -> tuple[float, str]:
    """Return a value and its unit.

    Parameters
    ----------
    text : str
        Such as ``92``, ``92.5 cm``, ``36 1/4 in``.
    unit : str or None
        The unit if the text says none.
    place : str
        For messages.

    Raises
    ------
    InputError
        If it is not a number with a unit.
    """
    form = _FORM.fullmatch(text.strip())
    if form is None or (form["number"] is None and form["fraction"] is None):
        raise InputError(
            f"{place}: {text!r} is not a value; expected one such as 92.5 cm or 36 1/4 in"
        )
    said = form["unit"].casefold() if form["unit"] else None
    own = _UNITS.get(said, said) if said else unit
    if own not in UNITS:
        raise InputError(
            f"{place}: {text!r} has no unit, and none is guessed; write it, as in {text.strip()} "
            "cm, or give the unit"
        )
    try:
        number = float((form["number"] or "0").replace(",", "."))
        number += float(Fraction(form["fraction"] or "0"))
    except ZeroDivisionError:
        number = math.nan
    return checked(number, own, text, place), own


def checked(number: float, unit: str, text: str, place: str) -> float:
    """Return a number, once it is known to be one that a measurement can have."""
    if not abs(number) <= LARGEST:
        number = math.inf
    if not math.isfinite(number):
        raise InputError(
            f"{place}: {text!r} is no number that a body has; expected one such as 92.5"
        )
    if number <= 0.0 and unit != DEGREES:
        raise InputError(f"{place}: {text!r} is no length; expected one above zero")
    return number
