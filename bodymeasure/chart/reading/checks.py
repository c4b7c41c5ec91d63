"""Checks of a set of definitions beyond the types of its members."""

import re
import unicodedata
from collections.abc import Iterator, Sequence

from bodymeasure.chart.definitions import Definitions
from bodymeasure.chart.entry import Entry, Fault, texts
from bodymeasure.chart.formula.parse import FUNCTIONS
from bodymeasure.chart.kinds.base import MeasurementDefinition
from bodymeasure.chart.kinds.given import GivenMeasure
from bodymeasure.chart.landmarks.rules.base import LandmarkRule
from bodymeasure.chart.reading.formulas import formula_fault
from bodymeasure.chart.sides import SIDE, both_sides

_KEY = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_BRACED = re.compile(r"\{[^{}]*\}|[{}]")


def first_fault(definitions: Definitions) -> Fault | None:
    """Return the first fault of a set; None if it has none."""
    return next(_faults(definitions), None) or formula_fault(definitions.measurement)


def _faults(definitions: Definitions) -> Iterator[Fault]:
    for entry in (*definitions.landmark, *definitions.measurement):
        yield from _text_faults(entry)
        if isinstance(entry, MeasurementDefinition):
            yield from _key_faults(entry)
        yield from _side_faults(entry, getattr(entry, entry.label))
        yield from entry.faults()
    yield from _repeated(definitions.landmark)
    yield from _repeated(definitions.measurement)


def _key_faults(measurement: MeasurementDefinition) -> Iterator[Fault]:
    plain = measurement.key.replace(SIDE, "side")
    if not _KEY.fullmatch(plain):
        yield Fault(
            measurement,
            "key",
            f"the key {measurement.key!r} cannot stand in a formula; expected letters, digits and "
            "underscores, not a digit first, such as 'bust_girth'",
        )
    if plain in FUNCTIONS:
        yield Fault(measurement, "key", f"the key {plain!r} is a function's name; choose another")


# These may be left out; every other text names something.
_MAY_BE_EMPTY = ("words", "group", "iso")


def _text_faults(definition: Entry) -> Iterator[Fault]:
    for member, text in texts(definition):
        if not text.strip() and member not in _MAY_BE_EMPTY:
            yield Fault(definition, member, f"{member} is empty; expected a name")
        if member != "words" and any(unicodedata.category(sign) == "Cc" for sign in text):
            yield Fault(definition, member, f"{member} is {text!r}; expected text on one line")
        for braced in _BRACED.findall(text):
            if braced != SIDE:
                yield Fault(
                    definition, member, f"{member} holds {braced!r}; only {SIDE} has a meaning"
                )


# The members that all measurements and rules have describe them to a reader; the others say what is
# measured.
_DESCRIPTIVE = {*MeasurementDefinition.__struct_fields__, *LandmarkRule.__struct_fields__}


def _side_faults(definition: Entry, named: str) -> Iterator[Fault]:
    """Refuse ``{side}`` unless it is in the label, the name and what is measured."""
    label = definition.label
    sided = [member for member, text in texts(definition) if SIDE in text]
    places = [member for member in sided if member not in _DESCRIPTIVE]
    if SIDE not in named:
        if sided:
            yield Fault(
                definition,
                sided[0],
                f"{sided[0]} has {SIDE}, but the {label} {named!r} has not, so that left and right "
                f"could not be distinguished; write it in both, such as '{named}_{SIDE}'"
                if label == "key"
                else f"{sided[0]} has {SIDE}, but the name {named!r} has not; write it in both, "
                f"such as '{named} {SIDE}'",
            )
    elif not places and not isinstance(definition, GivenMeasure):  # Its key is what is measured.
        yield Fault(
            definition,
            label,
            f"the {label} {named!r} has {SIDE}, but nothing that is measured has, so that left and "
            "right would be the same; write it in a landmark too, or leave it out",
        )
    elif "name" not in sided:
        yield Fault(
            definition,
            "name",
            f"the key {named!r} has {SIDE}, but the name has not, so that left and right would be "
            "called the same; write it in both",
        )


def _repeated(definitions: Sequence[Entry]) -> Iterator[Fault]:
    """Refuse two entries that are known by the same name."""
    seen: dict[str, str] = {}
    for definition in definitions:
        label = definition.label
        written = getattr(definition, label)
        for one in both_sides([definition]):
            name = getattr(one, label)
            if name in seen:
                also = "" if seen[name] == written else f" (as {seen[name]!r} gives it)"
                yield Fault(
                    definition,
                    label,
                    f"the {label} {name!r} is there twice{also}; rename or remove one of the two",
                )
            seen[name] = written
