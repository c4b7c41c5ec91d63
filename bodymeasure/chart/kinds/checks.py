"""Checks that several kinds share."""

from collections.abc import Iterator

from bodymeasure.chart.entry import Fault
from bodymeasure.chart.kinds.base import MeasurementDefinition


def same_place(
    definition: MeasurementDefinition, member: str, one: str, other: str | None
) -> Iterator[Fault]:
    """Refuse a measurement from a landmark to itself, which would be 0."""
    if one == other:
        yield Fault(
            definition,
            member,
            f"leads from {one!r} to the same landmark, which is 0 on every body; name two",
        )
