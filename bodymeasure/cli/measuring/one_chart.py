"""The chart of one body: printed, or written into a folder with its page."""

import time
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from bodymeasure.cli.console import (
    count_calls,
    print_files,
    print_note,
    print_table,
    progress_bar,
)
from bodymeasure.cli.fitting.files import write_fit
from bodymeasure.cli.measuring.chart_tables import print_chart, summary_table
from bodymeasure.cli.measuring.paths import tape_curves, write_curves
from bodymeasure.cli.measuring.scene import scene_of
from bodymeasure.cli.measuring.subjects import Subject
from bodymeasure.files import output_folder

if TYPE_CHECKING:
    from bodymeasure.chart import Chart
    from bodymeasure.fit import FittedBody
    from bodymeasure.report.body import ChartDocument, TapePictures

EXIT_NOT_MEASURED = 1
# Outcomes of measurements that lack a landmark. No body has all landmarks of the default set.
ABSENT = ("missing landmark", "missing operand")
SIDES = 4


class Wanted(NamedTuple):
    """What is wanted of a chart.

    Parameters
    ----------
    unit : str
        Unit of the lengths.
    asked_for : bool
        Whether the user chose the measurements, so that each that is missing is something to look
        at.
    paths_file : Path, optional
        The file for the paths of the tapes.
    pictures, near : bool
        Whether the page has pictures, and whether each measurement has one from near.
    begin : float
        The time by `time.perf_counter` at which the command began.
    """

    unit: str
    asked_for: bool
    paths_file: Path | None
    pictures: bool
    near: bool
    begin: float


def print_one(subject: Subject, measuring: Callable[[], "Chart"], form: str, wanted: Wanted) -> int:
    """Print the chart of a body; return 1 if something is to be looked at."""
    from bodymeasure.report.body import chart_document

    measured = measuring()
    document = chart_document(measured, wanted.unit, subject=subject.name)
    if wanted.paths_file is not None:
        write_curves(wanted.paths_file, subject.atlas, tape_curves(measured))
    print_chart(document, form)
    return _exit_code(document, asked_for=wanted.asked_for)


def write_one(
    subject: Subject,
    measuring: Callable[[], "Chart"],
    folder: Path,
    wanted: Wanted,
    *,
    fit: "FittedBody | None",
) -> int:
    """Write the chart of a body into a folder; return 1 if something is to be looked at.

    The fit of a body to a scan is written beside its chart.
    """
    from bodymeasure.report.body import chart_document, write_chart

    name, body = subject
    with output_folder(folder):
        with _opengl_tried_beside() if wanted.pictures else nullcontext():
            measured = measuring()
        scene = scene_of(measured) if wanted.pictures else None
        near = scene is None or wanted.near
        pictures = _pictures(measured, near=near) if wanted.pictures else None
        # Whatever fails does so before the folder has its files.
        more: list[Path] = []
        if wanted.paths_file is not None:
            write_curves(wanted.paths_file, body, tape_curves(measured))
            more.append(wanted.paths_file)
        if fit is not None:
            place = folder / f"{name}.atlas"
            more[:0] = write_fit(fit, place, page=True, pictures=wanted.pictures)
        files = write_chart(
            measured, folder, unit=wanted.unit, stem=name, pictures=pictures or False, scene=scene
        )
    document = chart_document(measured, wanted.unit, subject=name)
    print_table(summary_table(document, time.perf_counter() - wanted.begin))
    print_files((*files, *more))
    if pictures is not None and pictures.note:
        print_note(pictures.note)
    code = _exit_code(document, asked_for=wanted.asked_for)
    if code:
        print_note("Some measurements could not be taken; see “Not measured” in chart.html.")
    return code


def _opengl_tried_beside() -> AbstractContextManager[None]:
    # A slow import.
    from bodymeasure.scene.drawing.opengl_check import opengl_tried_beside

    return opengl_tried_beside()


def _pictures(chart: "Chart", *, near: bool) -> "TapePictures":
    from bodymeasure.scene import tape_pictures

    drawn = [item for item in chart.measured if item.tapes]
    # The bar may end early, since not all sides of all groups are drawn.
    most = SIDES * len({item.definition.group for item in drawn}) + near * len(drawn)
    with progress_bar("drawing", most) as progress:
        return tape_pictures(chart, few=not near, advance=count_calls(progress))


def _exit_code(document: "ChartDocument", *, asked_for: bool) -> int:
    """Return 1 if a measurement failed although its landmarks are there, or if none was taken.

    A user's own set of definitions asks for all of its measurements, and so do keys.
    """
    outcomes = [record.outcome for record in document.measurements]
    harmless = ("measured", *(() if asked_for else ABSENT))
    wanting = "measured" not in outcomes or any(each not in harmless for each in outcomes)
    return EXIT_NOT_MEASURED if wanting else 0
