"""Records as files for programs: JSON, JSON Schema and CSV."""

import csv
import io
from collections.abc import Iterable, Sequence
from typing import Any

import msgspec
from msgspec import UNSET, Struct


def to_json(document: Struct) -> bytes:
    """Return a document as JSON, one member of each of its lists a line; every float round-trips.

    Parameters
    ----------
    document : Struct
        Such as `Document`, `ChartDocument` or `Comparison`.
    """
    members = []
    for field in document.__struct_fields__:
        value = getattr(document, field)
        if value is UNSET:
            continue
        content = _lines(value) if isinstance(value, list) else msgspec.json.encode(value)
        members.append(msgspec.json.encode(field) + b": " + content)
    return b"{\n" + b",\n".join(members) + b"\n}\n"


def _lines(items: Sequence[Any]) -> bytes:
    if not items:
        return b"[]"
    return b"[\n" + b",\n".join(msgspec.json.encode(item) for item in items) + b"\n]"


def indented_json(content: Any) -> bytes:
    """Return an object as JSON that people read, too; every float round-trips."""
    return msgspec.json.format(msgspec.json.encode(content), indent=1) + b"\n"


def json_schema(kind: type[Struct]) -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of a kind of document.

    Parameters
    ----------
    kind : type of Struct
        A kind of document that names itself in a field ``schema``.
    """
    title = next(field.default for field in msgspec.structs.fields(kind) if field.name == "schema")
    draft = "https://json-schema.org/draft/2020-12/schema"
    return {"$schema": draft, "title": title, **msgspec.json.schema(kind)}


def schema_bytes(kind: type[Struct]) -> bytes:
    """Return the JSON Schema of a kind of document as a file that people read, too."""
    return msgspec.json.format(msgspec.json.encode(json_schema(kind)), indent=2) + b"\n"


def csv_bytes(columns: Sequence[str], rows: Iterable[Iterable[object]]) -> bytes:
    """Return a table as CSV (RFC 4180, UTF-8) with a header row; every float round-trips.

    None is written as an empty field.
    """
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\r\n")
    writer.writerow(columns)
    writer.writerows(rows)
    return text.getvalue().encode()


def fields_set(kind: type[Struct], records: Iterable[Struct]) -> tuple[str, ...]:
    """Return the fields of records but for those that none of them has."""
    every = list(records)
    optional = [f.name for f in msgspec.structs.fields(kind) if f.default is UNSET]
    absent = {name for name in optional if all(getattr(each, name) is UNSET for each in every)}
    return tuple(name for name in kind.__struct_fields__ if name not in absent)


def records_csv(kind: type[Struct], records: Iterable[Struct]) -> bytes:
    """Return records of one kind as CSV, whose columns are their fields."""
    columns = kind.__struct_fields__
    return csv_bytes(columns, ([getattr(record, c) for c in columns] for record in records))
