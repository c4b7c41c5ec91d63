"""Definitions that stand for a left and a right one."""

from collections.abc import Iterable
from typing import Any, TypeVar

import msgspec

from bodymeasure.chart.entry import texts_in

SIDE = "{side}"
SIDES = ("left", "right")

Definition = TypeVar("Definition", bound=msgspec.Struct)


def both_sides(definitions: Iterable[Definition]) -> tuple[Definition, ...]:
    """Return all definitions, each one with ``{side}`` once for the left and once for the right.

    Parameters
    ----------
    definitions : iterable of MeasurementDefinition or of LandmarkRule

    Examples
    --------
    >>> from bodymeasure.chart.kinds import HeightMeasure
    >>> hip = HeightMeasure(key="hip_{side}", name="Hip, {side}", at="side hip point {side}")
    >>> [one.at for one in both_sides([hip])]
    ['side hip point left', 'side hip point right']
    """
    result: list[Definition] = []
    for definition in definitions:
        if any(SIDE in text for text in texts_in(definition)):
            result += [_with_side(definition, side) for side in SIDES]
        else:
            result.append(definition)
    return tuple(result)


def _with_side(definition: Definition, side: str) -> Definition:
    """Return a definition with a side in place of ``{side}``."""

    def replaced(value: Any) -> Any:
        if isinstance(value, str):
            # What has no side stays what it is: a class of measurements is more than its text.
            return value.replace(SIDE, side) if SIDE in value else value
        if isinstance(value, tuple):
            return tuple(replaced(item) for item in value)
        return _with_side(value, side) if isinstance(value, msgspec.Struct) else value

    members = {name: replaced(getattr(definition, name)) for name in definition.__struct_fields__}
    return type(definition)(**members)
