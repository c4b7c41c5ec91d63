"""Reading values to compare from files: the JSON of a chart, or CSV typed by hand."""

import csv
import io
import math
import re
from collections.abc import Iterator
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
NEEDED = ("measurement", "value")
# The first of these that the header contains is taken.
DELIMITERS = ("\t", ";", ",")
PLAIN_NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?", re.IGNORECASE | re.ASCII)
TAILORS_FRACTION = re.compile(r"(\d+\s+)?\d+/0*[1-9]\d*", re.ASCII)
UNITS = (*(unit.value for unit in Unit), DEGREES)
# Other ways of writing them.
SPELLINGS = {"in": "inch", "inches": "inch", '"': "inch", "\u2033": "inch", "\u00b0": DEGREES}
# A value with its unit behind it, as in "94 cm"; the unit is told from the end of a fraction.
WITH_UNIT = re.compile(
    r"(?P<number>.*[\d.,])\s*(?P<unit>m|cm|mm|inch|inches|in|deg|\"|\u2033|\u00b0)", re.IGNORECASE
)
# The line by which Excel is told what separates columns.
SEPARATOR = re.compile(r"sep=(?P<delimiter>[\t;,])\s*", re.IGNORECASE)


def read_readings(path: Path, unit: str | None = None) -> Readings:
    """Return the values of a file, by its extension.

    They are a chart's ``.json``, a survey's ``.parquet``, or ``.csv``.

    A CSV file has the columns ``measurement`` (key or name), ``value`` and ``unit`` (m, cm, mm,
    inch, deg), and may have ``subject`` and ``error``. Values may hold their units, as in
    ``94 cm``, in place of the column. Tabs and semicolons may be used in place of commas; then a
    comma may be a decimal point. Inches may have fractions, such as ``33 1/8``. A line without a
    value means that there is none.

    Parameters
    ----------
    path : Path
    unit : {"m", "cm", "mm", "inch"}, optional
        Unit of the values of a CSV file that say none; never guessed.

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
    return Readings(path.name, tuple(_rows(content, path, unit)))


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


def table_text(content: bytes, path: Path) -> tuple[str, str]:
    """Return the text of a CSV file, and what separates its columns.

    The line ``sep=;``, which Excel heeds and hides, is emptied, so that lines keep their numbers.

    Raises
    ------
    InputError
        If it is not text.
    """
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"{path}: is not text in UTF-8; save the table in that encoding") from None
    first, newline, rest = text.partition("\n")
    said = SEPARATOR.fullmatch(first)
    if said is not None:
        return newline + rest, said["delimiter"]
    header = next((line for line in text.split("\n") if line.strip()), "")
    return text, next((each for each in DELIMITERS if each in header), ",")


def header_of(table: Iterator[list[str]]) -> list[str]:
    """Return the first row of a table that is not empty."""
    return next((row for row in table if any(cell.strip() for cell in row)), [])


def _rows(content: bytes, path: Path, own: str | None) -> list[Reading]:
    text, delimiter = table_text(content, path)
    table = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
    readings = []
    try:
        cells = header_of(table)
        columns = _columns(cells, f"{path}, line {max(table.line_num, 1)}")
        for row in table:
            if any(cell.strip() for cell in row):
                place = f"{path}, line {table.line_num}"
                _check_width(row, len(cells), place)
                readings.append(_reading(row, columns, place, delimiter, own))
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


def _columns(header: list[str], place: str) -> dict[str, int]:
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
            f"{place}: has no column {' and no column '.join(map(repr, missing))}; expected a "
            "header with measurement, value, unit, and subject if there are several"
        )
    return columns


def _reading(
    row: list[str], columns: dict[str, int], place: str, delimiter: str, own: str | None
) -> Reading:
    def cell(column: str) -> str:
        at = columns.get(column)
        return row[at].strip() if at is not None and at < len(row) else ""

    value, unit = _value_and_unit(cell("value"), cell("unit"), place, own)
    error = cell("error")
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


def _value_and_unit(text: str, said: str, place: str, own: str | None) -> tuple[str, str]:
    """Return a value without its unit, and the unit that it or the row says."""
    unit = _spelled(said)
    within = WITH_UNIT.fullmatch(text)
    if within is not None:
        text, behind = within["number"].strip(), _spelled(within["unit"])
        if unit and unit != behind:
            raise InputError(
                f"{place}: the value is in {behind} and the column unit says {said}; keep one"
            )
        unit = behind
    if not unit and not text:
        # An empty line of a form; what its unit would be does not matter.
        return "", own or Unit.CM.value
    unit = unit or own or ""
    if unit not in UNITS:
        what = f"unknown unit {said!r}" if said else "no unit, and none is guessed"
        raise InputError(f"{place}: {what}; expected one of {', '.join(UNITS)}")
    return text, unit


def _spelled(unit: str) -> str:
    plain = unit.casefold()
    return SPELLINGS.get(plain, plain)


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
