"""A chart as a measurement set of FreeSewing."""

import msgspec

from bodymeasure.atlas import Unit, convert_length
from bodymeasure.report.body.codes import FREESEWING_KEYS, measured_by_code
from bodymeasure.report.body.records import BodyRecord, ChartDocument
from bodymeasure.report.units import DEGREES

# Decimals of millimeters and degrees, which are far finer than a tape.
DECIMALS = 2


def to_freesewing(document: ChartDocument) -> bytes:
    """Return the measurements that FreeSewing has keys for, as JSON in millimeters and degrees.

    Where a measurement is taken on both sides, the wearer's right one is written. Missing keys are
    listed in ``notes``.

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
    """Return the keys of FreeSewing for which the chart has no value, in alphabetical order.

    Where only some measurements were asked for, these are keys of theirs.
    """
    chosen = _chosen(document)
    return tuple(key for key in asked_freesewing(document) if key not in chosen)


def asked_freesewing(document: ChartDocument) -> tuple[str, ...]:
    """Return the keys of FreeSewing that a chart is asked for: all, or those of some measurements.

    They are in alphabetical order.
    """
    if not document.only:
        return FREESEWING_KEYS
    asked = {record.freesewing for record in document.measurements}
    return tuple(key for key in FREESEWING_KEYS if key in asked)


def _chosen(document: ChartDocument) -> dict[str, BodyRecord]:
    return dict(
        measured_by_code(document.measurements, lambda m: (m.freesewing,) if m.freesewing else ())
    )


def _value(record: BodyRecord) -> float:
    assert record.value is not None
    if record.unit == DEGREES:
        return round(record.value, DECIMALS)
    return round(convert_length(record.value, Unit.parse(record.unit), Unit.MM), DECIMALS)
