"""What a chart's ``measurements.json`` and ``measurements.csv`` hold, and their schema."""

from collections.abc import Sequence
from typing import Annotated, Any, Final, Literal

from msgspec import Meta, Struct

from bodymeasure.report.serial import csv_bytes, json_bytes, struct_schema

SCHEMA: Final = "bodymeasure chart"
VERSION: Final = 1

LengthUnit = Literal["m", "cm", "mm", "inch"]
DEGREES: Final = "deg"
ValueUnit = Literal["m", "cm", "mm", "inch", "deg"]


class BodyMeasurement(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One measurement of a body. Null stands where there is no such value."""

    number: Annotated[
        int | None,
        Meta(
            description="On the page and in its pictures: from 1, of those that have a value, in "
            "the order of the chart."
        ),
    ]
    key: Annotated[str, Meta(description="Unique; formulas and other files name it so.")]
    name: str
    group: Annotated[str, Meta(description="Heading in tables; may be empty.")]
    kind: Annotated[str, Meta(description="How it is measured: girth, path, height, ...")]
    value: Annotated[float | None, Meta(description="What the definition asks for.")]
    unit: Annotated[
        ValueUnit, Meta(description="Of all numbers in this record; deg stands for degrees.")
    ]
    error_estimate: Annotated[
        float | None,
        Meta(description="Bound on the error of the value on this surface, estimated."),
    ]
    contact: Annotated[float | None, Meta(description="Length of the tape along the skin.")]
    taut: Annotated[float | None, Meta(description="Length of the tape drawn taut.")]
    gap: Annotated[float | None, Meta(description="contact - taut")]
    outcome: Annotated[
        str,
        Meta(description="measured, or what kept it from being: missing landmark, refused, ..."),
    ]
    status: Annotated[
        str | None, Meta(description="Of the solver, in lower case; null where none was run.")
    ]
    reason: Annotated[
        str, Meta(description="What is the matter and what to do; empty if nothing is.")
    ]
    words: Annotated[str, Meta(description="What is measured, and how the tape lies.")]
    iso_name: Annotated[str | None, Meta(description="Name in ISO 8559-1.")]
    iso_clause: Annotated[str | None, Meta(description="Clause in ISO 8559-1.")]
    accuracy_class: Annotated[
        str | None, Meta(description="In ISO 20685-1; null for angles, which have none.")
    ]
    seamly: Annotated[list[str], Meta(description="Names in Seamly2D.")]
    freesewing: Annotated[str | None, Meta(description="Key in FreeSewing.")]
    landmarks: Annotated[list[str], Meta(description="Names of the landmarks used.")]
    length_by_region: Annotated[
        dict[str, float],
        Meta(description="Length of the tape along the skin inside each body region."),
    ]


class LandmarkPlace(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Where a landmark is on the atlas."""

    name: str
    patch: Annotated[str, Meta(description="Name of the patch.")]
    u: float
    v: float
    given: Annotated[bool, Meta(description="By the atlas; else a rule of the definitions found.")]


class MissingLandmark(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A landmark that neither the atlas nor a rule gave."""

    name: str
    reason: str


class ChartDocument(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """All measurements of one body, with what is needed to judge and repeat them."""

    schema: Annotated[Literal["bodymeasure chart"], Meta(description="Kind of file.")] = SCHEMA
    version: Annotated[Literal[1], Meta(description="Of this layout.")] = VERSION
    name: Annotated[str, Meta(description="What the atlas shows.")]
    created: Annotated[str, Meta(description="When, in ISO 8601.")]
    unit: Annotated[LengthUnit, Meta(description="Unit of every length.")]
    definitions: Annotated[str, Meta(description="Name of the set of definitions.")]
    definitions_words: Annotated[str, Meta(description="What the set says of itself.")]
    atlas_digest: Annotated[
        str, Meta(description="SHA-256 of the control points and their unit, in hexadecimal.")
    ]
    provenance: Annotated[
        dict[str, str], Meta(description="Source, author, license and the like of the atlas.")
    ]
    versions: Annotated[dict[str, str], Meta(description="Of the packages that computed.")]
    seconds: Annotated[float, Meta(description="Time that the measuring took.")]
    outcomes: Annotated[dict[str, int], Meta(description="Measurements of each outcome.")]
    landmarks: list[LandmarkPlace]
    missing_landmarks: list[MissingLandmark]
    measurements: list[BodyMeasurement]


def chart_schema() -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of a chart's ``measurements.json``."""
    return struct_schema(ChartDocument, SCHEMA)


def chart_to_json(document: ChartDocument) -> bytes:
    """A document as JSON, one measurement or landmark a line; every float round-trips."""
    return json_bytes(document)


def chart_to_csv(measurements: Sequence[BodyMeasurement]) -> bytes:
    """Measurements as CSV (RFC 4180, UTF-8) with a header row; every float round-trips.

    The columns are the fields of `BodyMeasurement` in their order. Members of a list are joined by
    semicolons, lengths by region as ``region=length``; null is an empty field.
    """
    return csv_bytes(
        BodyMeasurement.__struct_fields__,
        (
            [_flat(getattr(record, field)) for field in record.__struct_fields__]
            for record in measurements
        ),
    )


def _flat(value: object) -> object:
    if isinstance(value, list):
        return "; ".join(value)
    if isinstance(value, dict):
        return "; ".join(f"{key}={length!r}" for key, length in value.items())
    return value
