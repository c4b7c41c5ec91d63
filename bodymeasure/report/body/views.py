"""The content of a chart, arranged and put into words for the page."""

from collections.abc import Mapping
from dataclasses import dataclass

from msgspec import UNSET

from bodymeasure.report.body.records import BodyRecord, ChartDocument, LandmarkShift, whole_error
from bodymeasure.report.body.scan_words import input_text, scan_sentences, scan_tile
from bodymeasure.report.body.tape import change_text, small_text, tailor_inches, tape_text
from bodymeasure.report.numbers import MINUS, NONE, as_bound
from bodymeasure.report.templating import Image
from bodymeasure.report.units import UNIT_NAMES
from bodymeasure.wording import counted

MEASURED = "measured"
# The sides of the body in the order in which they are shown.
SIDES = ("front", "back", "left", "right")
OTHER_GROUP = "Other measurements"
# Changes below these have no sign, since they are shown as zero.
LEAST_SHIFT = {"m": 5e-5, "cm": 5e-3, "mm": 5e-2, "inch": 5e-3, "deg": 0.05}
# Outcomes that only state that something is absent; the others deserve a look.
ABSENT = ("missing landmark", "missing operand")


@dataclass(frozen=True)
class Row:
    """A measurement as the tables show it."""

    record: BodyRecord
    number: str
    value: str
    fraction: str
    contact: str
    taut: str
    gap: str
    tone: str
    mark: str
    regions: tuple[tuple[str, str], ...]
    uncertainty: str
    shift: str
    shifts: tuple[str, ...]

    @property
    def anchor(self) -> str:
        """The identifier of the close-up in the page."""
        return f"measurement-{self.record.key}"


@dataclass(frozen=True)
class Group:
    """Measurements under one heading."""

    name: str
    anchor: str
    rows: tuple[Row, ...]
    sides: Mapping[str, Image]


def groups(
    document: ChartDocument,
    numbers: Mapping[str, int] | None = None,
    body: Mapping[tuple[str, str], Image] | None = None,
) -> list[Group]:
    """Return the measurements by group, in the order in which groups first occur.

    Parameters
    ----------
    document : ChartDocument
    numbers : mapping of str to int, optional
        Numbers in the pictures by key; the numbers of the document if not given.
    body : mapping of (str, str) to Image, optional
        Pictures by group and side.
    """
    grouped: dict[str, list[Row]] = {}
    for record in document.measurements:
        number = record.number if numbers is None else numbers.get(record.key)
        row = _row(record, "" if number is None else str(number))
        grouped.setdefault(record.group, []).append(row)
    pictures = body or {}
    return [
        Group(
            name or OTHER_GROUP,
            f"group-{place}",
            tuple(rows),
            {side: pictures[name, side] for side in SIDES if (name, side) in pictures},
        )
        for place, (name, rows) in enumerate(grouped.items(), start=1)
    ]


def _row(record: BodyRecord, number: str) -> Row:
    unit, error = record.unit, whole_error(record)
    good = record.outcome == MEASURED
    absent = record.outcome in ABSENT
    return Row(
        record=record,
        number=number,
        value=tape_text(record.value, unit, error),
        fraction=tailor_inches(record.value, error) if unit == "inch" else "",
        contact=tape_text(record.contact, unit, error),
        taut=tape_text(record.taut, unit, error),
        gap=small_text(record.gap, unit),
        tone="good" if good else "fair" if absent else "poor",
        mark="✓" if good else "△" if absent else "✕",
        regions=tuple(
            (region or "elsewhere", tape_text(length, unit))
            for region, length in record.length_by_region.items()
        ),
        uncertainty=input_text(record),
        shift=largest_shift(record),
        shifts=tuple(_shift_words(record, shift) for shift in record.shifts),
    )


def largest_shift(record: BodyRecord) -> str:
    """Return the largest change of a value with its landmarks, without a sign."""
    sizes = [abs(x) for shift in record.shifts for x in (shift.up, shift.across) if x is not None]
    return change_text(record.unit, max(sizes)) if sizes else NONE


def _shift_words(record: BodyRecord, shift: LandmarkShift) -> str:
    def said(change: float | None) -> str:
        if change is None:
            return "cannot be measured"
        sign = "" if abs(change) < LEAST_SHIFT[record.unit] else "+" if change > 0.0 else MINUS
        return f"{sign}{change_text(record.unit, abs(change))}"

    return f"{shift.landmark}: higher {said(shift.up)}, to the side {said(shift.across)}"


@dataclass(frozen=True)
class Absence:
    """Measurements that lack a value for the same reason."""

    names: str
    outcome: str
    reason: str


