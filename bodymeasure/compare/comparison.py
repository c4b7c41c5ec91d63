"""Comparison of two sources of body measurements."""

from collections.abc import Iterable
from datetime import UTC, datetime

from bodymeasure.atlas import Unit
from bodymeasure.compare.gaps import Gaps, named
from bodymeasure.compare.iso20685 import MINIMUM_SUBJECTS, agreement, class_verdicts
from bodymeasure.compare.names import Known, Vocabulary
from bodymeasure.compare.plausible import Doubt, doubt, doubt_notes
from bodymeasure.compare.readings import Reading, Readings, converted
from bodymeasure.compare.records import Comparison, Difference
from bodymeasure.errors import InputError
from bodymeasure.report.units import DEGREES, ValueUnit


def compare(
    first: Readings,
    second: Readings,
    *,
    known: Iterable[Known] = (),
    unit: Unit | str | None = None,
    minimum_subjects: int = MINIMUM_SUBJECTS,
    created: datetime | None = None,
) -> Comparison:
    """Return the differences of two sources by subject, and the verdict of ISO 20685-1.

    Two single subjects are compared whatever their names; several are paired by name.

    Parameters
    ----------
    first, second : Readings
    known : iterable of Known
        Measurements besides those that the sources define themselves.
    unit : Unit or str, optional
        Unit of the lengths; that of the first source if not given, or else centimeters.
    minimum_subjects : int
        Number of subjects from which on there is a verdict.
    created : datetime, optional
        The time that the comparison states; the present if not given.

    Raises
    ------
    InputError
        If a measurement is unknown or given twice, an angle stands for a length, or the sources
        have no subject or no measurement in common.
    """
    shown = Unit.parse(unit or first.unit or second.unit or Unit.CM)
    vocabulary = Vocabulary([*first.known, *second.known, *known])
    by_subject = [_by_subject(each, vocabulary) for each in (first, second)]
    pairs, notes = _pairs(first, second)
    differences: list[Difference] = []
    doubts: tuple[list[Doubt], list[Doubt]] = [], []
    gaps = Gaps((first.name, second.name))
    for subject, one, other in pairs:
        a, b = by_subject[0][one], by_subject[1][other]
        for key, each in vocabulary.by_key.items():
            if key in a and key in b:
                for found, mine, theirs in zip(
                    doubts, (a[key], b[key]), (b[key], a[key]), strict=True
                ):
                    if (doubtful := doubt(mine, theirs)) is not None:
                        found.append(doubtful)
                pair = _difference(subject, each, a[key], b[key], shown)
                if pair is not None:
                    differences.append(pair)
        gaps.add(subject, a, b)
    notes += gaps.notes(len(pairs))
    # A wrong unit spoils every difference, so that it comes before what is merely absent.
    doubted = zip(doubts, (first, second), strict=True)
    notes[:0] = [note for found, source in doubted for note in doubt_notes(found, source.name)]
    if not differences:
        raise InputError(
            f"{first.name} and {second.name} have no value of the same measurement; "
            "their keys or names have to agree"
        )
    grouped: dict[str, list[Difference]] = {}
    for difference in differences:
        grouped.setdefault(difference.key, []).append(difference)
    agreements = [
        agreement(grouped[key], minimum_subjects) for key in vocabulary.by_key if key in grouped
    ]
    return Comparison(
        created=(created or datetime.now(UTC)).isoformat(timespec="seconds"),
        a=first.name,
        b=second.name,
        unit=shown.value,
        minimum_subjects=minimum_subjects,
        subjects=[subject for subject, _, _ in pairs],
        classes=class_verdicts(agreements, shown),
        agreements=agreements,
        notes=notes,
        differences=differences,
    )


def _by_subject(readings: Readings, vocabulary: Vocabulary) -> dict[str, dict[str, Reading]]:
    result: dict[str, dict[str, Reading]] = {subject: {} for subject in readings.subjects}
    for reading in readings.values:
        known = vocabulary.find(reading.measurement, reading.place)
        if (reading.unit == DEGREES) != known.angle:
            expected = "an angle in deg" if known.angle else "a length in m, cm, mm or inch"
            raise InputError(
                f"{reading.place}: {known.key!r} is given in {reading.unit}; expected {expected}"
            )
        mine = result[reading.subject]
        if known.key in mine:
            whose = f" of {reading.subject!r}" if reading.subject else ""
            raise InputError(
                f"{reading.place}: {known.key!r}{whose} is given a second time; keep one of the "
                "two, or name the subjects in a column subject"
            )
        mine[known.key] = reading
    return result


def _pairs(first: Readings, second: Readings) -> tuple[list[tuple[str, str, str]], list[str]]:
    """Return the pairs of subjects, each by its name and the names in both; and notes on others."""
    mine, other = first.subjects, second.subjects
    if len(mine) == len(other) == 1:
        return [(mine[0] or other[0], mine[0], other[0])], []
    # Surveys have many subjects, so that names are looked up.
    known = set(mine) & set(other)
    common = [subject for subject in mine if subject in known]
    if not common:
        raise InputError(
            f"{first.name} and {second.name} have no subject in common; expected the same names in "
            "the column subject of both"
        )
    notes = []
    for subjects, lacks in ((mine, second), (other, first)):
        absent = [one or "(unnamed)" for one in subjects if one not in known]
        if absent:
            notes.append(f"not in {lacks.name}: {named(absent, 'subject')}")
    return [(subject, subject, subject) for subject in common], notes


def _difference(
    subject: str, known: Known, one: Reading, other: Reading, shown: Unit
) -> Difference | None:
    if one.value is None or other.value is None:
        return None
    unit: ValueUnit = DEGREES if known.angle else shown.value
    a, b = converted(one.value, one.unit, unit), converted(other.value, other.unit, unit)
    errors = [converted(r.error, r.unit, unit) for r in (one, other) if r.error is not None]
    return Difference(
        subject=subject,
        key=known.key,
        name=known.name,
        unit=unit,
        a=float(a),
        b=float(b),
        difference=float(a - b),
        relative=float((a - b) / b) if b else None,
        combined_error=float(sum(errors)) if errors else None,
        accuracy_class=known.accuracy_class,
    )
