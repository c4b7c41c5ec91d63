"""Units of length, and lengths that are given with a body rather than measured on its atlas."""

from dataclasses import dataclass
from enum import StrEnum
from typing import Self, TypeVar

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


@dataclass(frozen=True)
class GivenLength:
    """A length of a body that its atlas does not show, such as the girth of a head.

    It may be measured on the whole body of which the atlas covers a part, or by hand.

    Parameters
    ----------
    value : float
        In the atlas's unit.
    error_estimate : float
        Estimated error of `value` as a length of its source, in its unit: of the computation.
    uncertainty : float
        How far the source itself may be from the person, in the same unit; 0 if it is taken for the
        person, as a model is.
    origin : str
        Where the length comes from, as a sentence.

    Raises
    ------
    InputError
        If the value is not positive and finite, or an error is negative.
    """

    value: float
    error_estimate: float = 0.0
    uncertainty: float = 0.0
    origin: str = ""

    def __post_init__(self) -> None:
        for name in ("value", "error_estimate", "uncertainty"):
            object.__setattr__(self, name, float(getattr(self, name)))
        if not 0.0 < self.value < float("inf"):
            raise InputError(f"a given length is {self.value}; expected a positive number")
        for what in ("error_estimate", "uncertainty"):
            error = getattr(self, what)
            if not 0.0 <= error < float("inf"):
                raise InputError(f"the {what} of a given length is {error}; expected 0 or more")

    def scaled(self, factor: float) -> Self:
        """Return the same length where a unit is a `factor` of the old one."""
        return type(self)(
            self.value * factor,
            self.error_estimate * factor,
            self.uncertainty * factor,
            self.origin,
        )
