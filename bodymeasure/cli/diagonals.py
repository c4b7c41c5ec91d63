"""`bodymeasure diagonals`."""

from __future__ import annotations

import click
from rich.markup import escape
from rich.table import Table

from bodymeasure.cli.console import RESULTS
from bodymeasure.cli.options import (
    atlas_argument,
    despite_errors_option,
    load_sound_atlas,
    unit_option,
)
from bodymeasure.measure import measure_atlas
from bodymeasure.report import survey_document, to_csv, to_json
from bodymeasure.report.records import Document


@click.command()
@atlas_argument
@click.option(
    "--format",
    "form",
    type=click.Choice(["table", "csv", "json"]),
    default="table",
    show_default=True,
    help="How to print the lengths; json has the layout of a report's measurements.json.",
)
@unit_option
@despite_errors_option
def diagonals(atlas: str, form: str, unit: str, despite_errors: bool) -> None:
    """Print both diagonal geodesics of every patch of ATLAS."""
    loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
    survey = measure_atlas(loaded, compare=False)
    document = survey_document(survey, unit, kinds=("diagonal",))
    if form == "json":
        click.echo(to_json(document).decode(), nl=False)
    elif form == "csv":
        click.echo(to_csv(document.measurements).decode(), nl=False)
    else:
        RESULTS.print(_table(document))


def _table(document: Document) -> Table:
    table = Table(box=None, pad_edge=False)
    table.add_column("diagonal", overflow="fold")
    table.add_column(document.unit, justify="right", no_wrap=True)
    table.add_column("error", justify="right", no_wrap=True)
    table.add_column("status", no_wrap=True)
    for record in document.measurements:
        length = "" if record.length is None else f"{record.length:.4f}"
        error = "" if record.error_estimate is None else f"{record.error_estimate:.0e}"
        good = record.status == "converged"
        table.add_row(
            escape(record.name),
            length,
            error if good else "",
            record.status if good else f"[yellow]{record.status}[/]",
        )
    return table
