"""Notes on lengths that no body has, or that agree with the other source in another unit."""

from collections.abc import Iterable
from typing import NamedTuple

from bodymeasure.atlas import Unit
from bodymeasure.compare.readings import Reading
from bodymeasure.report.units import DEGREES

# Meters: no measurement of a person is longer.
LONGEST = 3.0
# Measurements of the same may differ by less than the first factor; those in a wrong unit agree
# better than by the second one in the right unit. Two units differ by 2.54 at least.
APART, ALIKE = 1.8, 1.25


class Doubt(NamedTuple):
    """A length that is doubtful, and the unit in which it would not be (None if there is none)."""

    reading: Reading
    likely: Unit | None


def doubt(reading: Reading, other: Reading) -> Doubt | None:
    """Return what makes a length doubtful beside another source's length of the same; else None.

    Values with an error estimate were computed from a body; only others are typed by hand. Beside
    one of these, only a length that no body has is doubtful.
    """
    if DEGREES in (reading.unit, other.unit) or reading.error is not None:
        return None
    if not (reading.value and other.value and reading.value > 0.0 and other.value > 0.0):
        return None
    expected = other.value * Unit.parse(other.unit).meters
    own = Unit.parse(reading.unit)
    likely = [
        unit
        for unit in Unit
        if 1.0 / ALIKE < reading.value * unit.meters / expected < ALIKE and unit != own
    ]
    length = reading.value * own.meters
    far = other.error is not None and not 1.0 / APART < length / expected < APART
    if length > LONGEST or (likely and far):
        return Doubt(reading, likely[0] if likely else None)
    return None


def doubt_notes(doubts: Iterable[Doubt], name: str) -> list[str]:
    """Return one note for each likely unit on the doubtful lengths of the source `name`."""
    by_unit: dict[Unit | None, list[Reading]] = {}
    for one in doubts:
        by_unit.setdefault(one.likely, []).append(one.reading)
    notes = []
    for likely, readings in by_unit.items():
        first, more = readings[0], len(readings) - 1
        # With several values, the note says how many share the fault, and shows one.
        others = f" ({more} more like it)" if more else ""
        stated = f"{name}: {first.measurement} is {first.value:g} {first.unit}{others}"
        if likely is None:
            notes.append(
                f"{stated}, longer than any measurement of a body; expected at most "
                f"{LONGEST:g} m; look at the value and its unit"
            )
        else:
            notes.append(
                f"{stated}, far from the other source's; in {likely} it would agree: is the unit "
                f"{likely}?"
            )
    return notes
