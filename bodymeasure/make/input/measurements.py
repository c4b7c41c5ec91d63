"""Measurements that a body is to have."""

from dataclasses import dataclass

from bodymeasure.atlas import Unit
from bodymeasure.report.units import DEGREES
from bodymeasure.wording import counted


@dataclass(frozen=True)
class Value:
    """One measurement that a body is to have.

    Parameters
    ----------
    key : str
        The key of its definition, with left or right in place of ``{side}``.
    value : float
        As written, in `unit`.
    unit : str
        m, cm, mm, inch or deg.
    place : str
        Its place in the source, for messages.
    """

    key: str
    value: float
    unit: str
    place: str = ""

    @property
    def base(self) -> float:
        """The value in meters, or in degrees."""
        return self.value if self.unit == DEGREES else self.value * Unit.parse(self.unit).meters

    @property
    def factor(self) -> float:
        """The factor that takes meters, or degrees, to its unit."""
        return 1.0 if self.unit == DEGREES else 1.0 / Unit.parse(self.unit).meters

    def written(self, base: float, digits: int = 1) -> str:
        """Return a value in meters or degrees in the unit of this one, with the unit."""
        if self.unit == DEGREES:
            return f"{base:.{digits}f} deg"
        unit = Unit.parse(self.unit)
        more = {Unit.M: 2, Unit.MM: -1}.get(unit, 0)
        return f"{base / unit.meters:.{max(digits + more, 0)}f} {unit.value}"


@dataclass(frozen=True, repr=False)
class Measurements:
    """The measurements that a body is to have.

    Parameters
    ----------
    name : str
        Of the person, the size or the file.
    values : tuple of Value
        Each key once.
    sex : {"female", "male"} or None
        If the source says it.
    notes : tuple of str
        What the source holds besides, and why it is not used.
    """

    name: str
    values: tuple[Value, ...]
    sex: str | None = None
    notes: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return f"<Measurements of {self.name!r}: {counted(len(self.values), 'value')}>"
