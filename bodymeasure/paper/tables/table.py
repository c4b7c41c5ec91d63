"""A table: the content of `tables.json`, `tables.csv` and the page."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from operator import attrgetter
from typing import Any, Literal, Self

import numpy as np

from bodymeasure.report.serial import csv_bytes

# The kinds of values: words, a count, a number, a length in the unit of the patches; a ratio shown
# in percent with its sign, to three decimals, in percent without a sign, or as a power of ten;
# seconds, and a factor.
Kind = Literal[
    "text", "count", "number", "length", "percent", "fine", "share", "small", "seconds", "factor"
]
Value = str | int | float | bool | None


@dataclass(frozen=True)
class Column:
    """A column of a table.

    Parameters
    ----------
    name : str
        Its key in the files.
    label : str
        Its heading.
    kind : Kind
        How its values are to be read.
    value : callable, optional
        Gives the value of a row from the item that the row is about (see `Table.of`); by default,
        the item's attribute of the column's name.
    is_timing : bool
        Whether the values are measured times, or made of them: they differ from run to run, while
        all others do not.
    """

    name: str
    label: str
    kind: Kind = "text"
    value: Callable[[Any], Any] | None = field(default=None, compare=False)
    is_timing: bool = False


@dataclass(frozen=True)
class Table:
    """Rows of values, None where there is no value.

    Parameters
    ----------
    name : str
        Unique, for programs.
    title : str
    columns : tuple of Column
    rows : tuple of tuple
    notes : tuple of str
        What a reader has to know.
    """

    name: str
    title: str
    columns: tuple[Column, ...]
    rows: tuple[tuple[Value, ...], ...]
    notes: tuple[str, ...] = ()

    @classmethod
    def of(
        cls, name: str, title: str, columns: Sequence[Column], items: Iterable[Any], *notes: str
    ) -> Self:
        """Return a table with a row for each item, in which each column gives its value."""
        values = [column.value or attrgetter(column.name) for column in columns]
        rows = tuple(tuple(plain(value(item)) for value in values) for item in items)
        return cls(name, title, tuple(columns), rows, notes)

    @property
    def records(self) -> list[dict[str, Any]]:
        """The rows, each by the names of the columns."""
        names = [column.name for column in self.columns]
        return [dict(zip(names, row, strict=True)) for row in self.rows]


def plain(value: Any) -> Value:
    """Return a value as files hold it: a number of Python's, or None for one that is not finite."""
    if isinstance(value, np.generic | np.ndarray):
        value = value.item()
    if isinstance(value, float) and not np.isfinite(value):
        return None
    result: Value = value
    return result


def to_record(table: Table) -> dict[str, Any]:
    """Return a table for JSON, in which each row is an object."""
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
    """Return all tables as one CSV file, with a line for each value: table, row, column, value."""
    return csv_bytes(
        ("table", "row", "column", "value", "timing"),
        (
            (table.name, number, column.name, value, int(column.is_timing))
            for table in tables
            for number, row in enumerate(table.rows)
            for column, value in zip(table.columns, row, strict=True)
        ),
    )
