"""Reading values to compare from files: the JSON of a chart, or CSV typed by hand."""

import csv
import io
import math
import re
from fractions import Fraction
from pathlib import Path

import msgspec

from bodymeasure.atlas import Unit
from bodymeasure.chart import MeasurementDefinition
from bodymeasure.chart.kinds import KINDS
from bodymeasure.compare.readings import Reading, Readings, readings_of, readings_of_subjects
from bodymeasure.compare.surveyed import survey_readings
from bodymeasure.errors import InputError
from bodymeasure.files import read_bytes
from bodymeasure.report.body.records import SCHEMA, ChartDocument
from bodymeasure.report.population.records import SCHEMA as SEVERAL
from bodymeasure.report.population.records import PopulationDocument
from bodymeasure.report.units import DEGREES

# The columns, each with the names that it may have, among them those of a chart's CSV.
COLUMNS = {
    "measurement": ("measurement", "key", "name"),
    "value": ("value",),
    "unit": ("unit",),
    "subject": ("subject",),
    "error": ("error_estimate", "error"),
    "reason": ("reason",),
    "kind": ("kind",),
}
NEEDED = ("measurement", "value", "unit")
# The first of these that the header contains is taken.
DELIMITERS = ("\t", ";", ",")
PLAIN_NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?", re.IGNORECASE | re.ASCII)
TAILORS_FRACTION = re.compile(r"(\d+\s+)?\d+/0*[1-9]\d*", re.ASCII)
UNITS = (*(unit.value for unit in Unit), DEGREES)


def read_readings(path: Path) -> Readings:
    """Return the values of a file, by its extension.

    They are a chart's ``.json``, a survey's ``.parquet``, or ``.csv``.

    A CSV file has the columns ``measurement`` (key or name), ``value`` and ``unit`` (m, cm, mm,
    inch, deg), and may have ``subject`` and ``error``. Tabs and semicolons may be used in place of
    commas; then a comma may be a decimal point. Inches may have fractions, such as ``33 1/8``. A
    line without a value means that there is none.

    Raises
    ------
    InputError
        If the file is not as expected; the message gives file, line and what to do.
    """
    if path.suffix.lower() == ".parquet":
        return survey_readings(path)
    content = read_bytes(path)
    if path.suffix.lower() == ".json":
        found = _charts(content, path)
        if isinstance(found, ChartDocument):
            return readings_of(found)
        return readings_of_subjects(path.name, found.subjects, found.charts)
    return Readings(path.name, tuple(_rows(content, path)))


class _Head(msgspec.Struct):
    """What kind of file it is; the other members are left out."""

    schema: str = ""


def _charts(content: bytes, path: Path) -> ChartDocument | PopulationDocument:
    try:
        schema = msgspec.json.decode(content, type=_Head).schema
        if schema == SEVERAL:
            return msgspec.json.decode(content, type=PopulationDocument)
        return msgspec.json.decode(content, type=ChartDocument)
    except msgspec.DecodeError as error:
        raise InputError(
            f"{path}: is not the measurements.json of a chart ({error}); expected the schema "
            f"{SCHEMA!r}, as `bodymeasure chart -o` writes it"
        ) from None


def _rows(content: bytes, path: Path) -> list[Reading]:
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"{path}: is not text in UTF-8; save the table in that encoding") from None
    header = text.partition("\n")[0]
    delimiter = next((each for each in DELIMITERS if each in header), ",")
    table = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter)
    readings = []
    try:
        cells = next(table, [])
        columns = _columns(cells, path)
        for row in table:
            if any(cell.strip() for cell in row):
                place = f"{path}, line {table.line_num}"
                _check_width(row, len(cells), place)
                readings.append(_reading(row, columns, place, delimiter))
    except csv.Error as error:
        raise InputError(f"{path}, line {table.line_num}: is not CSV ({error})") from None
    if not readings:
        raise InputError(f"{path}: holds no measurement; expected one a line below the header")
    return readings


def _check_width(row: list[str], count: int, place: str) -> None:
    """Refuse cells beyond the columns of the header, such as what a decimal comma cuts off."""
    beyond = [cell for cell in row[count:] if cell.strip()]
    if beyond:
        raise InputError(
            f"{place}: has {beyond[0]!r} beyond the last column of the header; if a comma is a "
            "decimal point, separate the columns by semicolons"
        )


def _columns(header: list[str], path: Path) -> dict[str, int]:
    """Return the place of each column in a row."""
    given = [cell.strip().casefold() for cell in header]
    columns = {
        column: next(given.index(name) for name in names if name in given)
        for column, names in COLUMNS.items()
        if any(name in given for name in names)
    }
    missing = [column for column in NEEDED if column not in columns]
    if missing:
        raise InputError(
            f"{path}, line 1: has no column {' and no column '.join(map(repr, missing))}; expected "
            f"a header with {', '.join(NEEDED)}, and subject if there are several"
        )
    return columns


def _reading(row: list[str], columns: dict[str, int], place: str, delimiter: str) -> Reading:
    def cell(column: str) -> str:
        at = columns.get(column)
        return row[at].strip() if at is not None and at < len(row) else ""

    unit = cell("unit")
    if unit not in UNITS:
        what = f"unknown unit {unit!r}" if unit else "no unit, and none is guessed"
        raise InputError(f"{place}: {what}; expected one of {', '.join(UNITS)}")
    value, error = cell("value"), cell("error")
    decimal_comma = delimiter != ","
    number = _number(value, unit, decimal_comma, place) if value else None
    kind = KINDS.get(cell("kind"), MeasurementDefinition)
    if number is not None and number <= 0.0 and unit != DEGREES and not kind.may_be_negative:
        raise InputError(
            f"{place}: {value!r} is no length; expected one above zero, or an empty cell"
        )
    bound = _number(error, unit, decimal_comma, place) if error else None
    if bound is not None and bound < 0.0:
        raise InputError(f"{place}: {error!r} is no error; expected zero or more")
    return Reading(
        subject=cell("subject"),
        measurement=cell("measurement"),
        value=number,
        unit=unit,
        error=bound,
        reason=cell("reason") or "no value is given",
        place=place,
    )


def _number(text: str, unit: str, decimal_comma: bool, place: str) -> float:
    plain = text.replace(",", ".") if decimal_comma else text
    number = math.nan
    if unit == Unit.INCH and TAILORS_FRACTION.fullmatch(plain):
        number = float(sum(Fraction(word) for word in plain.split()))
    elif PLAIN_NUMBER.fullmatch(plain):
        number = float(plain)
    if not math.isfinite(number):
        raise InputError(f"{place}: {text!r} is not a number; expected one such as 91.5")
    return number
