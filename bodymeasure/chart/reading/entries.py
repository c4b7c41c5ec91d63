"""One entry of a file of definitions: from what TOML gives to a definition, or what is wrong."""

import re
from typing import Any, NamedTuple, TypeVar, get_args

import msgspec

from bodymeasure.chart.kinds.definitions import Measurement
from bodymeasure.chart.landmarks.rules import LandmarkRule
from bodymeasure.wording import hint

Entry = TypeVar("Entry", bound=msgspec.Struct)


class EntryKind(NamedTuple):
    """What an array of a file of definitions holds.

    Parameters
    ----------
    table : str
        Name of the array.
    tag : str
        Member that says which kind of entry it is.
    label : str
        Member by which entries are known.
    structs : mapping of str to type
        The kind of entry for each value of `tag`.
    """

    table: str
    tag: str
    label: str
    structs: dict[str, type[msgspec.Struct]]


def _kind(table: str, tag: str, label: str, union: Any) -> EntryKind:
    structs = {struct.__struct_config__.tag: struct for struct in get_args(union)}
    return EntryKind(table, tag, label, structs)


MEASUREMENTS = _kind("measurement", "kind", "key", Measurement)
RULES = _kind("landmark", "rule", "name", LandmarkRule)

# What msgspec calls things, in words for who writes a file.
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
    """What is wrong with an entry, and with which member of it."""

    def __init__(self, words: str, member: str = "") -> None:
        super().__init__(words)
        self.member = member


def entry_of(kind: EntryKind, raw: Any) -> msgspec.Struct:
    """The definition that an entry describes.

    Raises
    ------
    MisfitError
    """
    if not isinstance(raw, dict):
        raise MisfitError(f"expected a table of members, got {_as_toml(raw)}")
    given = raw.get(kind.tag)
    if given is None:
        kinds = ", ".join(map(repr, kind.structs))
        raise MisfitError(f"has no {kind.tag!r}; add one of {kinds}")
    if not isinstance(given, str) or given not in kind.structs:
        near = hint(str(given), kind.structs)
        raise MisfitError(f"has the unknown {kind.tag} {given!r}; {near}", kind.tag)
    struct = kind.structs[given]
    known = [kind.tag, *struct.__struct_fields__]
    for member in raw:
        if member not in known:
            raise MisfitError(
                f"has the unknown member {member!r}; {hint(member, known)} "
                f"(a {kind.table} of the {kind.tag} {given!r} has: {', '.join(known)})",
                member,
            )
    for field in msgspec.structs.fields(struct):
        if field.required and field.name not in raw:
            raise MisfitError(
                f"has no {field.name!r}, which the {kind.tag} {given!r} needs; add it"
            )
        if field.name in raw:
            _check_choice(field, raw[field.name])
    return converted(raw, struct)


def converted(raw: Any, struct: type[Entry]) -> Entry:
    """A struct from what TOML gives.

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
    """Refuse a word that is none of those which a member may be."""
    choices = [choice for choice in get_args(field.type) if isinstance(choice, str)]
    if choices and value not in choices:
        raise MisfitError(
            f"{field.name} is {_as_toml(value)}; expected one of {', '.join(map(repr, choices))}",
            field.name,
        )


def _as_toml(value: Any) -> str:
    return {True: "true", False: "false"}[value] if isinstance(value, bool) else repr(value)
