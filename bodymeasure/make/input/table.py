"""Tables of sizes: one row for each size, the measurements as columns."""

import csv
import io
import re
from pathlib import Path

from bodymeasure.arguments import repeated
from bodymeasure.atlas import Unit
from bodymeasure.compare.read import header_of, table_text
from bodymeasure.errors import InputError
from bodymeasure.make.input.json_files import value_of
from bodymeasure.make.input.measurements import Measurements, Value
from bodymeasure.make.input.names import Names
from bodymeasure.make.input.numbers import parsed
from bodymeasure.report.units import DEGREES

# The first column of a table of sizes.
SIZE = ("size", "sizes", "name", "subject")
# The unit of a column, as in "waist_girth (cm)".
_UNIT = re.compile(
    r"(?P<text>.*?)\s*[(\[]\s*(?P<unit>m|cm|mm|inch|in|deg)\s*[)\]]\s*", re.IGNORECASE
)


def is_size_table(content: bytes) -> bool:
    """Return whether a CSV file is a table of sizes: it begins with them, and has no values."""
    try:
        text, delimiter = table_text(content, Path())
        header = header_of(csv.reader(io.StringIO(text, newline=""), delimiter=delimiter))
    except (InputError, csv.Error):
        return False
    cells = [cell.strip().casefold() for cell in header]
    return bool(cells) and cells[0] in SIZE and "value" not in cells


def measurements_of_table(
    content: bytes, path: Path, names: Names, unit: str | None
) -> tuple[Measurements, ...]:
    """Return the measurements of each size of a table.

    Parameters
    ----------
    content : bytes
        CSV, in which a column's name is a key or a name of the chart, with its unit in brackets
        unless all have the same.
    path : Path
    names : Names
    unit : str or None
        Unit of the columns that say none.

    Raises
    ------
    InputError
        If the table is not as expected.
    """
    text, delimiter = table_text(content, path)
    table = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
    found: dict[str, Measurements] = {}
    try:
        header = header_of(table)
        while header and not header[-1].strip():
            # Programs write the empty columns beside a table.
            header.pop()
        columns = [_column(cell, names, path, unit) for cell in header[1:]]
        keys = [key for key, _ in columns]
        if (twice := repeated(keys)) is not None:
            raise InputError(f"{path}, line 1: {twice!r} has two columns; keep one")
        for row in table:
            if not any(cell.strip() for cell in row):
                continue
            place = f"{path}, line {table.line_num}"
            if any(cell.strip() for cell in row[len(header) :]):
                raise InputError(
                    f"{place}: has more cells than the header has columns; if a comma is a decimal "
                    "point, separate the columns by semicolons"
                )
            name = row[0].strip()
            if not name or name in found:
                what = f"size {name!r} comes a second time" if name else "the size has no name"
                raise InputError(f"{place}: {what}; give each size a name of its own")
            found[name] = Measurements(name, _row(row, columns, place, names))
    except csv.Error as error:
        raise InputError(f"{path}, line {table.line_num}: is not CSV ({error})") from None
    if not found:
        raise InputError(f"{path}: holds no size; expected one a line below the header")
    return tuple(found.values())


def _column(cell: str, names: Names, path: Path, unit: str | None) -> tuple[str, str]:
    form = _UNIT.fullmatch(cell.strip())
    text, said = (form["text"], form["unit"].casefold()) if form else (cell.strip(), None)
    key = names.find(text, f"{path}, line 1")
    own = {"in": "inch"}.get(said, said) if said else unit
    if names.by_key[key].in_degrees:
        own = own if said else DEGREES
    if own is None:
        raise InputError(
            f"{path}, line 1: the column {text!r} has no unit, and none is guessed; write "
            f"'{text} (cm)', or give --unit"
        )
    if own != DEGREES:
        Unit.parse(own)
    return key, own


def _row(
    row: list[str], columns: list[tuple[str, str]], place: str, names: Names
) -> tuple[Value, ...]:
    values = []
    for cell, (key, unit) in zip(row[1:], columns, strict=False):
        if cell.strip():
            number, own = parsed(cell, unit, f"{place}: {key}")
            values.append(value_of(key, number, own, f"{place}: {key}", names))
    return tuple(values)
