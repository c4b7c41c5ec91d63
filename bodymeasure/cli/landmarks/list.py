"""`bodymeasure landmarks list`."""

from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.text import Text

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import RESULTS, print_table
from bodymeasure.cli.inputs import load_sound_atlas
from bodymeasure.cli.options import (
    atlas_argument,
    definitions_option,
    despite_errors_option,
    format_option,
    length_unit,
    unit_option,
)
from bodymeasure.cli.tables import new_table

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.report.landmarks import LandmarkRecord, LandmarksDocument

PARAMETER_DECIMALS = 4


@click.command(
    "list", short_help="List landmarks, and which are missing (the default).", epilog=EXIT_CODES
)
@atlas_argument
@format_option(help="Format of the output; csv and json have all digits.")
@unit_option
@definitions_option
@despite_errors_option
def list_landmarks(
    atlas: str, form: str, unit: str, definitions: Path | None, despite_errors: bool
) -> None:
    """List the landmarks of ATLAS: those that were picked, and those that a rule gives.

    After them come the landmarks that no rule could give, with the reasons, and the measurements
    that lack them. Rules and measurements are those of --set.
    """
    # Slow imports, which `--help` does not need.
    from bodymeasure.chart import load_definitions
    from bodymeasure.report.landmarks import landmarks_document, landmarks_to_csv
    from bodymeasure.report.serial import to_json

    loaded_definitions = load_definitions(definitions)
    loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
    shown = length_unit(unit, loaded)
    document = landmarks_document(loaded, loaded_definitions, shown, name=atlas)
    # Bytes are UTF-8, whatever the encoding of the terminal.
    if form == "json":
        click.echo(to_json(document), nl=False)
    elif form == "csv":
        click.echo(landmarks_to_csv(document), nl=False)
    else:
        _print(document)


def _print(document: "LandmarksDocument") -> None:
    if document.landmarks:
        print_table(_table(document.landmarks, document.unit))
    else:
        RESULTS.print(Text("The atlas has no landmark; `bodymeasure landmarks add` adds one."))
    if document.missing:
        RESULTS.print(Text("\nMissing:"))
        for missing in document.missing:
            line = Text.assemble("  ", (missing.name, "yellow"), f": {missing.reason}")
            RESULTS.print(line, soft_wrap=True)
    if document.lacking:
        RESULTS.print(Text(f"\nLacking for measurements of “{document.definitions}”:"))
        for lack in document.lacking:
            names = ", ".join(lack.landmarks)
            line = Text.assemble(f"  {lack.name}: ", (names, "yellow"))
            RESULTS.print(line, soft_wrap=True)


def _table(records: "list[LandmarkRecord]", unit: str) -> "Table":
    from bodymeasure.report.numbers import fixed
    from bodymeasure.report.units import POSITION_DECIMALS

    headings = ("landmark", "patch", "u", "v", f"x/{unit}", f"y/{unit}", f"z/{unit}", "origin")
    table = new_table(*headings, words=("patch", "origin"))
    for record in records:
        table.add_row(
            Text(record.name),
            Text(record.patch),
            *(fixed(value, PARAMETER_DECIMALS) for value in (record.u, record.v)),
            *(fixed(value, POSITION_DECIMALS[unit]) for value in (record.x, record.y, record.z)),
            Text(record.rule or record.origin),
        )
    return table
