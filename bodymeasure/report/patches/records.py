"""The content of ``measurements.json`` and ``measurements.csv``."""

from collections.abc import Sequence
from typing import Annotated, Final, Literal

from msgspec import UNSET, Meta, Struct, UnsetType

from bodymeasure.report.serial import csv_bytes, fields_set
from bodymeasure.report.units import LengthUnit

SCHEMA: Final = "bodymeasure measurements"
VERSION: Final = 1

Kind = Literal["diagonal", "boundary"]
Parameters = Annotated[
    tuple[float, float], Meta(description="Parameters (u, v) of a point of the patch.")
]


class PatchRecord(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One length on one patch. Null stands where there is no such value."""

    name: Annotated[str, Meta(description="The patch and the path; unique.")]
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
        LengthUnit, Meta(description="Unit of every length, error and difference in this record.")
    ]
    error_estimate: Annotated[
        float | None, Meta(description="Estimated bound on the error of the length.")
    ]
    approximation_error: Annotated[
        float | UnsetType | None,
        Meta(
            description="Bound on the difference of the length from that on the surface which the "
            "patches approximate; absent if they approximate nothing."
        ),
    ] = UNSET
    mesh_difference: Annotated[
        float | UnsetType | None,
        Meta(
            description="About how much larger the length is on the mesh from which the patches "
            "were made; absent without one."
        ),
    ] = UNSET
    status: Annotated[str, Meta(description="A key of `statuses`.")]
    contacts: Annotated[
        str | None,
        Meta(
            description="Edges of the patch along which the path runs, with their parts, such as "
            "`u = 0 from 0.25 to 0.5`; null if it runs along none."
        ),
    ] = None
    proven_shortest: Annotated[
        bool | None,
        Meta(
            description="Whether it is proven that no other path on the patch is as short; false "
            "means that it is not proven. Null for boundaries."
        ),
    ] = None
    raw_length: Annotated[
        float | None,
        Meta(description="Length of the computed path before its correction, whatever the status."),
    ] = None
    residual: Annotated[
        float | None,
        Meta(description="Residual of the geodesic equation between nodes; no unit."),
    ] = None
    functions: Annotated[int | None, Meta(description="Size of the trial space.")] = None
    iterations: Annotated[int | None, Meta(description="Newton iterations.")] = None
    exact: Annotated[
        float | None,
        Meta(
            description="Length of the shortest path inside the patch on triangle meshes, "
            "extrapolated over the sizes of the meshes."
        ),
    ] = None
    exact_uncertainty: Annotated[
        float | None, Meta(description="Uncertainty of `exact`, which the extrapolation gives.")
    ] = None
    difference: Annotated[float | None, Meta(description="length - exact")] = None
    relative_difference: Annotated[
        float | None, Meta(description="(length - exact) / exact; no unit.")
    ] = None
    heat: Annotated[
        float | None,
        Meta(description="Heat distance on a mesh; it shows gross mistakes only."),
    ] = None
    exact_by: Annotated[
        Literal["libigl", "edge flips"] | None,
        Meta(
            description="What measured `exact`: libigl's exact algorithm, or edge flips "
            "(potpourri3d), which bound it from above."
        ),
    ] = None
    verdict: Annotated[
        str | None, Meta(description="A key of `verdicts`; null where nothing was compared.")
    ] = None


class Finding(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Something that the check of the atlas noticed."""

    kind: Annotated[str, Meta(description="What kind of finding it is, in words.")]
    severity: Annotated[Literal["error", "warning"], Meta(description="Errors make lengths wrong.")]
    patches: Annotated[list[str], Meta(description="Names of the patches concerned.")]
    message: str


class Spread(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The spread of a set of values; null if the set is empty."""

    count: int
    minimum: float | None = None
    median: float | None = None
    maximum: float | None = None


class Summary(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Counts of the diagonals, and the spread of what was measured."""

    patches: int
    diagonals: int
    measured: int
    proven_shortest: Annotated[
        int | None,
        Meta(description="Number of those proven to be the only shortest paths on their patches."),
    ] = None
    by_status: Annotated[dict[str, int], Meta(description="Number of diagonals of each status.")]
    by_verdict: Annotated[
        dict[str, int],
        Meta(description="The same of each verdict; empty without a cross-check."),
    ]
    length: Spread
    error_estimate: Spread
    difference: Annotated[Spread, Meta(description="Spread of |length - exact|, in `unit`.")]
    relative_difference: Annotated[Spread, Meta(description="Spread of |length - exact| / exact.")]
    worst: Annotated[
        str | None, Meta(description="Name of the diagonal with the largest relative difference.")
    ] = None


class Document(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """All measurements of one atlas, with what is needed to assess and repeat them."""

    schema: Annotated[
        Literal["bodymeasure measurements"], Meta(description="The kind of file.")
    ] = SCHEMA
    version: Annotated[Literal[1], Meta(description="The version of this layout.")] = VERSION
    name: Annotated[str, Meta(description="What the atlas shows.")]
    created: Annotated[str, Meta(description="The time at which it was made, in ISO 8601.")]
    unit: Annotated[LengthUnit, Meta(description="Unit of every length, error and difference.")]
    atlas_digest: Annotated[
        str, Meta(description="SHA-256 of the control points and their unit, in hexadecimal.")
    ]
    provenance: Annotated[
        dict[str, str], Meta(description="Source, author, license and the like of the atlas.")
    ]
    settings: dict[str, str]
    approximation: Annotated[
        list[str] | UnsetType,
        Meta(
            description="What the patches approximate and what that costs, in sentences; absent if "
            "they approximate nothing."
        ),
    ] = UNSET
    versions: Annotated[dict[str, str], Meta(description="Versions of the packages used.")]
    seconds: Annotated[dict[str, float], Meta(description="Time that each step took.")]
    statuses: Annotated[
        dict[str, str], Meta(description="Meaning of each status that occurs, in a sentence.")
    ]
    verdicts: Annotated[
        dict[str, str], Meta(description="Meaning of each verdict that occurs, in a sentence.")
    ]
    summary: Summary
    findings: list[Finding]
    measurements: list[PatchRecord]


# Fields that are a pair of parameters, which a CSV file holds in two columns.
_PAIRS = ("start", "end")


def to_csv(records: Sequence[PatchRecord]) -> bytes:
    """Return records as CSV (RFC 4180, UTF-8) with a header row; every float round-trips.

    The columns are the fields of `PatchRecord` in their order, with the parameters of the ends as
    ``start_u``, ``start_v``, ``end_u`` and ``end_v``. Null is an empty field. What no record has,
    as what an approximation costs where there is none, has no column.
    """
    fields = fields_set(PatchRecord, records)
    columns = [
        column
        for field in fields
        for column in ((f"{field}_u", f"{field}_v") if field in _PAIRS else (field,))
    ]
    return csv_bytes(columns, (_flat(record, fields) for record in records))


def _flat(record: PatchRecord, fields: Sequence[str]) -> list[object]:
    row: list[object] = []
    for field in fields:
        value = getattr(record, field)
        row.extend(value if field in _PAIRS else (value,))
    return row
