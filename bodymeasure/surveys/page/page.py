"""The page of a survey, one self-contained file."""

from collections.abc import Mapping
from itertools import groupby

import numpy as np

from bodymeasure.report.body import tape_text
from bodymeasure.report.numbers import MINUS, NONE, SPACE, fixed
from bodymeasure.report.templating import render_page
from bodymeasure.report.units import DEGREES, TAPE_DECIMALS, UNIT_NAMES
from bodymeasure.surveys.page.content import Content
from bodymeasure.surveys.records import Column
from bodymeasure.surveys.statistics import Percentile
from bodymeasure.surveys.statistics.outliers import FAR
from bodymeasure.wording import counted

# How many outliers and failures a page lists; the tables have all.
OUTLIERS, FAILURES = 30, 50
# How much of its color a cell has for a correlation of 1.
TINT = 0.55
# The percentiles that the page has; summary.csv has more.
SHOWN = (5.0, 50.0, 95.0)


def render_survey(content: Content, links: Mapping[int, str]) -> bytes:
    """Return the page of a survey, which loads nothing else.

    Parameters
    ----------
    content : Content
    links : mapping of int to str
        The addresses of bodies by their places in the survey.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed.
    """
    table = content.table
    subjects = table.subjects
    groups = groupby(content.measurements, key=lambda each: each.column.group)
    rows = [
        {
            "name": column.name,
            "cells": [correlation(value) for value in row],
            "tints": [round(100.0 * TINT * float(np.nan_to_num(value))) for value in row],
        }
        for column, row in zip(content.main, content.correlations, strict=True)
    ]
    context = {
        "content": content,
        "groups": [(group, list(members)) for group, members in groups],
        "shown": SHOWN,
        "correlations": rows,
        "outliers": [
            (subjects[each.body], links.get(each.body), table.measurements[each.column], each)
            for each in content.outliers[:OUTLIERS]
        ],
        "sizes": [
            (
                size,
                [table.column(key) for key in size.values],
                [(subjects[near.body], links.get(near.body), near) for near in size.near],
            )
            for size in content.sizes
        ],
        "failures": content.failures[:FAILURES],
        "sentences": sentences(content),
        "unit_name": UNIT_NAMES[table.unit],
        "far": FAR,
        "versions": table.versions,
    }
    return render_page(
        "bodymeasure.surveys",
        "survey.html.j2",
        context,
        feature="the page of a survey",
        styles=("measurements.css",),
        filters={
            "tape": tape_text,
            "interval": interval,
            "difference": difference,
            "tick": tick,
            "in_unit": in_unit,
        },
    )


def sentences(content: Content) -> list[str]:
    """Return what a survey comes to, in sentences."""
    table, failed = content.table, len(content.failures)
    bodies = counted(len(table), "body", "bodies")
    found = [
        f"{bodies}, {counted(len(table.measurements), 'measurement')} each, by the set "
        f"“{table.definitions}”."
    ]
    if failed:
        found.append(
            f"{counted(failed, 'body', 'bodies')} could not be measured, and nothing here counts "
            f"{'it' if failed == 1 else 'them'}."
        )
    measured = len(table) - failed
    whole = sum(each.summary.count == measured for each in content.measurements)
    missing = sum(measured - each.summary.count for each in content.measurements)
    found.append(
        f"{whole} of {counted(len(table.measurements), 'measurement')} have a value on every "
        "measured body" + (f"; {counted(missing, 'value')} in all are missing." if missing else ".")
    )
    number = len(content.outliers)
    found.append(
        f"{counted(number, 'body', 'bodies')} to look at: some measurement is {FAR:g} standard "
        "deviations or more from the median."
        if number
        else f"No measurement is {FAR:g} standard deviations or more from the median."
    )
    return found


def correlation(value: float) -> str:
    """Return a coefficient of correlation; a dash where there is none."""
    return fixed(value, 2).replace("-", MINUS) if np.isfinite(value) else NONE


def interval(found: Percentile, unit: str) -> str:
    """Return the confidence interval of a percentile; a dash for an end that there is not."""
    return f"{tape_text(found.low, unit)}{SPACE}to {tape_text(found.high, unit)}"


def difference(value: float, unit: str) -> str:
    """Return a difference with its sign."""
    text = f"{value:+.{TAPE_DECIMALS[unit]}f}"
    return (text[1:] if float(text) == 0.0 else text).replace("-", MINUS)


def tick(value: float) -> str:
    """Return the label of an axis."""
    return f"{value:.6g}".replace("-", MINUS)


def in_unit(column: Column) -> str:
    """Return the unit of a measurement, behind its name."""
    return "°" if column.unit == DEGREES else column.unit
