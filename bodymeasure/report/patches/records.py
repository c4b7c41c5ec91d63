"""What ``measurements.json`` and ``measurements.csv`` hold, and their schema."""

from collections.abc import Sequence
from typing import Annotated, Any, Final, Literal

from msgspec import Meta, Struct

from bodymeasure.report.serial import csv_bytes, json_bytes, struct_schema

SCHEMA: Final = "bodymeasure measurements"
VERSION: Final = 1

Kind = Literal["diagonal", "boundary"]
UnitName = Literal["m", "cm", "mm", "inch"]
Parameters = Annotated[
    tuple[float, float], Meta(description="Parameters (u, v) of a point of the patch.")
]


class Measurement(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One length on one patch. Null stands where there is no such value."""

    name: Annotated[str, Meta(description="Unique: patch and path.")]
    kind: Annotated[
        Kind,
        Meta(
            description="diagonal: the geodesic between opposite corners; "
            "boundary: a side of the patch."
        ),
    ]
    patch: Annotated[str, Meta(description="Name of the patch.")]
    patch_number: Annotated[int, Meta(ge=0, description="Its number in the atlas, from 0.")]
    region: Annotated[str, Meta(description="Body region; empty if the atlas names none.")]
    start: Parameters
    end: Parameters
    length: Annotated[
        float | None, Meta(description="Null unless the status is converged or on_boundary.")
    ]
    unit: Annotated[
        UnitName, Meta(description="Unit of every length, error and difference in this record.")
    ]
    error_estimate: Annotated[
        float | None, Meta(description="Bound on the error of the length, estimated.")
    ]
    status: Annotated[str, Meta(description="A key of `statuses`.")]
    contacts: Annotated[
        str | None,
        Meta(
            description="Edges of the patch that the path runs along, and from where to where on "
            "them, as `u = 0 from 0.25 to 0.5`; null if it does not."
        ),
    ] = None
    raw_length: Annotated[
        float | None,
        Meta(description="Length of the computed path before correction, good or not."),
    ] = None
    residual: Annotated[
        float | None, Meta(description="Of the geodesic equation between the nodes; no unit.")
    ] = None
    functions: Annotated[int | None, Meta(description="Size of the trial space.")] = None
    iterations: Annotated[int | None, Meta(description="Newton iterations.")] = None
    exact: Annotated[
        float | None,
        Meta(
            description="Exact shortest path inside the patch on triangle meshes, "
            "extrapolated over their sizes."
        ),
    ] = None
    exact_uncertainty: Annotated[
        float | None, Meta(description="Uncertainty of `exact`, from the extrapolation.")
    ] = None
    difference: Annotated[float | None, Meta(description="length - exact")] = None
    relative_difference: Annotated[
        float | None, Meta(description="(length - exact) / exact; no unit.")
    ] = None
    heat: Annotated[
        float | None,
        Meta(description="Heat distance on the finest of these meshes: plausibility only."),
    ] = None
    verdict: Annotated[
        str | None, Meta(description="A key of `verdicts`; null where nothing was compared.")
    ] = None


class Finding(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Something that the check of the atlas noticed."""

    kind: Annotated[str, Meta(description="In words.")]
    severity: Annotated[Literal["error", "warning"], Meta(description="An error spoils lengths.")]
    patches: Annotated[list[str], Meta(description="Names of the patches concerned.")]
    message: str


class Spread(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How a set of values is distributed; null if it is empty."""

    count: int
    minimum: float | None = None
    median: float | None = None
    maximum: float | None = None


class Summary(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The diagonals counted."""

    patches: int
    diagonals: int
    measured: int
    by_status: Annotated[dict[str, int], Meta(description="Diagonals of each status.")]
    by_verdict: Annotated[
        dict[str, int], Meta(description="Diagonals of each verdict; empty without a cross-check.")
    ]
    length: Spread
    error_estimate: Spread
    difference: Annotated[Spread, Meta(description="Of |length - exact|, with its unit.")]
    relative_difference: Annotated[Spread, Meta(description="Of |length - exact| / exact.")]
    worst: Annotated[
        str | None, Meta(description="Name of the diagonal with the largest relative difference.")
    ] = None


class Document(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """All measurements of one atlas, with what is needed to judge and repeat them."""

    schema: Annotated[Literal["bodymeasure measurements"], Meta(description="Kind of file.")] = (
        SCHEMA
    )
    version: Annotated[Literal[1], Meta(description="Of this layout.")] = VERSION
    name: Annotated[str, Meta(description="What the atlas shows.")]
    created: Annotated[str, Meta(description="When, in ISO 8601.")]
    unit: Annotated[UnitName, Meta(description="Unit of every length, error and difference.")]
    atlas_digest: Annotated[
        str, Meta(description="SHA-256 of the control points and their unit, in hexadecimal.")
    ]
    provenance: Annotated[
        dict[str, str], Meta(description="Source, author, license and the like of the atlas.")
    ]
    settings: dict[str, str]
    versions: Annotated[dict[str, str], Meta(description="Of the packages that computed.")]
    seconds: Annotated[dict[str, float], Meta(description="Time that each step took.")]
    statuses: Annotated[
        dict[str, str], Meta(description="Meaning of each status that occurs, in a sentence.")
    ]
    verdicts: Annotated[
        dict[str, str], Meta(description="Meaning of each verdict that occurs, in a sentence.")
    ]
    summary: Summary
    findings: list[Finding]
    measurements: list[Measurement]


def json_schema() -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of ``measurements.json``."""
    return struct_schema(Document, SCHEMA)


def to_json(document: Document) -> bytes:
    """A document as JSON, one finding or measurement a line; every float round-trips."""
    return json_bytes(document)


def to_csv(measurements: Sequence[Measurement]) -> bytes:
    """Measurements as CSV (RFC 4180, UTF-8) with a header row; every float round-trips.

    The columns are the fields of `Measurement` in their order, with the ends' parameters as
    ``start_u``, ``start_v``, ``end_u`` and ``end_v``. Null is an empty field.
    """
    return csv_bytes(CSV_COLUMNS, map(_flat, measurements))


def _flat(measurement: Measurement) -> list[object]:
    row: list[object] = []
    for field in measurement.__struct_fields__:
        value = getattr(measurement, field)
        row.extend(value if field in _PAIRS else (value,))
    return row


_PAIRS = ("start", "end")
CSV_COLUMNS = tuple(
    column
    for field in Measurement.__struct_fields__
    for column in ((f"{field}_u", f"{field}_v") if field in _PAIRS else (field,))
)
