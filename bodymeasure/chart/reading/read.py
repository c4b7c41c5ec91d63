"""Reading files of definitions, with errors on which their authors can act."""

import codecs
import re
import tomllib
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

import msgspec

from bodymeasure.arguments import file_path
from bodymeasure.chart.definitions import FORMAT, VERSION, Definitions
from bodymeasure.chart.reading.checks import first_fault
from bodymeasure.chart.reading.convert import (
    LANDMARKS,
    MEASUREMENTS,
    MisfitError,
    Table,
    converted,
    entry_of,
)
from bodymeasure.chart.reading.source_lines import SourceLines
from bodymeasure.chart.sides import SIDE, both_sides
from bodymeasure.errors import InputError
from bodymeasure.files import read_bytes
from bodymeasure.wording import hint

DEFAULT = Path(__file__).parents[1] / "data" / "default.toml"


def load_definitions(path: str | Path | None = None) -> Definitions:
    """Read a file of definitions.

    Parameters
    ----------
    path : str or Path, optional
        The default set if not given. ``bodymeasure chart --print-set`` prints its file, whose
        comments say how such files are written.

    Returns
    -------
    Definitions
        The set, checked, together with what it extends.

    Raises
    ------
    InputError
        If the file is no set of definitions. The message names the file, the line and the
        measurement, and says what was expected and what to do.

    Examples
    --------
    >>> definitions = load_definitions()
    >>> definitions.measurement[0].name
    'Neck girth'
    """
    if path is None:
        return _default()
    return definitions_from(read_bytes(file_path(path)), str(path))


@lru_cache(maxsize=1)
def _default() -> Definitions:
    return definitions_from(read_bytes(DEFAULT), str(DEFAULT))


def definitions_from(content: bytes, source: str) -> Definitions:
    """Return the definitions in a file's content; `source` names the file in errors.

    Raises
    ------
    InputError
        As for `load_definitions`.
    """
    text, raw = _parsed(content, source)
    lines = SourceLines.of(text)
    _check_header(raw, lines, source)
    rules = _entries(LANDMARKS, raw, lines, source)
    measurements = _entries(MEASUREMENTS, raw, lines, source)
    try:
        own = converted({**raw, "landmark": [], "measurement": []}, Definitions)
    except MisfitError as misfit:
        line = lines.member(misfit.member)
        raise InputError(f"{source}, line {line}: {misfit}") from None
    own = msgspec.structs.replace(own, landmark=rules, measurement=measurements)
    _check_repeated(own, lines, source)
    whole = _extended(own, lines, source)
    _check_presets(own, whole, lines, source)
    fault = first_fault(whole)
    if fault is not None:
        place = _place(fault.entry, fault.member, own, lines)
        raise InputError(f"{source}, {place}: {fault.words}")
    return whole


def _parsed(content: bytes, source: str) -> tuple[str, dict[str, Any]]:
    try:
        # Some editors put a byte order mark in front.
        text = content.removeprefix(codecs.BOM_UTF8).decode()
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise InputError(
            f"{source}, line {line}: is not text in UTF-8; save the file in that encoding"
        ) from None
    try:
        return text, tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        reason = str(error)
        found = re.search(r" \(at line (\d+), column (\d+)\)$", reason)
        # The parser gives no number at the end of the document.
        line = int(found[1]) if found else text.count("\n") + 1
        column = f" at column {found[2]}" if found else " at the end of the file"
        what = reason[: found.start()] if found else reason.removesuffix(" (at end of document)")
        raise InputError(
            f"{source}, line {line}: is not valid TOML ({what}{column}); "
            "compare with the default set, or look it up on toml.io"
        ) from None
    except ValueError as error:
        # For example, a whole number of thousands of digits.
        raise InputError(f"{source}: holds a value that cannot be read ({error})") from None
    except RecursionError:
        raise InputError(f"{source}: is nested too deeply to hold definitions") from None


def _check_header(raw: dict[str, Any], lines: SourceLines, source: str) -> None:
    known = Definitions.__struct_fields__
    if raw.get("format") != FORMAT:
        raise InputError(
            f"{source}, line {lines.member('format')}: is not a file of {FORMAT}; expected "
            f'format = "{FORMAT}" at its head, got {raw.get("format")!r}'
        )
    version = raw.get("version")
    # True equals 1 in Python, but is no version.
    if version != VERSION or isinstance(version, bool):
        raise InputError(
            f"{source}, line {lines.member('version')}: has version {version!r}; this bodymeasure "
            f"reads version {VERSION}; update whichever of the two is older"
        )
    for member in raw:
        if member not in known:
            raise InputError(
                f"{source}, line {lines.member(member)}: has the unknown member {member!r}; "
                f"{hint(member, known)}"
            )
    if "name" not in raw:
        raise InputError(f'{source}, line 1: the set has no name; add a line such as name = "Mine"')
    if raw.get("extends", "") not in ("", "default"):
        raise InputError(
            f"{source}, line {lines.member('extends')}: extends is {raw['extends']!r}; "
            "only 'default' can be extended"
        )


