"""Definitions that stand for a left and a right one."""

from collections.abc import Iterator, Sequence
from typing import Any, TypeVar

import msgspec

SIDE = "{side}"
SIDES = ("left", "right")

Definition = TypeVar("Definition", bound=msgspec.Struct)


def both_sides(definitions: Sequence[Definition]) -> tuple[Definition, ...]:
    """All definitions, those with ``{side}`` once for the left and once for the right.

    Parameters
    ----------
    definitions : sequence of Measurement or of LandmarkRule
    """
    result: list[Definition] = []
    for definition in definitions:
        if any(SIDE in text for _, text in texts(definition)):
            result += [_put(definition, side) for side in SIDES]
        else:
            result.append(definition)
    return tuple(result)


def texts(definition: msgspec.Struct) -> Iterator[tuple[str, str]]:
    """All texts of a definition, each with the name of the member that it stands in."""
    for member in definition.__struct_fields__:
        for text in _texts_in(getattr(definition, member)):
            yield member, text


def _texts_in(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, tuple):
        for item in value:
            yield from _texts_in(item)
    elif isinstance(value, msgspec.Struct):
        for _, text in texts(value):
            yield text


def _put(definition: Definition, side: str) -> Definition:
    """A definition with the side in place of ``{side}``."""

    def put(value: Any) -> Any:
        if isinstance(value, str):
            return value.replace(SIDE, side)
        if isinstance(value, tuple):
            return tuple(put(item) for item in value)
        return _put(value, side) if isinstance(value, msgspec.Struct) else value

    members = {name: put(getattr(definition, name)) for name in definition.__struct_fields__}
    return type(definition)(**members)
