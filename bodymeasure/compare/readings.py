"""Measured values to compare, of one body or of several, from any source."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from bodymeasure.atlas import Unit, convert_length
from bodymeasure.compare.names import Known
from bodymeasure.errors import InputError
from bodymeasure.report.body.records import ChartDocument, whole_error
from bodymeasure.report.units import DEGREES


@dataclass(frozen=True)
class Reading:
    """One value.

    Parameters
    ----------
    subject : str
        Name of the body; empty if the source does not say.
    measurement : str
        Key or name of the measurement in the source.
    value : float or None
        None if there is none; `reason` then says why.
    unit : str
        m, cm, mm, inch or deg.
    error : float or None
        Bound on the error of `value`, if known.
    reason : str
    place : str
        Its place in the source, for messages.
    """

    subject: str
    measurement: str
    value: float | None
    unit: str
    error: float | None = None
    reason: str = ""
    place: str = ""


@dataclass(frozen=True)
class Readings:
    """All values of one source.

    Parameters
    ----------
    name : str
        Name of the source, for titles.
    values : tuple of Reading
    known : tuple of Known
        The measurements that the source itself defines.
    unit : str or None
        Unit of the source's lengths, if it says so.
    """

    name: str
    values: tuple[Reading, ...]
    known: tuple[Known, ...] = ()
    unit: str | None = field(default=None)

    @property
    def subjects(self) -> tuple[str, ...]:
        """The names of the bodies, each once, in the order of the source."""
        return tuple(dict.fromkeys(reading.subject for reading in self.values))


def readings_of(document: ChartDocument) -> Readings:
    """Return the values of a chart, under the name of the body."""
    name = document.name or "a body"
    return readings_of_subjects(name, [document.subject or document.name], [document])


def readings_of_subjects(
    name: str, subjects: Sequence[str], documents: Sequence[ChartDocument]
) -> Readings:
    """Return the values of the charts of several subjects.

    Parameters
    ----------
    name : str
        Name of the source, for titles.
    subjects : sequence of str
    documents : sequence of ChartDocument
        The chart of each subject, at least one.
    """
    return Readings(
        name=name,
        values=tuple(
            Reading(
                subject=subject,
                measurement=record.key,
                value=record.value,
                unit=record.unit,
                error=whole_error(record),
                reason=record.reason or record.outcome,
                place=f"{subject}: {record.key}",
            )
            for subject, document in zip(subjects, documents, strict=True)
            for record in document.measurements
        ),
        known=tuple(
            Known(record.key, record.name, record.accuracy_class, record.unit == DEGREES)
            for document in documents
            for record in document.measurements
        ),
        unit=documents[0].unit,
    )


def converted(value: float, source: str, target: str) -> float:
    """Return a value in another unit; degrees stay degrees.

    Raises
    ------
    InputError
        If one is a length and the other an angle.
    """
    if (source == DEGREES) != (target == DEGREES):
        raise InputError(f"an angle and a length cannot be compared ({source} and {target})")
    if source == DEGREES:
        return value
    return convert_length(value, Unit.parse(source), Unit.parse(target))
