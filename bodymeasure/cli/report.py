"""`bodymeasure report`."""

from __future__ import annotations

from pathlib import Path

import click
from rich.markup import escape
from rich.table import Table

from bodymeasure.cli.console import ERRORS, RESULTS, progress_bar
from bodymeasure.cli.options import (
    despite_errors_option,
    load_sound_atlas,
    no_cross_check_option,
    optional_atlas_argument,
    processes_option,
    unit_option,
)
from bodymeasure.files import make_folder
from bodymeasure.measure import Survey, measure_atlas
from bodymeasure.report import Pictures, closeup_patches, survey_document, write_report
from bodymeasure.report.records import Document

EXIT_DISAGREES = 1
# Verdicts under which a length and the mesh contradict each other.
DISAGREEING = ("longer", "shorter")
BODY_PICTURES = 4


@click.command()
@optional_atlas_argument
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path, file_okay=True),
    default=Path("report"),
    show_default=True,
    help="Folder for report.html, measurements.csv, measurements.json and its schema.",
)
@unit_option
@no_cross_check_option
@click.option("--no-pictures", is_flag=True, help="Leave out the pictures.")
@processes_option
@despite_errors_option
def report(
    atlas: str,
    output: Path,
    unit: str,
    no_cross_check: bool,
    no_pictures: bool,
    processes: int,
    despite_errors: bool,
) -> int:
    """Measure ATLAS, check the lengths against libigl, and write a report.

    ATLAS is the average female sample by default. Exit code 1 if a length disagrees with the mesh.
    """
    loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
    make_folder(output)
    with progress_bar("comparing with libigl", len(loaded)) as progress:
        survey = measure_atlas(
            loaded, compare=not no_cross_check, processes=processes, progress=progress
        )
    pictures = None if no_pictures else _pictures(survey)
    document = survey_document(survey, unit)
    files = write_report(document, output, pictures=pictures)
    RESULTS.print(_table(document))
    for path in files:
        RESULTS.print(
            escape(str(path)), style="bold" if path.suffix == ".html" else "", soft_wrap=True
        )
    disagreements = sum(document.summary.by_verdict.get(name, 0) for name in DISAGREEING)
    if disagreements:
        ERRORS.print(
            f"[yellow]{disagreements} lengths disagree with the mesh; the report lists them[/]"
        )
    return EXIT_DISAGREES if disagreements else 0


def _pictures(survey: Survey) -> Pictures:
    from bodymeasure.scene import pictures as draw

    closeups = closeup_patches(survey)
    done = 0
    with progress_bar("drawing", BODY_PICTURES + len(closeups)) as progress:

        def advance(_name: str) -> None:
            nonlocal done
            done += 1
            progress(done)

        pictures = draw(survey, closeups, advance=advance)
    if pictures.note:
        ERRORS.print(escape(pictures.note), soft_wrap=True)
    return pictures


def _table(document: Document) -> Table:
    """What a reader wants to know first."""
    summary = document.summary
    table = Table(title=escape(document.name), title_justify="left", show_header=False, box=None)
    table.add_column(style="dim")
    table.add_column()
    table.add_row("patches", str(summary.patches))
    color = "green" if summary.measured == summary.diagonals else "yellow"
    table.add_row("diagonals measured", f"[{color}]{summary.measured} of {summary.diagonals}[/]")
    for status, count in summary.by_status.items():
        if status != "converged":
            table.add_row("", f"[yellow]{count} {status.replace('_', ' ')}[/]")
    spread = summary.length
    if spread.median is not None:
        table.add_row(
            "lengths",
            f"{spread.minimum:.2f} to {spread.maximum:.2f} {document.unit}, "
            f"median {spread.median:.2f} {document.unit}",
        )
        table.add_row(
            "largest error estimate", f"{summary.error_estimate.maximum:.0e} {document.unit}"
        )
    for verdict, count in summary.by_verdict.items():
        good = verdict in ("agrees", "not_compared")
        words = verdict.replace("_", " ")
        table.add_row("compared with libigl", f"[{'green' if good else 'red'}]{count} {words}[/]")
    difference = summary.relative_difference
    if difference.median is not None:
        table.add_row(
            "relative difference",
            f"median {difference.median:.1e}, largest {difference.maximum:.1e}",
        )
    if document.findings:
        table.add_row("check of the atlas", f"[yellow]{len(document.findings)} findings[/]")
    table.add_row("time", f"{sum(document.seconds.values()):.1f} s")
    return table
