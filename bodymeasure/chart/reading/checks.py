"""What has to hold for a set of definitions beyond the types of its members."""

import re
import unicodedata
from collections.abc import Iterator, Sequence
from itertools import pairwise

import msgspec

from bodymeasure.chart.formula.checks import Fault, formula_faults
from bodymeasure.chart.formula.parse import FUNCTIONS
from bodymeasure.chart.kinds.definitions import (
    ChordMeasure,
    Definitions,
    GirthArcMeasure,
    GirthMeasure,
    HeightMeasure,
    LimbGirthMeasure,
    Measurement,
    PathMeasure,
)
from bodymeasure.chart.landmarks.rules import Between, LandmarkRule
from bodymeasure.chart.reading.sides import SIDE, both_sides, texts

_KEY = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_BRACED = re.compile(r"\{[^{}]*\}|[{}]")


def first_fault(definitions: Definitions) -> Fault | None:
    """The first thing that is wrong with a set; None if nothing is."""
    return next(_faults(definitions), None)


def _faults(definitions: Definitions) -> Iterator[Fault]:
    for rule in definitions.landmark:
        yield from _rule_faults(rule)
    for measurement in definitions.measurement:
        yield from _measurement_faults(measurement)
    yield from _repeated(definitions.landmark, "name")
    yield from _repeated(definitions.measurement, "key")
    yield from formula_faults(definitions.measurement)


def _rule_faults(rule: LandmarkRule) -> Iterator[Fault]:
    yield from _text_faults(rule)
    yield from _side_faults(rule, "name", rule.name)
    if isinstance(rule, Between) and not 0.0 <= rule.fraction <= 1.0:
        yield Fault(rule, "fraction", f"fraction is {rule.fraction}; expected 0 to 1")


def _measurement_faults(measurement: Measurement) -> Iterator[Fault]:
    yield from _text_faults(measurement)
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
    yield from _side_faults(measurement, "key", measurement.key)
    match measurement:
        case PathMeasure(through=through) if len(through) < 2:
            yield Fault(measurement, "through", "through needs two landmarks or more")
        case PathMeasure(through=through):
            for one, other in pairwise(through):
                yield from _one_place(measurement, "through", one, other)
        case ChordMeasure(start=start, end=end) | GirthArcMeasure(start=start, end=end):
            yield from _one_place(measurement, "end", start, end)
        case HeightMeasure(at=at, above=above):
            yield from _one_place(measurement, "above", at, above)
        case GirthMeasure(cut=cut, limb=True) if cut is not None:
            yield Fault(measurement, "cut", "cut is for the trunk, limb for a leg or arm; give one")
        case LimbGirthMeasure(at=float() as at) if not 0.0 <= at <= 1.0:
            yield Fault(measurement, "at", f"at is {at}; expected 0 to 1, or a landmark's name")


def _one_place(
    measurement: Measurement, member: str, one: str, other: str | None
) -> Iterator[Fault]:
    """A slip that would be measured as 0."""
    if one == other:
        yield Fault(
            measurement,
            member,
            f"leads from {one!r} to the same landmark, which is 0 on every body; name two",
        )


# Words may be left out; everything else that is text names something.
_MAY_BE_EMPTY = ("words", "group", "iso")


def _text_faults(definition: msgspec.Struct) -> Iterator[Fault]:
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


# Members of measurements and rules that tell a reader something, and name no place on the body.
_TELLING = ("key", "name", "words", "group", "iso", "seamly", "freesewing")


def _side_faults(definition: msgspec.Struct, label: str, named: str) -> Iterator[Fault]:
    """``{side}`` stands in the label and the name, and in what is measured, or nowhere."""
    sided = [member for member, text in texts(definition) if SIDE in text]
    places = [member for member in sided if member not in _TELLING]
    if SIDE not in named:
        if sided:
            yield Fault(
                definition,
                sided[0],
                f"{sided[0]} has {SIDE}, but the {label} {named!r} has not, so that left and right "
                f"could not be told apart; write it in both, such as '{named}_{SIDE}'"
                if label == "key"
                else f"{sided[0]} has {SIDE}, but the name {named!r} has not; write it in both, "
                f"such as '{named} {SIDE}'",
            )
    elif not places:
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


def _repeated(definitions: Sequence[msgspec.Struct], label: str) -> Iterator[Fault]:
    seen: dict[str, str] = {}
    for definition in definitions:
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
