"""A chart as a measurement set of FreeSewing."""

import msgspec

from bodymeasure.atlas import Unit, convert_length
from bodymeasure.report.body.codes import FREESEWING_KEYS, measured_by_code
from bodymeasure.report.body.records import DEGREES, BodyMeasurement, ChartDocument

# Of millimeters and degrees: far below what a tape tells.
DECIMALS = 2


def to_freesewing(document: ChartDocument) -> bytes:
    """The measurements that FreeSewing has keys for, as JSON: millimeters, slopes in degrees.

    Where a measurement is taken on both sides, the wearer's right one is written. The keys that are
    missing are listed in ``notes``.

    Parameters
    ----------
    document : ChartDocument
    """
    chosen = _chosen(document)
    missing = missing_freesewing(document)
    notes = (
        f"Measured by bodymeasure {document.versions.get('bodymeasure', '')}".rstrip()
        + f", {document.created}. Where both sides were measured, the wearer's right one. "
        + (f"Missing: {', '.join(missing)}." if missing else "None is missing.")
    )
    content = {
        "name": document.name or "A body",
        "units": "metric",
        "notes": notes,
        "measurements": {key: _value(chosen[key]) for key in FREESEWING_KEYS if key in chosen},
    }
    return msgspec.json.format(msgspec.json.encode(content), indent=2) + b"\n"


def missing_freesewing(document: ChartDocument) -> tuple[str, ...]:
    """The keys of FreeSewing for which the chart has no value, in alphabetical order."""
    chosen = _chosen(document)
    return tuple(key for key in FREESEWING_KEYS if key not in chosen)


def _chosen(document: ChartDocument) -> dict[str, BodyMeasurement]:
    return dict(
        measured_by_code(document.measurements, lambda m: (m.freesewing,) if m.freesewing else ())
    )


def _value(record: BodyMeasurement) -> float:
    assert record.value is not None
    if record.unit == DEGREES:
        return round(record.value, DECIMALS)
    return round(convert_length(record.value, Unit.parse(record.unit), Unit.MM), DECIMALS)
