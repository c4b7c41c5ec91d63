"""What the page of a survey shows, computed from its table a column at a time."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.surveys.page.drawing import Drawing, drawing
from bodymeasure.surveys.records import Column, Failed, SurveyTable
from bodymeasure.surveys.statistics import (
    Near,
    Outlier,
    Summary,
    correlations,
    main_keys,
    nearest_bodies,
    summary,
)
from bodymeasure.surveys.statistics.outliers import Outliers

# Reasons why measurements have no value, of which a page lists the most frequent.
REASONS = 40
# Sizes that are looked for if none is given: so far along each of the main measurements.
USUAL = (5.0, 50.0, 95.0)
USUAL_KEYS = ("stature", "bust_girth", "waist_girth", "hip_girth")


@dataclass(frozen=True, eq=False)
class Measurement:
    """A measurement of the survey, what it comes to, and its distribution."""

    column: Column
    summary: Summary
    drawing: Drawing | None


@dataclass(frozen=True)
class Lacking:
    """A reason why values are missing, how many, and of which measurements."""

    reason: str
    values: int
    names: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Size:
    """A size that bodies are looked for near to.

    Parameters
    ----------
    name : str
    values : mapping of str to float
        By the keys of measurements.
    near : tuple of Near
    """

    name: str
    values: Mapping[str, float]
    near: tuple[Near, ...]


@dataclass(frozen=True, eq=False)
class Content:
    """All of a page.

    Parameters
    ----------
    table : SurveyTable
    measurements : tuple of Measurement
    main : tuple of Column
        Those that correlations are shown of.
    correlations : ndarray, shape (k, k)
    outliers : tuple of Outlier
        All of them, the farthest first.
    sizes : tuple of Size
    failures : tuple of Failed
    lacking : tuple of Lacking
    """

    table: SurveyTable
    measurements: tuple[Measurement, ...]
    main: tuple[Column, ...]
    correlations: Array
    outliers: tuple[Outlier, ...]
    sizes: tuple[Size, ...]
    failures: tuple[Failed, ...]
    lacking: tuple[Lacking, ...]


def content_of(table: SurveyTable, sizes: Sequence[Mapping[str, float]]) -> Content:
    """Return what the page of a survey shows.

    Parameters
    ----------
    table : SurveyTable
    sizes : sequence of mapping of str to float
        Those to look for bodies near to, in the survey's unit; some usual ones if there are none.
    """
    found, far, valued = [], Outliers(len(table)), []
    for place, column in enumerate(table.measurements):
        values = table[column.key]
        found.append(Measurement(column, summary(values), drawing(values)))
        far.add(place, values)
        if np.isfinite(values).any():
            valued.append(column.key)
    keys = main_keys(valued)
    wanted = {*keys, *(key for size in sizes for key in size)}
    kept = {key: table[key] for key in wanted}
    main = np.column_stack([kept[key] for key in keys]) if keys else np.empty((len(table), 0))
    return Content(
        table=table,
        measurements=tuple(found),
        main=tuple(table.column(key) for key in keys),
        correlations=correlations(main),
        outliers=far.found(),
        sizes=_sizes(kept, keys, sizes),
        failures=table.failures,
        lacking=_lacking(table),
    )


def _sizes(
    values: Mapping[str, Array], keys: Sequence[str], given: Sequence[Mapping[str, float]]
) -> tuple[Size, ...]:
    named = [(f"Size {number}", size) for number, size in enumerate(given, start=1)]
    if not named:
        usual = [key for key in USUAL_KEYS if key in keys] or list(keys[: len(USUAL_KEYS)])
        named = [
            (
                f"{percent:g} % of all bodies are smaller, in each measurement",
                {key: float(np.nanquantile(values[key], percent / 100.0)) for key in usual},
            )
            for percent in (USUAL if usual else ())
        ]
    return tuple(Size(name, size, nearest_bodies(values, size)) for name, size in named)


def _lacking(table: SurveyTable) -> tuple[Lacking, ...]:
    names = {column.key: column.name for column in table.measurements}
    counts: Counter[str] = Counter()
    whose: dict[str, dict[str, None]] = {}
    for _, key, outcome, reason in table.lacking():
        # Numbers differ from body to body, so that the outcome stands for what has no reason.
        words = reason or outcome
        if words not in whose and len(whose) >= 50 * REASONS:
            words = f"{outcome}, for other reasons"
        counts[words] += 1
        whose.setdefault(words, {})[names[key]] = None
    return tuple(
        Lacking(reason, count, tuple(whose[reason]))
        for reason, count in counts.most_common(REASONS)
    )
