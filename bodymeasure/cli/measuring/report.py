"""`bodymeasure report`."""

import time
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.text import Text

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import count_calls, print_files, print_note, print_table, progress_bar
from bodymeasure.cli.inputs import load_sound_atlas
from bodymeasure.cli.measuring.scene import pictures_wanted, scene_of
from bodymeasure.cli.needs import COMPARISON, PAGE, PICTURES, require
from bodymeasure.cli.options import (
    all_pictures_option,
    check_option,
    despite_errors_option,
    folder_option,
    length_unit,
    no_cross_check_option,
    no_pictures_option,
    optional_atlas_argument,
    processes_option,
    unit_option,
)
from bodymeasure.cli.tables import facts_table
from bodymeasure.files import output_folder
from bodymeasure.measure import Survey, measure_atlas
from bodymeasure.wording import counted

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.measure.patches.checks import Check
    from bodymeasure.report import Pictures
    from bodymeasure.report.patches.records import Document

EXIT_DISAGREES = 1
# Verdicts in the words of the table, and their colors. Red ones mean that a length and the mesh
# contradict each other.
VERDICTS = {
    "agrees": ("agree", "green"),
    "not_compared": ("not compared", ""),
    "longer": ("longer than the mesh distance", "red"),
    "shorter": ("shorter than the mesh distance", "red"),
}
# Statuses of diagonals that have a length all the same, in words.
STATUSES = {"on_boundary": "of them run along an edge of their patch"}


@click.command(epilog=EXIT_CODES)
@optional_atlas_argument
@folder_option(
    default=Path("report"),
    help="Folder for report.html, measurements.csv, measurements.json and its schema; made if "
    "it is not there.",
)
@unit_option
@no_cross_check_option
@check_option
@no_pictures_option
@all_pictures_option
@processes_option
@despite_errors_option
def report(
    atlas: str,
    output: Path,
    unit: str,
    no_cross_check: bool,
    check: "Check",
    no_pictures: bool,
    all_pictures: bool,
    processes: int,
    despite_errors: bool,
) -> int:
    """Measure ATLAS, check the lengths against meshes, and write a report.

    ATLAS is the average female sample if not given.
    """
    begin = time.perf_counter()
    with_pictures = pictures_wanted(none=no_pictures, every=all_pictures)
    require(
        PAGE, *(() if no_cross_check else (COMPARISON,)), *((PICTURES,) if with_pictures else ())
    )
    loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
    unit = length_unit(unit, loaded)
    with output_folder(output):
        # Slow imports, which `--help` does not need.
        from bodymeasure.report import disagreements, survey_document, write_report

        with progress_bar("comparing with meshes", 2 * len(loaded)) as progress:
            survey = measure_atlas(
                loaded,
                compare=not no_cross_check,
                check=check,
                processes=processes,
                progress=progress,
            )
        document = survey_document(survey, unit)
        scene = scene_of(survey) if with_pictures else None
        # The scene shows all that pictures do, and is made in a fraction of the time.
        drawn = with_pictures and (scene is None or all_pictures)
        pictures = _pictures(survey, document) if drawn else None
        files = write_report(survey, output, unit=unit, pictures=pictures or False, scene=scene)
    print_table(_table(document, time.perf_counter() - begin))
    print_files(files)
    if pictures is not None and pictures.note:
        print_note(pictures.note)
    wrong = disagreements(document)
    if wrong:
        verb = "disagrees" if wrong == 1 else "disagree"
        print_note(f"{counted(wrong, 'length')} {verb} with the mesh; see report.html.")
    return EXIT_DISAGREES if wrong else 0


def _pictures(survey: Survey, document: "Document") -> "Pictures":
    from bodymeasure.report import closeup_patches
    from bodymeasure.scene import SIDES
    from bodymeasure.scene import pictures as draw

    closeups = closeup_patches(document)
    with progress_bar("drawing", len(SIDES) + len(closeups)) as progress:
        return draw(survey, closeups, advance=count_calls(progress))


def _table(document: "Document", seconds: float) -> "Table":
    """Return the facts that a reader wants to know first."""
    summary, unit = document.summary, document.unit
    table = facts_table(document.name)
    table.add_row("patches", f"{summary.patches:,}")
    color = "green" if summary.measured == summary.diagonals else "yellow"
    measured = f"{summary.measured:,} of {summary.diagonals:,}"
    table.add_row("diagonals measured", Text(measured, color))
    for status, count in summary.by_status.items():
        if status != "converged":
            words = STATUSES.get(status, status.replace("_", " "))
            table.add_row("", Text(f"{count:,} {words}", "" if status in STATUSES else "yellow"))
    spread = summary.length
    if spread.median is not None:
        table.add_row(
            "lengths",
            f"{spread.minimum:.2f} to {spread.maximum:.2f} {unit}, median {spread.median:.2f} "
            f"{unit}",
        )
        table.add_row("largest error estimate", f"{summary.error_estimate.maximum:.0e} {unit}")
    label = "compared with meshes"
    for verdict, (words, color) in VERDICTS.items():
        if count := summary.by_verdict.get(verdict, 0):
            table.add_row(label, Text(f"{count:,} {words}", color))
            label = ""
    difference = summary.relative_difference
    if difference.median is not None:
        table.add_row(
            "relative difference",
            f"median {difference.median:.1e}, largest {difference.maximum:.1e}",
        )
    if document.findings:
        findings = counted(len(document.findings), "finding")
        table.add_row("check of the atlas", Text(findings, "yellow"))
    table.add_row("time", f"{seconds:.1f} s")
    return table
