"""`bodymeasure diagonals`."""

from typing import TYPE_CHECKING

import click
from rich.table import Table
from rich.text import Text

from bodymeasure.cli.console import RESULTS, print_table
from bodymeasure.cli.options import (
    EXIT_CODES,
    atlas_argument,
    despite_errors_option,
    load_sound_atlas,
    unit_option,
)

if TYPE_CHECKING:
    from bodymeasure.report.patches.records import Document

# Decimals of lengths in the table: to a micrometer; json and csv have all.
DECIMALS = {"m": 6, "cm": 4, "mm": 3, "inch": 5}


@click.command(short_help="Print both diagonals of every patch.", epilog=EXIT_CODES)
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
    """Print both diagonal geodesics of every patch of ATLAS.

    A diagonal without a good length has none; its status says why.
    """
    # Not needed by `--help` and the like, and slow to load.
    from bodymeasure.measure import measure_atlas
    from bodymeasure.report import survey_document, to_csv, to_json

    loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
    survey = measure_atlas(loaded, compare=False)
    document = survey_document(survey, unit, kinds=("diagonal",))
    # As bytes: these are UTF-8 whatever the terminal speaks.
    if form == "json":
        click.echo(to_json(document), nl=False)
    elif form == "csv":
        click.echo(to_csv(document.measurements), nl=False)
    else:
        print_table(_table(document))
        _explain(document)


def _table(document: "Document") -> Table:
    table = Table(box=None, pad_edge=False)
    table.add_column("diagonal", overflow="fold")
    table.add_column(document.unit, justify="right", no_wrap=True)
    table.add_column("error", justify="right", no_wrap=True)
    table.add_column("status", overflow="fold")
    decimals = DECIMALS[document.unit]
    for record in document.measurements:
        length, error = record.length, record.error_estimate
        measured = length is not None
        table.add_row(
            Text(record.name),
            f"{length:.{decimals}f}" if length is not None else "",
            f"{error:.0e}" if measured and error is not None else "",
            Text(record.status.replace("_", " "), "" if measured else "yellow"),
        )
    return table


def _explain(document: "Document") -> None:
    """Say in a sentence what each status but the usual one means."""
    for status, sentence in document.statuses.items():
        if status != "converged":
            RESULTS.print(Text(f"\n{status.replace('_', ' ')}: {sentence}"), soft_wrap=True)
