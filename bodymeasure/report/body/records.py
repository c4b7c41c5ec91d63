"""The content of a chart's ``measurements.json`` and ``measurements.csv``."""

from typing import Annotated, Final, Literal

from msgspec import UNSET, Meta, Struct, UnsetType

from bodymeasure.report.serial import csv_bytes, fields_set
from bodymeasure.report.units import LengthUnit, ValueUnit

SCHEMA: Final = "bodymeasure chart"
VERSION: Final = 1


class LandmarkShift(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The change of a value if a landmark lies 5 mm elsewhere on the skin, in the value's unit."""

    landmark: str
    up: Annotated[
        float | None,
        Meta(description="If it is 5 mm higher; null if it cannot be measured from there."),
    ]
    across: Annotated[
        float | None,
        Meta(description="If it is 5 mm to the side; null if it cannot be measured from there."),
    ]


class BodyRecord(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One measurement of a body. Null stands where there is no such value."""

    number: Annotated[
        int | None,
        Meta(
            description="The number on the page and in its pictures: from 1, for measurements that "
            "have a value, in the order of the chart."
        ),
    ]
    key: Annotated[str, Meta(description="Unique; formulas and other files refer to it.")]
    name: str
    group: Annotated[str, Meta(description="The heading in tables; may be empty.")]
    kind: Annotated[str, Meta(description="How it is measured: girth, path, height, ...")]
    value: Annotated[float | None, Meta(description="The value that the definition asks for.")]
    unit: Annotated[
        ValueUnit,
        Meta(description="Unit of all numbers in this record; deg stands for degrees."),
    ]
    error_estimate: Annotated[
        float | None,
        Meta(description="Estimated bound on the error of the value on this surface."),
    ]
    approximation_error: Annotated[
        float | UnsetType | None,
        Meta(
            description="Bound on the difference of the value from that on the surface which the "
            "patches approximate; absent if they approximate nothing."
        ),
    ] = UNSET
    mesh_difference: Annotated[
        float | UnsetType | None,
        Meta(
            description="About how much larger the value is on the mesh from which the patches "
            "were made; absent without one."
        ),
    ] = UNSET
    input_uncertainty: Annotated[
        float | UnsetType | None,
        Meta(
            description="Standard uncertainty of the value that comes from the scan to which the "
            "body was fitted: from its surface and from the places of its landmarks; absent if it "
            "was not fitted to one."
        ),
    ] = UNSET
    contact: Annotated[float | None, Meta(description="Length of the tape along the skin.")]
    taut: Annotated[float | None, Meta(description="Length of the tape drawn taut.")]
    gap: Annotated[float | None, Meta(description="contact - taut")]
    outcome: Annotated[
        str,
        Meta(description="measured, or the reason why it is not: missing landmark, refused, ..."),
    ]
    status: Annotated[
        str | None,
        Meta(description="Status of the solver, in lower case; null if none was run."),
    ]
    reason: Annotated[
        str, Meta(description="What went wrong, and what to do about it; empty if nothing did.")
    ]
    words: Annotated[str, Meta(description="What is measured, and how the tape lies.")]
    iso_name: Annotated[str | None, Meta(description="Name in ISO 8559-1.")]
    iso_clause: Annotated[str | None, Meta(description="Clause in ISO 8559-1.")]
    accuracy_class: Annotated[
        str | None, Meta(description="The class in ISO 20685-1; null for angles, which have none.")
    ]
    seamly: Annotated[list[str], Meta(description="Names in Seamly2D.")]
    freesewing: Annotated[str | None, Meta(description="Key in FreeSewing.")]
    garmentcode: Annotated[str | None, Meta(description="Key in GarmentCode.")] = None
    landmarks: Annotated[list[str], Meta(description="Names of the landmarks used.")]
    length_by_region: Annotated[
        dict[str, float],
        Meta(description="Length of the tape along the skin inside each body region."),
    ]
    shifts: Annotated[
        list[LandmarkShift],
        Meta(description="What the value owes to the places of its landmarks, if that was asked."),
    ] = []


class LandmarkPlace(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The place of a landmark on the atlas."""

    name: str
    patch: Annotated[str, Meta(description="Name of the patch.")]
    u: float
    v: float
    given: Annotated[
        bool,
        Meta(description="Whether the atlas gives it, rather than a rule."),
    ]
    origin: Annotated[
        str | UnsetType | None,
        Meta(
            description="How it was found on the scan to which the body was fitted: carried, "
            "picked or rule; absent without a scan."
        ),
    ] = UNSET
    uncertainty: Annotated[
        float | UnsetType | None,
        Meta(
            description="Root mean square distance along the skin from the place where it belongs, "
            "in the document's unit; absent without a scan."
        ),
    ] = UNSET


class MissingLandmark(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A landmark that neither the atlas nor a rule gave."""

    name: str
    reason: str


class ScanSummary(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The scan that a body was fitted to."""

    distance: Annotated[
        float | None,
        Meta(description="Root mean square distance of the surface from the scan."),
    ]
    uncovered: Annotated[
        list[str],
        Meta(description="The patches that the scan does not show, and whose shape is a guess."),
    ]
    done: Annotated[list[str], Meta(description="What was done with the scan, in sentences.")]
    warnings: Annotated[
        list[str], Meta(description="What to know before relying on a number, in sentences.")
    ]


class PickedGain(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Landmarks that are to be picked, and the measurements that this gains."""

    landmarks: list[str]
    places: Annotated[list[str], Meta(description="Where each lies, in words; may be empty.")]
    reasons: Annotated[
        list[str], Meta(description="Why its rule gave none, or a hint at its name; may be empty.")
    ]
    measurements: Annotated[list[str], Meta(description="Their names.")]


class ChartDocument(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """All measurements of one body, with what is needed to assess and repeat them."""

    schema: Annotated[Literal["bodymeasure chart"], Meta(description="The kind of file.")] = SCHEMA
    version: Annotated[Literal[1], Meta(description="The version of this layout.")] = VERSION
    name: Annotated[str, Meta(description="What the atlas shows.")]
    subject: Annotated[
        str, Meta(description="The name by which tables and comparisons know the body.")
    ] = ""
    created: Annotated[str, Meta(description="The time at which it was made, in ISO 8601.")]
    unit: Annotated[LengthUnit, Meta(description="Unit of every length.")]
    definitions: Annotated[str, Meta(description="Name of the set of definitions.")]
    definitions_words: Annotated[str, Meta(description="Description of the set of definitions.")]
    only: Annotated[
        list[str],
        Meta(description="The keys and presets that were asked for; empty if all of the set were."),
    ] = []
    atlas_digest: Annotated[
        str, Meta(description="SHA-256 of the control points and their unit, in hexadecimal.")
    ]
    provenance: Annotated[
        dict[str, str], Meta(description="Source, author, license and the like of the atlas.")
    ]
    approximation: Annotated[
        list[str] | UnsetType,
        Meta(
            description="What the patches approximate and what that costs, in sentences; absent if "
            "they approximate nothing."
        ),
    ] = UNSET
    scan: Annotated[
        ScanSummary | UnsetType,
        Meta(description="Absent if the body was not fitted to a scan."),
    ] = UNSET
    versions: Annotated[dict[str, str], Meta(description="Versions of the packages used.")]
    seconds: Annotated[float, Meta(description="The time that measuring took.")]
    outcomes: Annotated[dict[str, int], Meta(description="Number of measurements of each outcome.")]
    landmarks: list[LandmarkPlace]
    missing_landmarks: list[MissingLandmark]
    to_pick: Annotated[
        list[PickedGain],
        Meta(description="The landmarks whose picking would gain measurements, the best first."),
    ] = []
    measurements: list[BodyRecord]


def whole_error(record: BodyRecord) -> float | None:
    """Return the error of a value from the computation and from the approximation together."""
    if record.error_estimate is None:
        return None
    return record.error_estimate + (record.approximation_error or 0.0)


def chart_to_csv(document: ChartDocument) -> bytes:
    """Return the measurements as CSV (RFC 4180, UTF-8) with a header; every float round-trips.

    The columns are the fields of `BodyRecord` in their order. Members of a list are joined by
    semicolons, and lengths by region are written as ``region=length``; null is an empty field.
    What no record has, as what an approximation costs where there is none, has no column.
    """
    columns = fields_set(BodyRecord, document.measurements)
    return csv_bytes(
        columns,
        ([flat(getattr(record, column)) for column in columns] for record in document.measurements),
    )


def flat(value: object) -> object:
    """Return what a cell of a CSV file holds of a field."""
    if isinstance(value, list):
        return "; ".join(map(_shift_text, value))
    if isinstance(value, dict):
        return "; ".join(f"{key}={length!r}" for key, length in value.items())
    return None if value is UNSET else value


def _shift_text(member: str | LandmarkShift) -> str:
    if isinstance(member, str):
        return member
    ways = (("up", member.up), ("across", member.across))
    return f"{member.landmark}: " + ", ".join(f"{way}={change!r}" for way, change in ways)
