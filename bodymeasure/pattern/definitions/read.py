"""Reading files of panels, with errors on which their authors can act."""

import codecs
import re
import tomllib
from functools import cache, reduce
from operator import or_
from pathlib import Path
from types import GenericAlias
from typing import Any

import msgspec

from bodymeasure.arguments import file_path
from bodymeasure.chart import LandmarkRule, both_sides
from bodymeasure.chart.landmarks.rules import RULES
from bodymeasure.errors import InputError
from bodymeasure.files import read_bytes
from bodymeasure.pattern.cloth.ease import checked_ease
from bodymeasure.pattern.definitions.checks import panel_faults
from bodymeasure.pattern.definitions.panels import FORMAT, VERSION, PatternDefinitions
from bodymeasure.pattern.definitions.seams import seam_faults
from bodymeasure.wording import hint

FOLDER = Path(__file__).parents[1] / "data"
# What to do about a member that is not there, or of another type.
MEMBERS = "`bodymeasure docs patterns` lists the members, and --print-set bodice prints an example"
SETS = ("bodice", "princess", "skirt", "sleeve", "trousers")


def load_pattern(source: str | Path) -> PatternDefinitions:
    """Read a set of panels.

    Parameters
    ----------
    source : str or Path
        The name of a set that comes along (``bodice``,
        ``princess``, ``skirt``, ``sleeve`` or ``trousers``), or a file.
        ``bodymeasure pattern --print-set bodice`` prints one, to be copied and changed.

    Returns
    -------
    PatternDefinitions
        The set, checked, together with what it extends. Panels with ``{side}`` stand for a left and
        a right one.

    Raises
    ------
    InputError
        If the file is no set of panels. The message names the file, the panel and the edge, and
        says what was expected.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> [panel.name for panel in bm.load_pattern("skirt").panel]
    ['skirt front', 'skirt back']
    """
    if isinstance(source, str) and source in SETS:
        return pattern_from(set_text(str(source)).encode(), str(source))
    path = file_path(source)
    if not path.suffix and not path.exists():
        raise InputError(f"{path}: no such file, and no set of that name; {hint(str(path), SETS)}")
    return pattern_from(read_bytes(path), str(path))


def set_text(name: str) -> str:
    """Return the file of a set that comes along."""
    return (FOLDER / f"{name}.toml").read_text(encoding="utf-8")


@cache
def known_seams() -> frozenset[str]:
    """Return the names of all seams in the sets that come along."""
    found = (re.findall(r'^seam = "(.*)"', set_text(name), flags=re.MULTILINE) for name in SETS)
    return frozenset(name for names in found for name in names)


def pattern_from(content: bytes, source: str) -> PatternDefinitions:
    """Return the panels in a file's content; `source` names the file in errors.

    Raises
    ------
    InputError
    """
    raw = _parsed(content, source)
    if raw.get("format") != FORMAT:
        raise InputError(
            f'{source}: is no set of panels; expected format = "{FORMAT}" at its head, got '
            f"{raw.get('format')!r}"
        )
    if raw.get("version") != VERSION or isinstance(raw.get("version"), bool):
        raise InputError(
            f"{source}: has version {raw.get('version')!r}; this bodymeasure reads version "
            f"{VERSION}; update whichever of the two is older"
        )
    rules = _rules(raw.pop("landmark", []), source)
    try:
        own = msgspec.structs.replace(msgspec.convert(raw, PatternDefinitions), landmark=rules)
    except msgspec.ValidationError as error:
        raise InputError(f"{source}: {_in_words(str(error), raw)}; {MEMBERS}") from None
    whole = _extended(own, source)
    checked_ease(whole.ease, f"{source}: ease")
    names = [panel.name for panel in whole.panel]
    for panel in whole.panel:
        for fault in panel_faults(panel):
            raise InputError(f"{source}: panel {panel.name!r} {fault}")
        if names.count(panel.name) > 1:
            raise InputError(
                f"{source}: two panels are named {panel.name!r}; rename one, or put {{side}} in it"
            )
    if not names:
        raise InputError(f"{source}: has no panel; begin each with a line [[panel]]")
    for fault in seam_faults(whole.panel):
        raise InputError(f"{source}: {fault}")
    return whole


def _rules(raw: object, source: str) -> tuple[LandmarkRule, ...]:
    """Return the rules for landmarks in a file, one for each side where they name ``{side}``."""
    kinds = GenericAlias(list, (reduce(or_, RULES.values()),))
    try:
        rules = msgspec.convert(raw, kinds)
    except msgspec.ValidationError as error:
        words = str(error).replace("`$[", "`$.landmark[")
        told = _in_words(words, {"landmark": raw})
        raise InputError(f"{source}: {told}; {MEMBERS}") from None
    return both_sides(rules)


def _parsed(content: bytes, source: str) -> dict[str, Any]:
    try:
        return tomllib.loads(content.removeprefix(codecs.BOM_UTF8).decode())
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise InputError(
            f"{source}, line {line}: is not text in UTF-8; save the file in that encoding"
        ) from None
    except (tomllib.TOMLDecodeError, ValueError) as error:
        raise InputError(
            f"{source}: is not valid TOML ({error}); compare with `bodymeasure pattern "
            "--print-set bodice`"
        ) from None
    except RecursionError:
        raise InputError(f"{source}: is nested too deeply to hold panels") from None


def _extended(own: PatternDefinitions, source: str) -> PatternDefinitions:
    if own.extends and own.extends not in SETS:
        raise InputError(f"{source}: extends is {own.extends!r}; {hint(own.extends, SETS)}")
    extended = load_pattern(own.extends) if own.extends else None
    base = extended.panel if extended else ()
    ease = {**(extended.ease if extended else {}), **own.ease}
    rules = {rule.name: rule for rule in (*(extended.landmark if extended else ()), *own.landmark)}
    known = [panel.name for panel in base]
    for name in own.drop:
        if name not in known:
            raise InputError(
                f"{source}: drop names {name!r}, which is not in what is extended; "
                f"{hint(name, known)}"
            )
    mine = both_sides(own.panel)
    panels = {panel.name: panel for panel in base if panel.name not in own.drop}
    twice = [panel for panel in mine if [one.name for one in mine].count(panel.name) > 1]
    if twice:
        raise InputError(
            f"{source}: two panels are named {twice[0].name!r}; rename one, or put {{side}} in it"
        )
    panels |= {panel.name: panel for panel in mine}
    return msgspec.structs.replace(
        own,
        extends="",
        drop=(),
        panel=tuple(panels.values()),
        ease=ease,
        bridge=own.bridge or (extended is not None and extended.bridge),
        landmark=tuple(rules.values()),
    )


def _in_words(reason: str, raw: dict[str, Any]) -> str:
    """Return a message of msgspec with the names of the panel and the edge in place of numbers."""
    words, _, place = reason.partition(" - at `$")
    value: Any = raw
    named = []
    for kind, number in re.findall(r"\.?(\w+)\[(\d+)\]", place):
        entries = value.get(kind) if isinstance(value, dict) else None
        value = entries[int(number)] if isinstance(entries, list) else None
        label = value.get("name") if isinstance(value, dict) else None
        if kind in ("panel", "edge", "dart", "landmark"):
            named.append(f"{kind} {label!r}" if label else f"{kind} {int(number) + 1}")
    rest = place.rstrip("`").removesuffix("[...]").rpartition("]")[2].strip(".")
    where = ", ".join([*named, *([f"member {rest!r}"] if rest else [])])
    return f"{where}: {words}" if where else words
