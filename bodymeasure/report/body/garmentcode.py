"""A chart as a body file of GarmentCode."""

from collections.abc import Mapping

from bodymeasure.atlas import Unit, convert_length
from bodymeasure.report.body.codes import GARMENTCODE_KEYS, measured_by_code
from bodymeasure.report.body.records import BodyRecord, ChartDocument
from bodymeasure.report.units import DEGREES

# Decimals of centimeters and degrees: a hundredth of a millimeter, which is far finer than a tape.
DECIMALS = 3


def to_garmentcode(document: ChartDocument) -> bytes:
    """Return the measurements of GarmentCode's bodies, as YAML in centimeters and degrees.

    Where a measurement is taken on both sides, the wearer's right one is written. Missing keys are
    listed in a comment; GarmentCode's programs need most of them.

    Parameters
    ----------
    document : ChartDocument

    Notes
    -----
    The keys are those of M. Korosteleva and O. Sorkine-Hornung, "GarmentCode: programming
    parametric sewing patterns", ACM Transactions on Graphics 42 (2023), as its repository's
    ``assets/bodies/mean_all.yaml`` has them.
    """
    chosen, missing = _chosen(document), missing_garmentcode(document)
    version = document.versions.get("bodymeasure", "")
    comments = [
        f"{document.name or 'A body'}, measured by bodymeasure {version}".rstrip()
        + f", {document.created}.",
        "Centimeters and degrees. Where both sides were measured, the wearer's right one.",
        f"Missing: {', '.join(missing)}." if missing else "None is missing.",
    ]
    # A name may hold a line break, at which a comment would end.
    lines = [f"# {' '.join(comment.split())}" for comment in comments]
    values = [f"  {key}: {_value(chosen[key]):.{DECIMALS}f}" for key in chosen]
    return "\n".join([*lines, "body:" if values else "body: {}", *values, ""]).encode()


def missing_garmentcode(document: ChartDocument) -> tuple[str, ...]:
    """Return the keys of GarmentCode for which the chart has no value, in alphabetical order."""
    chosen = _chosen(document)
    return tuple(key for key in GARMENTCODE_KEYS if key not in chosen)


def _chosen(document: ChartDocument) -> Mapping[str, BodyRecord]:
    found = measured_by_code(
        document.measurements, lambda m: (m.garmentcode,) if m.garmentcode else ()
    )
    return {key: found[key] for key in GARMENTCODE_KEYS if key in found}


def _value(record: BodyRecord) -> float:
    assert record.value is not None
    if record.unit == DEGREES:
        return record.value
    return convert_length(record.value, Unit.parse(record.unit), Unit.CM)
