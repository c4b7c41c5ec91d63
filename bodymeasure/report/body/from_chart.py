"""The numbers of a chart as records: units are converted, and numbers not finite become null."""

import math
from collections import Counter
from datetime import UTC, datetime

from msgspec import UNSET, UnsetType

from bodymeasure.atlas import Atlas, Unit, approximation_sentences, convert_length
from bodymeasure.chart import Chart, Measured, worth_picking
from bodymeasure.chart.landmarks.places import place_in_words
from bodymeasure.report.body.records import (
    BodyRecord,
    ChartDocument,
    LandmarkPlace,
    LandmarkShift,
    MissingLandmark,
    PickedGain,
    ScanSummary,
)
from bodymeasure.report.units import DEGREES, ValueUnit


def chart_document(
    chart: Chart, unit: Unit | str, *, subject: str = "", created: datetime | None = None
) -> ChartDocument:
    """Return all that a chart holds, as the content of its ``measurements.json``.

    Parameters
    ----------
    chart : Chart
    unit : Unit or str
        Unit of the lengths; angles stay in degrees.
    subject : str
        The name by which tables and comparisons know the body, such as that of its file; the name
        of the atlas if not given.
    created : datetime, optional
        The time that the document states; the present if not given.
    """
    unit = Unit.parse(unit)
    atlas = chart.atlas
    valued = [item.definition.key for item in chart.measured if math.isfinite(item.value)]
    numbers = {key: number for number, key in enumerate(valued, start=1)}
    return ChartDocument(
        name=atlas.name,
        subject=subject or atlas.name,
        created=(created or datetime.now(UTC)).isoformat(timespec="seconds"),
        unit=unit.value,
        definitions=chart.definitions.name,
        definitions_words=chart.definitions.words,
        only=list(chart.only),
        atlas_digest=atlas.digest,
        provenance={str(key): str(value) for key, value in atlas.provenance.items()},
        approximation=list(approximation_sentences(atlas, unit)) or UNSET,
        scan=_scan(atlas, unit),
        versions={str(key): str(value) for key, value in chart.versions.items()},
        seconds=float(chart.seconds),
        outcomes=dict(Counter(str(item.outcome) for item in chart.measured)),
        landmarks=[_place(chart, name, unit) for name in chart.landmarks],
        missing_landmarks=[
            MissingLandmark(name=name, reason=reason)
            for name, reason in chart.missing_landmarks.items()
        ],
        to_pick=_to_pick(chart),
        measurements=[
            body_record(item, numbers.get(item.definition.key), atlas, unit)
            for item in chart.measured
        ],
    )


def _place(chart: Chart, name: str, unit: Unit) -> LandmarkPlace:
    atlas, point = chart.atlas, chart.landmarks[name]
    origin: str | UnsetType | None = UNSET
    uncertainty: float | UnsetType | None = UNSET
    if atlas.scan is not None:
        found = atlas.scan.landmarks.get(name)
        origin = found.origin.value if found else None if name in atlas.landmarks else "rule"
        off = chart.landmark_uncertainty.get(name)
        uncertainty = None if off is None else float(convert_length(off, atlas.unit, unit))
    return LandmarkPlace(
        name=name,
        patch=atlas.patch_names[point.patch],
        u=float(point.u),
        v=float(point.v),
        given=name in atlas.landmarks,
        origin=origin,
        uncertainty=uncertainty,
    )


def _scan(atlas: Atlas, unit: Unit) -> ScanSummary | UnsetType:
    scan = atlas.scan
    if scan is None:
        return UNSET
    distance = float(convert_length(scan.rms, Unit.M, unit))
    return ScanSummary(
        distance=distance if math.isfinite(distance) else None,
        uncovered=[atlas.patch_names[patch] for patch in scan.uncovered],
        done=list(scan.done),
        warnings=list(scan.warnings),
    )


def _to_pick(chart: Chart) -> list[PickedGain]:
    gains = []
    keys = [item.definition.key for item in chart.measured]
    said = {item.definition.key: item.reason for item in chart.measured}
    for pick in worth_picking(chart.definitions, chart.landmarks, keys):
        # A name that nobody knows may be misspelled, of which the measurement says more.
        other = said[pick.measurements[0].key]
        reasons = [
            chart.missing_landmarks.get(name, "" if place_in_words(name) else other)
            for name in pick.landmarks
        ]
        gains.append(
            PickedGain(
                landmarks=list(pick.landmarks),
                places=[place_in_words(name) for name in pick.landmarks],
                reasons=reasons,
                measurements=[measurement.name for measurement in pick.measurements],
            )
        )
    return gains


def body_record(item: Measured, number: int | None, atlas: Atlas, target: Unit) -> BodyRecord:
    """Return a measurement of an atlas with its lengths in a unit, under a number of the page."""
    source, has_approximation = atlas.unit, atlas.approximation is not None
    definition = item.definition
    angle = definition.in_degrees

    def converted(value: float) -> float | None:
        if not math.isfinite(value):
            return None
        return float(value) if angle else float(convert_length(value, source, target))

    def optional(value: float | None, there: bool) -> float | UnsetType | None:
        if not there:
            return UNSET
        return None if value is None else converted(value)

    unit: ValueUnit = DEGREES if angle else target.value
    iso, class_ = definition.iso, definition.accuracy_class
    return BodyRecord(
        number=number,
        key=definition.key,
        name=definition.name,
        group=definition.group,
        kind=definition.tag(),
        value=converted(item.value),
        unit=unit,
        error_estimate=converted(item.error_estimate),
        approximation_error=optional(item.approximation_error, has_approximation),
        mesh_difference=optional(item.mesh_difference, has_approximation),
        input_uncertainty=optional(item.input_uncertainty, atlas.scan is not None),
        contact=converted(item.contact),
        taut=converted(item.taut),
        gap=converted(item.gap),
        outcome=item.outcome.value,
        status=item.status.lower() or None,
        reason=item.reason,
        words=definition.words,
        iso_name=iso.name if iso else None,
        iso_clause=(iso.clause or None) if iso else None,
        accuracy_class=None if class_ is None else class_.value,
        seamly=list(definition.seamly),
        freesewing=definition.freesewing,
        garmentcode=definition.garmentcode,
        landmarks=list(item.landmarks),
        length_by_region={
            region: length
            for region, value in item.length_by_region.items()
            if (length := converted(value)) is not None
        },
        shifts=[
            LandmarkShift(
                landmark=shift.landmark, up=converted(shift.up), across=converted(shift.across)
            )
            for shift in item.shifts
        ],
    )
