"""The values of a survey, to be compared with another one or with hand measurements."""

from pathlib import Path

import numpy as np

from bodymeasure.compare.names import Known
from bodymeasure.compare.readings import Reading, Readings
from bodymeasure.report.units import DEGREES
from bodymeasure.surveys import read_survey


def survey_readings(path: Path) -> Readings:
    """Return the values of a survey's table; bodies without a chart have none.

    Raises
    ------
    InputError
        If it is no table of a survey.
    MissingExtraError
        If pyarrow is not installed.
    """
    table = read_survey(path)
    failed = {each.subject for each in table.failures}
    reasons = {
        (subject, key): reason or outcome for subject, key, outcome, reason in table.lacking()
    }
    values = []
    for column in table.measurements:
        found = table[column.key]
        errors = table.member(column.key, "error_estimate")
        errors = errors + np.nan_to_num(table.member(column.key, "approximation_error"))
        for subject, value, error in zip(
            table.subjects, found.tolist(), errors.tolist(), strict=True
        ):
            if subject in failed:
                continue
            has_value = np.isfinite(value)
            values.append(
                Reading(
                    subject=subject,
                    measurement=column.key,
                    value=value if has_value else None,
                    unit=column.unit,
                    error=error if has_value and np.isfinite(error) else None,
                    reason="" if has_value else reasons.get((subject, column.key), "not measured"),
                    place=f"{path}, {subject}: {column.key}",
                )
            )
    known = tuple(
        Known(column.key, column.name, column.accuracy_class, column.unit == DEGREES)
        for column in table.measurements
    )
    return Readings(path.name, tuple(values), known, table.unit)
