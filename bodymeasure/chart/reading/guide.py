"""The file of the default set, whose comments describe all kinds of measurements and rules."""

import inspect
import json
import re
import textwrap
from collections.abc import Iterator, Mapping

import msgspec

from bodymeasure.chart.entry import Entry
from bodymeasure.chart.kinds import KINDS
from bodymeasure.chart.kinds.base import MeasurementDefinition
from bodymeasure.chart.landmarks.rules import RULES
from bodymeasure.chart.landmarks.rules.base import LandmarkRule
from bodymeasure.chart.reading.convert import choices
from bodymeasure.chart.reading.read import DEFAULT
from bodymeasure.files import read_bytes

WIDTH = 100


def default_set() -> str:
    """Return the file of the default set, whose comments say how such files are written.

    Examples
    --------
    >>> print(default_set()[:41])
    # The default set of body measurements.
    #
    """
    text = read_bytes(DEFAULT).decode()
    for table, kinds, base in (
        ("kinds", KINDS, MeasurementDefinition),
        ("rules", RULES, LandmarkRule),
    ):
        # The file has a line in the place of each table.
        text = text.replace(f"# <{table}>\n", _described(kinds, base))
    return text


def _described(kinds: Mapping[str, type[Entry]], base: type[Entry]) -> str:
    """Return comments that describe kinds of entries, with the members that they add to a base."""
    lines = []
    for tag, kind in kinds.items():
        summary = (inspect.getdoc(kind) or "").partition("\n\n")[0]
        lines += ["", *_wrapped(f'"{tag}": {summary}', 4)]
        for line in (*_members(kind, base), *_example(kind)):
            lines += _wrapped(line, 8)
    return "".join(f"#{line}\n" for line in lines)


def _wrapped(text: str, indent: int) -> list[str]:
    first, further = " " * indent, " " * (indent + 4)
    return textwrap.wrap(text, WIDTH - 1, initial_indent=first, subsequent_indent=further)


def _members(kind: type[Entry], base: type[Entry]) -> Iterator[str]:
    """Yield what the members are that a kind adds to a base, with their choices and defaults."""
    words = _documented(kind)
    about: dict[str, list[str]] = {}
    for field in msgspec.structs.fields(kind):
        if field.name in base.__struct_fields__:
            continue
        said = [words.get(field.name, "")]
        if allowed := [json.dumps(word) for word in choices(field.type)]:
            said.append(f"One of {', '.join(allowed)}.")
        if not field.required:
            given = field.default is not None
            said.append(f"The default is {json.dumps(field.default)}." if given else "Optional.")
        # Members with the same description stand together.
        about.setdefault(" ".join(filter(None, said)), []).append(field.name)
    yield from (f"{', '.join(names)}: {said}" for said, names in about.items())


def _example(kind: type[Entry]) -> Iterator[str]:
    """Yield the lines of a kind's example."""
    yield "for example:"
    yield from ("    " + line for line in inspect.cleandoc(kind.example).splitlines())


def _documented(kind: type[Entry]) -> dict[str, str]:
    """Return what the docstring of a kind says of each of its members."""
    section = (inspect.getdoc(kind) or "").partition("Parameters\n----------\n")[2]
    found = re.findall(r"^(\w[\w, ]*) : .*((?:\n {4}.*)*)", section, re.M)
    plain = {names: " ".join(words.replace("``", "").split()) for names, words in found}
    return {name: words for names, words in plain.items() for name in names.split(", ")}
