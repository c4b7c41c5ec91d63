"""A chart as a measurement file of SeamlyMe and Seamly2D (``.smis``, schema 0.3.4)."""

import re
from typing import Final
from xml.etree import ElementTree

from bodymeasure.atlas import Unit, convert_length
from bodymeasure.report.body.codes import check_seamly_name, measured_by_code
from bodymeasure.report.body.records import BodyRecord, ChartDocument
from bodymeasure.report.units import DEGREES, PATTERN_DECIMALS

SCHEMA_VERSION: Final = "0.3.4"
# The number for no particular pattern making system, and the date that SeamlyMe writes if none is
# known.
NO_SYSTEM: Final = "998"
NO_BIRTH_DATE: Final = "1800-01-01"

# Characters that XML 1.0 cannot hold.
_UNWRITABLE = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def to_smis(document: ChartDocument) -> bytes:
    """Return the measurements that Seamly2D has names for, as its measurement file.

    Where a measurement is taken on both sides, the wearer's right one is written. Those without a
    value are left out. Meters are written as centimeters, since the format has no unit for meters.

    Parameters
    ----------
    document : ChartDocument

    Raises
    ------
    InputError
        If a name is one that such a file cannot hold.
    """
    unit = smis_unit(document.unit)
    root = ElementTree.Element("smis")
    _add(root, "version", SCHEMA_VERSION)
    _add(root, "read-only", "false")
    _add(root, "notes", _notes(document))
    _add(root, "unit", unit.value)
    _add(root, "pm_system", NO_SYSTEM)
    personal = _add(root, "personal")
    _add(personal, "family-name")
    _add(personal, "given-name")
    _add(personal, "birth-date", NO_BIRTH_DATE)
    _add(personal, "gender", "unknown")
    _add(personal, "email")
    measurements = _add(root, "body-measurements")
    for name, record in measured_by_code(document.measurements, lambda m: m.seamly).items():
        check_seamly_name(name, record.key)
        ElementTree.SubElement(measurements, "m", name=name, value=_value(record, unit))
    ElementTree.indent(root, "    ")
    body = ElementTree.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{body}\n'.encode()


def smis_unit(unit: str) -> Unit:
    """Return the unit in which a chart is written: its own, or centimeters for meters."""
    parsed = Unit.parse(unit)
    return Unit.CM if parsed is Unit.M else parsed


def _add(parent: ElementTree.Element, tag: str, text: str = "") -> ElementTree.Element:
    element = ElementTree.SubElement(parent, tag)
    if text:
        element.text = _UNWRITABLE.sub("\N{REPLACEMENT CHARACTER}", text)
    return element


def _notes(document: ChartDocument) -> str:
    version = document.versions.get("bodymeasure", "")
    return (
        f"{document.name or 'A body'}, measured by bodymeasure {version}".rstrip()
        + f", {document.created}. Where both sides were measured, the wearer's right one."
    )


def _value(record: BodyRecord, unit: Unit) -> str:
    assert record.value is not None
    # Values are formulas to Seamly2D, which plain decimals are, too.
    if record.unit == DEGREES:
        return f"{record.value:.{PATTERN_DECIMALS[DEGREES]}f}"
    length = convert_length(record.value, Unit.parse(record.unit), unit)
    return f"{length:.{PATTERN_DECIMALS[unit]}f}"
