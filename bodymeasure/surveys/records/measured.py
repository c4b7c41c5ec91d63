"""The chart of one body as a row."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from bodymeasure.atlas import Atlas, Severity, Unit, check_atlas
from bodymeasure.chart import Chart, Definitions, both_sides, measure_chart, restricted
from bodymeasure.errors import BodymeasureError, MissingExtraError
from bodymeasure.report.body import body_record
from bodymeasure.surveys.bodies import Asked, Body, Layout, extremity_keys
from bodymeasure.surveys.records.columns import MEMBERS, Column, columns_of
from bodymeasure.surveys.records.row import Lack, Row
from bodymeasure.wording import counted

# How many errors of an atlas a sentence names.
NAMED = 2


@dataclass(frozen=True)
class Charting:
    """What is measured, and how: everything that a value depends on besides the body.

    Parameters
    ----------
    definitions : Definitions
    only : tuple of str
        Keys and presets, none for the whole set.
    unit : Unit
    despite_errors : bool
        Whether bodies are measured whose check finds errors.
    layout : Atlas, optional
        The patches that all bodies share, where they do.
    """

    definitions: Definitions
    only: tuple[str, ...]
    unit: Unit
    despite_errors: bool
    layout: Layout = None

    @cached_property
    def columns(self) -> tuple[Column, ...]:
        """The measurements, in the order of the set."""
        return columns_of(self.definitions, self.only, self.unit)

    @cached_property
    def asked(self) -> Asked:
        """What is wanted of every body."""
        needed = both_sides(restricted(self.definitions, self.only)[1].measurement)
        keys = {one.key for one in needed}
        return Asked(self.layout, not keys.isdisjoint(extremity_keys()))


def measured_row(body: Body, charting: Charting) -> Row:
    """Return the row of a body; whatever is wrong with it is said there, and is no error.

    Raises
    ------
    MissingExtraError
        If a package is missing, without which all bodies would fail.
    """
    try:
        atlas = body.atlas(charting.asked)
        if not charting.despite_errors:
            _require_sound(atlas)
        chart = measure_chart(
            atlas, charting.definitions, only=charting.only, despite_errors=charting.despite_errors
        )
    except MissingExtraError:
        raise
    except BodymeasureError as error:
        return Row(body.name, body.source, " ".join(str(error).split()))
    except Exception as error:
        # One body among a million must not end the survey of the others, whatever it is.
        found = " ".join(f"{type(error).__name__}: {error}".split())
        return Row(body.name, body.source, f"an error of bodymeasure itself, {found}; report it")
    return _row(body, chart, charting)


def _require_sound(atlas: Atlas) -> None:
    """Refuse an atlas whose check finds errors, as `bodymeasure chart` does."""
    errors = [
        f"{finding.kind}: {finding.message}"
        for finding in check_atlas(atlas)
        if finding.severity == Severity.ERROR
    ]
    if errors:
        more = f"; and {len(errors) - NAMED} more" if len(errors) > NAMED else ""
        raise _UnsoundError(
            f"the atlas has {counted(len(errors), 'error')}: {'; '.join(errors[:NAMED])}{more}; "
            "repair it (`bodymeasure check` lists all), or measure despite errors"
        )


class _UnsoundError(BodymeasureError):
    """The check of an atlas finds errors."""


def _row(body: Body, chart: Chart, charting: Charting) -> Row:
    numbers = np.full((len(charting.columns), len(MEMBERS)), np.nan, "<f8")
    places = {column.key: place for place, column in enumerate(charting.columns)}
    lacking = []
    for item in chart.measured:
        record = body_record(item, None, chart.atlas, charting.unit)
        found = [getattr(record, member) for member in MEMBERS]
        place = places[record.key]
        # What a record does not have at all is neither a number nor None.
        numbers[place] = [each if isinstance(each, float) else np.nan for each in found]
        if record.value is None:
            lacking.append(Lack(record.key, record.outcome, record.reason))
    return Row(body.name, body.source, "", numbers.tobytes(), tuple(lacking))