def _entries(table: Table, raw: dict[str, Any], lines: SourceLines, source: str) -> tuple[Any, ...]:
    entries = raw.get(table.name, [])
    if not isinstance(entries, list):
        raise InputError(
            f"{source}, line {lines.member(table.name)}: {table.name} is no list of entries; "
            f"begin each with a line [[{table.name}]]"
        )
    result = []
    for number, entry in enumerate(entries):
        try:
            result.append(entry_of(table, entry))
        except MisfitError as misfit:
            line = lines.entry(table.name, number)
            if misfit.member:
                line = lines.entry_member(table.name, number, misfit.member)
            label = entry.get(table.label) if isinstance(entry, dict) else None
            called = repr(label) if isinstance(label, str) else str(number + 1)
            raise InputError(f"{source}, line {line}: {table.name} {called}: {misfit}") from None
    return tuple(result)


def _check_repeated(own: Definitions, lines: SourceLines, source: str) -> None:
    """Refuse what one file defines twice; otherwise the second would replace the first unseen."""
    for table, entries in ((LANDMARKS, own.landmark), (MEASUREMENTS, own.measurement)):
        first: dict[str, int] = {}
        for number, entry in enumerate(entries):
            label = getattr(entry, table.label)
            if label in first:
                raise InputError(
                    f"{source}, line {lines.entry_member(table.name, number, table.label)}: "
                    f"{table.name} {label!r}: the {table.label} {label!r} is there twice, first on "
                    f"line {lines.entry_member(table.name, first[label], table.label)}; rename or "
                    "remove one of the two"
                )
            first[label] = number


def _extended(own: Definitions, lines: SourceLines, source: str) -> Definitions:
    """Return the set with what it extends, without what it drops."""
    base = _default() if own.extends else None
    rules = base.landmark if base else ()
    measurements = base.measurement if base else ()
    droppable = [rule.name for rule in rules] + [one.key for one in measurements]
    for dropped in own.drop:
        if dropped not in droppable:
            known = (
                hint(
                    _as_written(dropped),
                    droppable,
                    expected="give keys and names of the default set, such as",
                )
                if base
                else 'a set without extends = "default" has nothing to drop'
            )
            raise InputError(
                f"{source}, line {lines.member('drop')}: drop names {dropped!r}, which is not in "
                f"what is extended; {known}"
            )
    presets = {**(base.presets if base else {}), **own.presets}
    return msgspec.structs.replace(
        own,
        extends="",
        drop=(),
        presets=presets,
        landmark=_merged(rules, own.landmark, own.drop),
        measurement=_merged(measurements, own.measurement, own.drop),
    )


def _check_presets(own: Definitions, whole: Definitions, lines: SourceLines, source: str) -> None:
    """Refuse a preset that names what the set does not measure."""
    keys = [one.key for one in both_sides(whole.measurement)]
    keys += [one.key.replace(f"_{SIDE}", "") for one in whole.measurement if SIDE in one.key]
    for name, members in own.presets.items():
        for member in members:
            if member not in keys:
                raise InputError(
                    f"{source}, line {lines.member('presets')}: the preset {name!r} names "
                    f"{member!r}, which is no measurement; {hint(member, keys)}"
                )


def _as_written(name: str) -> str:
    """Return the name that a set gives to both sides, from the name of one side."""
    return re.sub(r"(?<![^\W_])(left|right)(?![^\W_])", SIDE, name)


def _merged(base: Sequence[Any], own: Sequence[Any], drop: Sequence[str]) -> tuple[Any, ...]:
    """Return the entries of a base set, with a set's own in the place of those they replace."""
    result = {getattr(entry, entry.label): entry for entry in base}
    result = {name: entry for name, entry in result.items() if name not in drop}
    # An entry that replaces another stands in its place.
    result |= {getattr(entry, entry.label): entry for entry in own}
    return tuple(result.values())


def _place(definition: Any, member: str, own: Definitions, lines: SourceLines) -> str:
    """Return the line and the name of a definition at fault, which may be an extended one."""
    for table, entries in ((LANDMARKS, own.landmark), (MEASUREMENTS, own.measurement)):
        for number, entry in enumerate(entries):
            if entry is definition:
                line = lines.entry_member(table.name, number, member)
                return f"line {line}: {table.name} {getattr(entry, table.label)!r}"
    label = getattr(definition, definition.label)
    line = lines.member("drop" if own.drop else "extends")
    return f"line {line}: {label!r} of the default set, with the changes that this file makes"
