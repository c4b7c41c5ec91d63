"""A table: what `tables.json`, `tables.csv` and the page show."""

import csv
import io
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

# How a number is to be read: a length in the unit of the patches; a ratio that is shown in percent
# with its sign, to three decimals, in percent without a sign, or as a power of ten; seconds, a
# factor, a count, or words.
Kind = Literal[
    "text", "count", "number", "length", "percent", "fine", "share", "small", "seconds", "factor"
]
Value = str | int | float | bool | None


@dataclass(frozen=True)
class Column:
    """A column: its key in the files, its heading, and how its values are to be read.

    `is_timing` marks values that are measured times, or made of them: they differ from run to run,
    all others do not.
    """

    name: str
    label: str
    kind: Kind = "text"
    is_timing: bool = False


@dataclass(frozen=True)
class Table:
    """Rows of values, None where there is none.

    Parameters
    ----------
    name : str
        Unique, for programs.
    title : str
    columns : tuple of Column
    rows : tuple of tuple
    notes : tuple of str
        What to know for reading it.
    """

    name: str
    title: str
    columns: tuple[Column, ...]
    rows: tuple[tuple[Value, ...], ...]
    notes: tuple[str, ...] = ()

    @property
    def records(self) -> list[dict[str, Any]]:
        """The rows, each by the names of the columns."""
        names = [column.name for column in self.columns]
        return [dict(zip(names, row, strict=True)) for row in self.rows]


def plain(value: Any) -> Value:
    """A single value as files hold it: numbers as Python has them, None for what is not finite."""
    if isinstance(value, np.generic | np.ndarray):
        value = value.item()
    if isinstance(value, float) and not np.isfinite(value):
        return None
    result: Value = value
    return result


def rows_of(values: Iterable[Sequence[Any]]) -> tuple[tuple[Value, ...], ...]:
    """Rows of plain values."""
    return tuple(tuple(plain(value) for value in row) for row in values)


def to_record(table: Table) -> dict[str, Any]:
    """A table for JSON, each row an object."""
    return {
        "title": table.title,
        "columns": [
            {"name": c.name, "label": c.label, "kind": c.kind, "timing": c.is_timing}
            for c in table.columns
        ],
        "rows": table.records,
        "notes": list(table.notes),
    }


def to_csv(tables: Sequence[Table]) -> bytes:
    """All tables in one file (RFC 4180, UTF-8), a value a line: table, row, column, value."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\r\n")
    writer.writerow(("table", "row", "column", "value", "timing"))
    for table in tables:
        for number, row in enumerate(table.rows):
            for column, value in zip(table.columns, row, strict=True):
                shown = "" if value is None else value
                writer.writerow((table.name, number, column.name, shown, int(column.is_timing)))
    return text.getvalue().encode()
