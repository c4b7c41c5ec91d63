"""The measurements of several bodies as CSV, RFC 4180 in UTF-8; every float round-trips."""

from bodymeasure.report.body.records import BodyRecord, flat
from bodymeasure.report.population.records import MeasurementSummary, PopulationDocument
from bodymeasure.report.serial import csv_bytes, fields_set, records_csv


def long_csv(document: PopulationDocument) -> bytes:
    """Return a row for each measurement of each subject, with the fields of `BodyRecord`.

    `bodymeasure compare` reads it.
    """
    records = [record for chart in document.charts for record in chart.measurements]
    columns = fields_set(BodyRecord, records)
    return csv_bytes(
        ("subject", *columns),
        (
            [subject, *(flat(getattr(record, column)) for column in columns)]
            for subject, chart in zip(document.subjects, document.charts, strict=True)
            for record in chart.measurements
        ),
    )


def wide_csv(document: PopulationDocument) -> bytes:
    """Return a row for each subject and a column for each measurement, named key and unit."""
    columns = [f"{each.key} ({each.unit})" for each in document.summaries]
    return csv_bytes(
        ("subject", *columns),
        ([subject, *row] for subject, row in zip(document.subjects, wide(document), strict=True)),
    )


def wide(document: PopulationDocument) -> list[list[float | None]]:
    """Return the values of each subject, in the order of the summaries."""
    keys = [each.key for each in document.summaries]
    rows = []
    for chart in document.charts:
        values = {record.key: record.value for record in chart.measurements}
        rows.append([values.get(key) for key in keys])
    return rows


def summary_csv(document: PopulationDocument) -> bytes:
    """Return a row for each measurement, with the fields of `MeasurementSummary`."""
    return records_csv(MeasurementSummary, document.summaries)
