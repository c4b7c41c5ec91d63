"""Units of length."""

from enum import StrEnum
from typing import TypeVar

from bodymeasure._typing import Array
from bodymeasure.errors import InputError

Length = TypeVar("Length", float, Array)


class Unit(StrEnum):
    """A unit of length that an atlas or a report may be in."""

    M = "m"
    CM = "cm"
    MM = "mm"
    INCH = "inch"

    @property
    def meters(self) -> float:
        """Length of one unit in meters, exact by definition."""
        return _METERS[self]

    @classmethod
    def parse(cls, text: str) -> "Unit":
        """Return the unit of a name.

        Raises
        ------
        InputError
            If there is no such unit; lengths are never guessed.
        """
        try:
            return cls(text)
        except ValueError:
            known = ", ".join(unit.value for unit in cls)
            raise InputError(f"unknown unit {text!r}; expected one of {known}") from None


_METERS = {
    Unit.M: 1.0,
    Unit.CM: 0.01,
    Unit.MM: 0.001,
    Unit.INCH: 0.0254,
}


def convert_length(length: Length, source: Unit, target: Unit) -> Length:
    """Convert a length, or an array of lengths, from the unit `source` to the unit `target`."""
    if source == target:
        return length
    return length * (source.meters / target.meters)
