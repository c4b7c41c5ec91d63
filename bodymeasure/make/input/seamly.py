"""Measurement files of SeamlyMe (``.smis``) and of Valentina's Tape (``.vit``)."""

import re
from pathlib import Path
from xml.etree import ElementTree

from bodymeasure.atlas import Unit
from bodymeasure.chart.formula.parse import parse_formula
from bodymeasure.chart.formula.value import Estimate, evaluate_formula
from bodymeasure.errors import InputError
from bodymeasure.make.input.measurements import Measurements, Value
from bodymeasure.make.input.names import Names
from bodymeasure.report.units import DEGREES
from bodymeasure.wording import counted

ROOTS = ("smis", "vit")
# The files of both programs that hold a table of sizes, of which each needs one value.
MULTISIZE = ("smms", "vst")
NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)", re.ASCII)
# Formulas may name measurements that are formulas in turn, up to so many times.
DEEPEST = 20
# The names that a note lists; the others are counted.
NAMED = 6


def measurements_of_seamly(content: bytes, path: Path, names: Names) -> Measurements:
    """Return the measurements of a file of SeamlyMe or of Valentina.

    Raises
    ------
    InputError
        If it is no such file.
    """
    root = _root(content, path)
    unit = _unit(root, path)
    written: dict[str, str] = {}
    for element in root.iterfind("body-measurements/m"):
        name, text = element.get("name", ""), element.get("value", "").strip()
        if name and written.setdefault(name, text) != text:
            raise InputError(
                f"{path}: {name} is {written[name]!r} and, a second time, {text!r}; keep one"
            )
    values: dict[str, Value] = {}
    unknown, unread = [], []
    for name in written:
        number = _number(name, written, 0)
        key = names.seamly.get(name)
        if number == 0.0:
            # What was not measured.
            continue
        if key is None:
            unknown.append(name)
        elif number is None:
            unread.append(f"{name} ({written[name]!r})")
        elif key not in values:
            own = DEGREES if names.by_key[key].in_degrees else unit.value
            if number < 0.0 and own != DEGREES:
                raise InputError(f"{path}: {name} is {written[name]}; expected a length above zero")
            values[key] = Value(key, number, own, f"{path}: {name}")
    notes = []
    if unknown:
        notes.append(f"{path.name}: the chart has no {_listed(unknown)}; left out")
    if unread:
        notes.append(f"{path.name}: not a number or a formula: {_listed(unread)}; left out")
    gender = (root.findtext("personal/gender") or root.findtext("personal/sex") or "").strip()
    sex = gender if gender in ("female", "male") else None
    return Measurements(path.stem, tuple(values.values()), sex, tuple(notes))


class _EntitiesError(Exception):
    """A file has a document type, in which entities are defined."""


class _Plain(ElementTree.TreeBuilder):
    """Builds the tree of a file without a document type, in whatever encoding it is."""

    def doctype(self, *_given: object) -> None:
        """Refuse a document type, before the entities that it defines are used."""
        raise _EntitiesError


def _root(content: bytes, path: Path) -> ElementTree.Element:
    try:
        root = ElementTree.fromstring(content, ElementTree.XMLParser(target=_Plain()))
    except _EntitiesError:
        raise InputError(
            f"{path}: defines entities, which no file of SeamlyMe does; remove them"
        ) from None
    except (ElementTree.ParseError, ValueError) as error:
        raise InputError(f"{path}: is not XML ({error}); expected a file of SeamlyMe") from None
    if root.tag in MULTISIZE:
        raise InputError(
            f"{path}: is a multisize file, a table of sizes; expected an individual one: in "
            "SeamlyMe, export one size, or write the table as CSV, one row for each size"
        )
    if root.tag not in ROOTS:
        raise InputError(
            f"{path}: begins with <{root.tag}>; expected <smis>, as SeamlyMe writes it, or <vit>"
        )
    return root


def _unit(root: ElementTree.Element, path: Path) -> Unit:
    said = (root.findtext("unit") or "").strip()
    if said not in ("mm", "cm", "inch"):
        raise InputError(f"{path}: the unit is {said!r}; expected mm, cm or inch")
    return Unit.parse(said)


def _number(name: str, written: dict[str, str], depth: int) -> float | None:
    """Return the value of a measurement, None if it cannot be understood; 0 if it is empty."""
    text = written.get(name)
    if text is None or depth > DEEPEST:
        return None
    if not text:
        return 0.0
    if NUMBER.fullmatch(text):
        return float(text.replace(",", "."))
    try:
        formula = parse_formula(text)
        operands = {one: _number(one, written, depth + 1) for one in formula.names}
        known = {one: Estimate(value, 0.0) for one, value in operands.items() if value is not None}
        return evaluate_formula(formula, known).value if len(known) == len(operands) else None
    except (InputError, KeyError, RecursionError):
        return None


def _listed(names: list[str]) -> str:
    more = len(names) - NAMED
    listed = ", ".join(names[:NAMED])
    return listed if more <= 0 else f"{listed} and {counted(more, 'more', 'more')}"
