"""The entries of a file of definitions: what measurements and rules have in common."""

from collections.abc import Iterator
from functools import cache
from typing import Annotated, Any, ClassVar, NamedTuple, get_args, get_type_hints

import msgspec

_LANDMARK = msgspec.Meta(extra={"names": "a landmark"})
_FORMULA = msgspec.Meta(extra={"names": "measurements"})

Landmark = Annotated[str, _LANDMARK]
"""The type of a member, or of a part of one, that names a landmark."""
FormulaText = Annotated[str, _FORMULA]
"""The type of a member that holds a formula of other measurements."""


class Fault(NamedTuple):
    """A fault of one entry.

    Parameters
    ----------
    entry : Entry
        The entry as it stands in the set, with ``{side}``.
    member : str
        The member at fault; empty if it is the whole.
    words : str
    """

    entry: "Entry"
    member: str
    words: str


class Entry(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """An entry of a file of definitions.

    The members that name landmarks have the type `Landmark`, and those that hold formulas have the
    type `FormulaText`; what an entry needs is read off them.
    """

    label: ClassVar[str]
    """The member by which the entries of a table are known."""
    example: ClassVar[str]
    """The members of its own kind in an example, as TOML, one on each line."""

    @classmethod
    def tag(cls) -> str:
        """The word that stands for the kind of entry in a file of definitions."""
        return str(cls.__struct_config__.tag)

    @property
    def landmarks(self) -> tuple[str, ...]:
        """The names of the landmarks that the entry refers to, each once."""
        members = _members(type(self), _LANDMARK)
        return tuple(dict.fromkeys(texts_in(tuple(getattr(self, name) for name in members))))

    @property
    def formulas(self) -> tuple[str, ...]:
        """The formulas that the entry holds."""
        return tuple(getattr(self, name) for name in _members(type(self), _FORMULA))

    def faults(self) -> Iterator[Fault]:
        """Yield the faults of the entry beyond the types of its members."""
        return iter(())


@cache
def _members(kind: type[Entry], mark: msgspec.Meta) -> tuple[str, ...]:
    """Return the members of a kind of entry whose types hold a mark."""
    types = get_type_hints(kind, include_extras=True)
    return tuple(name for name in kind.__struct_fields__ if mark in _parts(types[name]))


def _parts(annotation: Any) -> Iterator[Any]:
    """Yield all parts of a type, marks included."""
    for part in get_args(annotation):
        yield part
        yield from _parts(part)


def texts(entry: Entry) -> Iterator[tuple[str, str]]:
    """Yield all texts of an entry, each with the name of the member in which it stands."""
    for member in entry.__struct_fields__:
        for text in texts_in(getattr(entry, member)):
            yield member, text


def texts_in(value: Any) -> Iterator[str]:
    """Yield all texts of an entry or of a member's value, in order."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, tuple):
        for item in value:
            yield from texts_in(item)
    elif isinstance(value, msgspec.Struct):
        for member in value.__struct_fields__:
            yield from texts_in(getattr(value, member))
