"""The charts of several bodies as one document."""

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from statistics import fmean, median, stdev

from bodymeasure.arguments import repeated
from bodymeasure.errors import InputError
from bodymeasure.report.body.records import BodyRecord, ChartDocument
from bodymeasure.report.population.records import Failure, MeasurementSummary, PopulationDocument


def population_document(
    subjects: Sequence[str],
    charts: Sequence[ChartDocument],
    *,
    created: datetime | None = None,
    failures: Mapping[str, str] | None = None,
) -> PopulationDocument:
    """Return the charts of several bodies as one document, with summaries.

    Parameters
    ----------
    subjects : sequence of str
        A name for each, all different.
    charts : sequence of ChartDocument
        In one unit, at least one.
    created : datetime, optional
        The time that the document states; the present if not given.
    failures : mapping of str to str, optional
        The bodies that could not be charted, each with the reason.

    Raises
    ------
    InputError
        If there is no chart, or two subjects have one name.
    """
    if not charts:
        raise InputError("there is no body to chart; expected at least one")
    if (twice := repeated(subjects)) is not None:
        raise InputError(f"two subjects are named {twice!r}; rename one")
    return PopulationDocument(
        created=(created or datetime.now(UTC)).isoformat(timespec="seconds"),
        unit=charts[0].unit,
        definitions=charts[0].definitions,
        subjects=list(subjects),
        failures=[
            Failure(subject=subject, reason=reason) for subject, reason in (failures or {}).items()
        ],
        summaries=_summaries(charts),
        charts=list(charts),
    )


def _summaries(charts: Sequence[ChartDocument]) -> list[MeasurementSummary]:
    by_key: dict[str, list[BodyRecord]] = {}
    for chart in charts:
        for record in chart.measurements:
            by_key.setdefault(record.key, []).append(record)
    return [_summary(records, len(charts)) for records in by_key.values()]


def _summary(records: Sequence[BodyRecord], count: int) -> MeasurementSummary:
    values = [record.value for record in records if record.value is not None]
    first = records[0]
    return MeasurementSummary(
        key=first.key,
        name=first.name,
        group=first.group,
        unit=first.unit,
        subjects=len(values),
        missing=count - len(values),
        mean=fmean(values) if values else None,
        deviation=stdev(values) if len(values) > 1 else None,
        minimum=min(values, default=None),
        median=median(values) if values else None,
        maximum=max(values, default=None),
    )
