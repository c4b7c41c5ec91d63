"""`bodymeasure diagonals`."""

from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.text import Text

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import RESULTS, print_table
from bodymeasure.cli.inputs import load_sound_atlas
from bodymeasure.cli.measuring.paths import check_paths_file, diagonal_curves, write_curves
from bodymeasure.cli.options import (
    atlas_argument,
    despite_errors_option,
    format_option,
    length_unit,
    paths_option,
    unit_option,
)
from bodymeasure.cli.tables import new_table

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.report.patches.records import Document, PatchRecord


@click.command(epilog=EXIT_CODES)
@atlas_argument
@format_option(
    help="Format of the output; json has the layout of a report's measurements.json.",
)
@unit_option
@paths_option
@despite_errors_option
def diagonals(
    atlas: str, form: str, unit: str, paths_file: Path | None, despite_errors: bool
) -> None:
    """Print both diagonal geodesics of every patch of ATLAS.

    A diagonal whose length cannot be trusted has none; its status says why.
    """
    # Slow imports, which `--help` does not need.
    from bodymeasure.measure import measure_atlas
    from bodymeasure.report import survey_document, to_csv, to_json

    if paths_file is not None:
        check_paths_file(paths_file)
    loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
    survey = measure_atlas(loaded, compare=False)
    document = survey_document(survey, length_unit(unit, loaded), kinds=("diagonal",))
    if paths_file is not None:
        write_curves(paths_file, loaded, diagonal_curves(survey))
    # Bytes are UTF-8, whatever the encoding of the terminal.
    if form == "json":
        click.echo(to_json(document), nl=False)
    elif form == "csv":
        click.echo(to_csv(document.measurements), nl=False)
    else:
        print_table(_table(document))
        _explain(document)


def _table(document: "Document") -> "Table":
    from bodymeasure.report.units import FINE_DECIMALS

    costs = ("approximation", "on the mesh") if document.approximation else ()
    table = new_table(
        "diagonal",
        document.unit,
        "error",
        *costs,
        "shortest",
        "status",
        words=("shortest", "status"),
    )
    decimals = FINE_DECIMALS[document.unit]
    for record in document.measurements:
        length, error = record.length, record.error_estimate
        measured = length is not None
        table.add_row(
            Text(record.name),
            f"{length:.{decimals}f}" if length is not None else "",
            f"{error:.0e}" if measured and error is not None else "",
            *(_costs(record) if costs else ()),
            Text("proven" if record.proven_shortest else ""),
            Text(record.status.replace("_", " "), "" if measured else "yellow"),
        )
    return table


def _costs(record: "PatchRecord") -> tuple[str, str]:
    """Return the error from the approximation and the difference on the mesh."""
    error, difference = record.approximation_error, record.mesh_difference
    return f"{error:.0e}" if error else "", f"{difference:+.1g}" if difference else ""


def _explain(document: "Document") -> None:
    """Print what patches approximate, and a sentence on each status except for the usual one."""
    summary = document.summary
    RESULTS.print(
        Text(
            f"\nshortest: {summary.proven_shortest} of {summary.measured} measured diagonals are "
            "proven to be the only shortest paths on their patches (`bodymeasure docs proofs`)"
        ),
        soft_wrap=True,
    )
    for sentence in document.approximation or ():
        RESULTS.print(Text(f"\n{sentence}"), soft_wrap=True)
    for status, sentence in document.statuses.items():
        if status != "converged":
            RESULTS.print(Text(f"\n{status.replace('_', ' ')}: {sentence}"), soft_wrap=True)
