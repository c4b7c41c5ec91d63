"""Writing the page of a survey, and what is on it as tables for programs."""

from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path

import numpy as np

from bodymeasure.arguments import file_path, require_kind, several, shown
from bodymeasure.errors import InputError
from bodymeasure.files import make_folder
from bodymeasure.report.files import write_files
from bodymeasure.report.serial import csv_bytes
from bodymeasure.surveys.page.content import Content, content_of
from bodymeasure.surveys.page.links import body_links
from bodymeasure.surveys.page.page import OUTLIERS, render_survey
from bodymeasure.surveys.records import SurveyTable
from bodymeasure.surveys.statistics import PERCENTILES
from bodymeasure.threads import one_blas_thread


@one_blas_thread()
def write_survey(
    table: SurveyTable,
    folder: str | PathLike[str] | None = None,
    *,
    sizes: Sequence[Mapping[str, float]] = (),
) -> tuple[Path, ...]:
    """Write what a survey says: a page, and its tables as CSV.

    Parameters
    ----------
    table : SurveyTable
    folder : path-like, optional
        For ``survey.html``, ``summary.csv``, ``correlations.csv``, ``outliers.csv`` and
        ``failures.csv``; that of the table if not given.
    sizes : sequence of mapping of str to float
        Sizes to which the page names the nearest bodies, by the keys of measurements and in the
        survey's unit; some usual ones if none are given.

    Returns
    -------
    tuple of Path
        The files, the page first.

    Raises
    ------
    InputError
        If a size names a measurement that the survey does not have, or has no number for it, or
        the folder cannot be written to.
    MissingExtraError
        If jinja2 is not installed.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> with TemporaryDirectory() as folder:
    ...     survey = bm.survey(["female_average", "male_average"], only=["core"], folder=folder)
    ...     print([path.name for path in bm.write_survey(survey)][:2])
    ['survey.html', 'summary.csv']
    """
    require_kind(table, SurveyTable, "the survey", "what survey or read_survey returns")
    for size in several(sizes, Mapping, "sizes", "a size such as {'stature': 168}"):  # type: ignore[type-abstract]
        for key, value in size.items():
            table.column(key)
            if not isinstance(value, (int, float, np.number)) or not np.isfinite(value):
                raise InputError(f"the {key} of a size is {shown(value)}; expected a number")
    place = table.path.parent if folder is None else file_path(folder, "the folder")
    content = content_of(table, sizes)
    make_folder(place)
    linked = [outlier.body for outlier in content.outliers[:OUTLIERS]]
    linked += [near.body for size in content.sizes for near in size.near]
    links = body_links(table, dict.fromkeys(linked), place)
    return write_files(
        place,
        {
            "survey.html": render_survey(content, links),
            "summary.csv": _summary_csv(content),
            "correlations.csv": _correlations_csv(content),
            "outliers.csv": _outliers_csv(content),
            "failures.csv": csv_bytes(
                ("subject", "source", "reason"),
                ((each.subject, each.source, each.reason) for each in content.failures),
            ),
        },
    )


def _summary_csv(content: Content) -> bytes:
    marks = [f"p{percent:g}" for percent in PERCENTILES]
    columns = ["key", "name", "unit", "bodies", "mean", "deviation", "minimum", "maximum"]
    columns += [f"{mark}{end}" for mark in marks for end in ("", "_low", "_high")]
    rows: list[list[object]] = []
    for column, found in ((each.column, each.summary) for each in content.measurements):
        row: list[object] = [column.key, column.name, column.unit, found.count, found.mean]
        row += [found.deviation, found.minimum, found.maximum]
        for one in found.percentiles:
            row += [one.value, one.low, one.high]
        rows.append(row + [None] * (len(columns) - len(row)))
    return csv_bytes(columns, rows)


def _correlations_csv(content: Content) -> bytes:
    keys = [column.key for column in content.main]
    rows = zip(keys, content.correlations.tolist(), strict=True)
    return csv_bytes(("key", *keys), ((key, *row) for key, row in rows))


def _outliers_csv(content: Content) -> bytes:
    table = content.table
    rows = (
        (
            table.subjects[each.body],
            table.sources[each.body],
            table.measurements[each.column].key,
            each.value,
            each.deviations,
            each.others,
        )
        for each in content.outliers
    )
    columns = ("subject", "source", "key", "value", "deviations", "other_measurements")
    return csv_bytes(columns, rows)