def unmeasured(document: ChartDocument) -> list[BodyRecord]:
    """Return the measurements that have no value, in the order of the chart."""
    return [record for record in document.measurements if record.outcome != MEASURED]


def absences(document: ChartDocument) -> list[Absence]:
    """Return why measurements have no value; those with the same reason are put together.

    Measurements that only lack landmarks are left to `gains`.
    """
    names: dict[tuple[str, str], list[str]] = {}
    waiting = {name for pick in document.to_pick for name in pick.measurements}
    for record in unmeasured(document):
        if record.outcome in ABSENT and record.name in waiting:
            continue
        names.setdefault((record.outcome, record.reason), []).append(record.name)
    # Names contain commas.
    return [Absence("; ".join(each), outcome, reason) for (outcome, reason), each in names.items()]


@dataclass(frozen=True)
class Gain:
    """Landmarks to pick, in words, and the measurements that this gains."""

    landmarks: str
    count: str
    places: tuple[str, ...]
    measurements: str


def gains(document: ChartDocument) -> list[Gain]:
    """Return the landmarks whose picking would gain measurements, the best first.

    Where a landmark lies is said once.
    """
    said: set[str] = set()
    result = []
    for pick in document.to_pick:
        several = len(pick.landmarks) > 1
        places = []
        for name, place, reason in zip(pick.landmarks, pick.places, pick.reasons, strict=True):
            words = "; ".join(filter(None, (place, reason)))
            if words and name not in said:
                places.append(f"{name}: {words}" if several else words)
            said.add(name)
        result.append(
            Gain(
                " and ".join(f"“{name}”" for name in pick.landmarks),
                counted(len(pick.measurements), "measurement"),
                tuple(places),
                "; ".join(pick.measurements),
            )
        )
    return result


def remarked(document: ChartDocument) -> list[BodyRecord]:
    """Return the measurements that have a value and a remark on it."""
    return [m for m in document.measurements if m.outcome == MEASURED and m.reason]


def tiles(document: ChartDocument) -> list[tuple[str, str, str]]:
    """Return the key figures, each with a heading and a remark."""
    records = [m for m in document.measurements if m.outcome == MEASURED]
    lengths = [m for m in records if m.unit == document.unit]
    error = max(lengths, key=lambda m: m.error_estimate or 0.0, default=None)
    bridged = max(lengths, key=lambda m: m.gap or 0.0, default=None)
    missing = unmeasured(document)
    return [
        ("Measured", f"{len(records)} of {len(document.measurements)}", ""),
        ("Not measured", str(len(missing)), "the reasons are below" if missing else ""),
        (
            "Largest error estimate",
            small_text(error.error_estimate, error.unit) if error else NONE,
            error.name if error else "",
        ),
        scan_tile(document)
        or (
            "Tape most above the skin",
            small_text(bridged.gap, bridged.unit) if bridged and bridged.gap else NONE,
            f"shorter when taut: {bridged.name}" if bridged and bridged.gap else "",
        ),
    ]


def summary_sentences(document: ChartDocument) -> list[str]:
    """Return the results in sentences that need no knowledge of the method."""
    total, missing = len(document.measurements), unmeasured(document)
    words = document.definitions_words.rstrip(".")
    sentences = [
        f"The set “{document.definitions}” has {counted(total, 'measurement')}"
        f"{f' ({words[:1].lower()}{words[1:]})' if words else ''}. Lengths are in "
        f"{UNIT_NAMES[document.unit]}, and are taken on the smooth surface of the body.",
    ]
    if missing:
        kinds = "; ".join(
            f"{outcome}: {count}"
            for outcome, count in document.outcomes.items()
            if outcome != MEASURED
        )
        sentences.append(
            f"{total - len(missing)} could be measured; {len(missing)} could not and "
            f"{'has' if len(missing) == 1 else 'have'} no value here ({kinds}). “Not measured” "
            "lists them, with the reasons and what to do."
        )
    else:
        sentences.append("All could be measured.")
    errors = [
        m.error_estimate
        for m in document.measurements
        if m.unit == document.unit and m.error_estimate is not None
    ]
    if errors:
        whole = (
            "This is the error of the computation on this body's surface, and the smallest part of "
            "what is unknown."
            if document.scan is not UNSET
            else "This is the error of the computation on this body's surface. It does not include "
            "the error of the scan or the model from which the body was made, nor that of the "
            "places of the landmarks."
        )
        bound = as_bound(small_text(max(errors), document.unit))
        sentences.append(f"By their own estimates the lengths are in error by {bound}. {whole}")
    return [*sentences, *scan_sentences(document), *(document.approximation or ())]
