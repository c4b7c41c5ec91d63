"""Records as files for programs: JSON, CSV and JSON Schema."""

import csv
import io
from collections.abc import Iterable, Sequence
from typing import Any

import msgspec
from msgspec import Struct


def struct_schema(kind: type[Struct], title: str) -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of a kind of document."""
    schema = msgspec.json.schema(kind)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": title, **schema}


def schema_bytes(schema: dict[str, Any]) -> bytes:
    """A schema as a file that people read, too."""
    return msgspec.json.format(msgspec.json.encode(schema), indent=2) + b"\n"


def json_bytes(document: Struct) -> bytes:
    """A document as JSON, one member of each of its lists a line; every float round-trips."""
    members = []
    for field in document.__struct_fields__:
        value = getattr(document, field)
        content = _lines(value) if isinstance(value, list) else msgspec.json.encode(value)
        members.append(msgspec.json.encode(field) + b": " + content)
    return b"{\n" + b",\n".join(members) + b"\n}\n"


def _lines(items: Sequence[Any]) -> bytes:
    if not items:
        return b"[]"
    return b"[\n" + b",\n".join(msgspec.json.encode(item) for item in items) + b"\n]"


def csv_bytes(columns: Sequence[str], rows: Iterable[Sequence[object]]) -> bytes:
    """A table as CSV (RFC 4180, UTF-8) with a header row; every float round-trips.

    None is an empty field.
    """
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\r\n")
    writer.writerow(columns)
    writer.writerows(rows)
    return text.getvalue().encode()
