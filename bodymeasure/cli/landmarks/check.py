"""`bodymeasure landmarks check`."""

from pathlib import Path
from typing import TYPE_CHECKING, Literal

import click
from rich.text import Text

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import RESULTS, print_table
from bodymeasure.cli.inputs import load_atlas
from bodymeasure.cli.options import (
    NumberRange,
    atlas_argument,
    definitions_option,
    format_option,
    length_unit,
    unit_option,
)
from bodymeasure.cli.tables import new_table
from bodymeasure.wording import counted

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.report.landmarks import SymmetryDocument

EXIT_FOUND = 1
MIRRORS = {
    "fitted": "the plane in which the surface is most nearly symmetric",
    "axes": "the plane across the atlas's axes through its median landmarks",
}


@click.command(
    "check", short_help="Check that landmarks are symmetric and well named.", epilog=EXIT_CODES
)
@atlas_argument
@click.option(
    "--mirror",
    type=click.Choice(list(MIRRORS)),
    default="fitted",
    show_default=True,
    help="The mirror: the plane in which the surface is most nearly symmetric, or the one across "
    "the atlas's axes, from front to back, through the median landmarks.",
)
@click.option(
    "--within",
    type=NumberRange(min=0.0),
    metavar="LENGTH",
    help="Largest distance that counts as symmetric, in --unit.  [default: 5 mm]",
)
@format_option(help="Format of the output; csv and json have all digits.")
@unit_option
@definitions_option
def check_landmarks(
    atlas: str,
    mirror: Literal["fitted", "axes"],
    within: float | None,
    form: str,
    unit: str,
    definitions: Path | None,
) -> int:
    """Check that the left landmarks of ATLAS are mirror images of the right ones.

    It lists the distance of each mirrored left landmark from its partner, landmarks without a
    partner, landmarks without a side that lie off the mirror, and names that look like misspelled
    ones of ISO 8559-1 or of --set. Any remark leads to exit code 1.
    """
    from bodymeasure.chart import load_definitions
    from bodymeasure.report.landmarks import symmetry_document, symmetry_to_csv
    from bodymeasure.report.serial import to_json

    loaded_definitions = load_definitions(definitions)
    loaded = load_atlas(atlas)
    shown = length_unit(unit, loaded)
    document = symmetry_document(
        loaded, loaded_definitions, shown, mirror=mirror, within=within, name=atlas
    )
    if form == "json":
        click.echo(to_json(document), nl=False)
    elif form == "csv":
        click.echo(symmetry_to_csv(document), nl=False)
    else:
        if document.landmarks:
            print_table(_table(document))
        RESULTS.print(Text(_summary(document)), soft_wrap=True)
    return EXIT_FOUND if document.to_look_at else 0


def _table(document: "SymmetryDocument") -> "Table":
    from bodymeasure.report.numbers import fixed
    from bodymeasure.report.units import POSITION_DECIMALS

    headings = ("landmark", "checked", f"off by/{document.unit}", "remark")
    table = new_table(*headings, words=("checked", "remark"))
    for record in document.landmarks:
        distance = record.distance
        table.add_row(
            Text(record.name),
            record.checked,
            "" if distance is None else fixed(distance, POSITION_DECIMALS[document.unit]),
            Text(record.remark, "yellow"),
        )
    return table


def _summary(document: "SymmetryDocument") -> str:
    from bodymeasure.report.numbers import fixed
    from bodymeasure.report.units import POSITION_DECIMALS

    unit, decimals = document.unit, POSITION_DECIMALS[document.unit]
    place = ", ".join(fixed(x, decimals) for x in document.mirror_point)
    normal = ", ".join(fixed(x, 4) for x in document.mirror_normal)
    return (
        f"Mirror: {MIRRORS[document.mirror]}, through ({place}) {unit} with normal ({normal}); the "
        f"surface deviates from its mirror image by {fixed(document.deviation, decimals)} {unit} "
        "(root mean square).\n"
        f"{counted(document.to_look_at, 'remark')}; landmarks that are off by more than "
        f"{fixed(document.within, decimals)} {unit} get one"
    )
