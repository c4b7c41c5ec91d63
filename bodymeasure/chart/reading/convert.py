"""The conversion of what TOML gives into definitions, with what is wrong in words."""

import re
from collections.abc import Mapping
from enum import StrEnum
from typing import Any, Literal, NamedTuple, TypeVar, get_args, get_origin

import msgspec

from bodymeasure.chart.entry import Entry
from bodymeasure.chart.kinds import KINDS
from bodymeasure.chart.kinds.base import MeasurementDefinition
from bodymeasure.chart.landmarks.rules import RULES
from bodymeasure.chart.landmarks.rules.base import LandmarkRule
from bodymeasure.wording import hint

Struct = TypeVar("Struct", bound=msgspec.Struct)


class Table(NamedTuple):
    """An array of a file of definitions.

    Parameters
    ----------
    name : str
    tag : str
        The member that says of which kind an entry is.
    label : str
        The member by which entries are known.
    kinds : mapping of str to type
        The kind of entry for each value of `tag`.
    """

    name: str
    tag: str
    label: str
    kinds: Mapping[str, type[Entry]]


MEASUREMENTS = Table("measurement", "kind", MeasurementDefinition.label, KINDS)
LANDMARKS = Table("landmark", "rule", LandmarkRule.label, RULES)

# The words that msgspec uses for types, and those that people who write files know.
_WORDS = {
    "str": "text",
    "int": "a whole number",
    "float": "a number",
    "bool": "true or false",
    "array": "a list",
    "object": "a table",
    "null": "nothing",
}
_MISFIT = re.compile(r"Expected `(?P<expected>[^`]*)`(?P<more>[^,]*), got (?P<got>.*)", re.S)


class MisfitError(Exception):
    """An entry does not fit its kind; the error holds the member at fault."""

    def __init__(self, words: str, member: str = "") -> None:
        super().__init__(words)
        self.member = member


def entry_of(table: Table, raw: Any) -> Entry:
    """Return the definition that an entry describes.

    Raises
    ------
    MisfitError
    """
    if not isinstance(raw, dict):
        raise MisfitError(f"expected a table of members, got {as_toml(raw)}")
    given = raw.get(table.tag)
    if given is None:
        kinds = ", ".join(map(repr, table.kinds))
        raise MisfitError(f"has no {table.tag!r}; add one of {kinds}")
    if not isinstance(given, str) or given not in table.kinds:
        near = hint(str(given), table.kinds)
        raise MisfitError(f"has the unknown {table.tag} {given!r}; {near}", table.tag)
    struct = table.kinds[given]
    known = [table.tag, *struct.__struct_fields__]
    for member in raw:
        if member not in known:
            raise MisfitError(
                f"has the unknown member {member!r}; {hint(member, known)} "
                f"(a {table.name} of the {table.tag} {given!r} has: {', '.join(known)})",
                member,
            )
    for field in msgspec.structs.fields(struct):
        if field.required and field.name not in raw:
            raise MisfitError(
                f"has no {field.name!r}, which the {table.tag} {given!r} needs; add it"
            )
        if field.name in raw:
            _check_choice(field, raw[field.name])
    return converted(raw, struct)


def converted(raw: Any, struct: type[Struct]) -> Struct:
    """Return a struct from what TOML gives.

    Raises
    ------
    MisfitError
        If a member is of the wrong type.
    """
    try:
        return msgspec.convert(raw, struct)
    except msgspec.ValidationError as error:
        reason, _, place = str(error).partition(" - at `$.")
        place = place.rstrip("`")
        member = re.split(r"[.\[]", place)[0]
        found = _MISFIT.match(reason)
        if found:
            expected = " or ".join(_WORDS.get(x, x) for x in found["expected"].split(" | "))
            got = re.sub(r"`([^`]*)`", lambda word: _WORDS.get(word[1], word[1]), found["got"])
            reason = f"expected {expected}{found['more']}, got {got}"
        raise MisfitError(f"{place or 'it'}: {reason}", member) from None


def _check_choice(field: msgspec.structs.FieldInfo, value: Any) -> None:
    """Refuse a word that is not one of those that a member may be."""
    allowed = choices(field.type)
    if allowed and value not in allowed:
        raise MisfitError(
            f"{field.name} is {as_toml(value)}; expected one of {', '.join(map(repr, allowed))}",
            field.name,
        )


def choices(annotation: Any) -> tuple[str, ...]:
    """Return the words of which a member of that type has to be one; empty if it is free."""
    if isinstance(annotation, type) and issubclass(annotation, StrEnum):
        return tuple(one.value for one in annotation)
    return get_args(annotation) if get_origin(annotation) is Literal else ()


def as_toml(value: Any) -> str:
    """Return a value as messages show it."""
    return {True: "true", False: "false"}[value] if isinstance(value, bool) else repr(value)
