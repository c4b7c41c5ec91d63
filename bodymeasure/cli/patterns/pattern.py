"""`bodymeasure pattern`."""

from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np
from rich.text import Text

from bodymeasure.atlas import Atlas
from bodymeasure.cli.console import RESULTS, print_files, print_note, print_table, progress_bar
from bodymeasure.cli.options import (
    EXIT_CODES,
    despite_errors_option,
    folder_option,
    load_sound_atlas,
    optional_atlas_argument,
    require,
)
from bodymeasure.cli.tables import new_table
from bodymeasure.errors import InputError
from bodymeasure.files import output_folder, write_all
from bodymeasure.wording import counted, hint

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.pattern import Pattern

EXIT_LOOK = 1
CUTTING = ("cutting pieces out of the skin", "shapely", "shapely", "pattern")
# The sets that come along, for the help.
NAMES = "bodice, princess or skirt"


def _print_set(ctx: click.Context, _parameter: click.Parameter, name: str | None) -> None:
    if name is None or ctx.resilient_parsing:
        return
    from bodymeasure.pattern import SETS, set_text

    if name not in SETS:
        raise InputError(f"no set is named {name!r}; {hint(name, SETS)}")
    click.echo(set_text(name), nl=False)
    ctx.exit()


@click.command(short_help="Make the flat pieces of a garment from a body.", epilog=EXIT_CODES)
@optional_atlas_argument
@click.option(
    "--set",
    "definitions",
    default="bodice",
    show_default=True,
    metavar="SET",
    help=f"The panels: {NAMES}, or a file of yours.",
)
@folder_option(default=Path("pattern"), help="Folder for the files; made if it is not there.")
@click.option(
    "--allowance",
    type=click.FloatRange(min=0.0, max=10.0),
    default=1.0,
    show_default=True,
    metavar="CM",
    help="Allowance of seams in cm, round each piece but at a fold.",
)
@click.option(
    "--print-set",
    metavar="SET",
    is_eager=True,
    expose_value=False,
    callback=_print_set,
    help=f"Print the file of a set ({NAMES}), which may be copied and changed, and exit.",
)
@click.option(
    "--patches",
    is_flag=True,
    help="Unfold each patch by itself instead, as the paper does: patches.svg, colored by the "
    "misfit, and patches.csv.",
)
@despite_errors_option
def pattern(
    atlas: str,
    definitions: str,
    output: Path,
    allowance: float,
    patches: bool,
    despite_errors: bool,
) -> int:
    """Make the flat pieces of a garment from ATLAS, whose seams are as long as on the body.

    ATLAS is the average female sample if not given. FOLDER gets pattern.svg, in true size,
    strain.svg, which shows where the cloth has to give, and pattern.json with all lengths.
    """
    if not patches:
        require(CUTTING)
        # Slow imports, which `--help` does not need.
        from bodymeasure.pattern import load_pattern, make_pattern

        panels = load_pattern(definitions)
        loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
        with output_folder(output):
            with progress_bar("laying flat", len(panels.panel)) as progress:
                made = make_pattern(loaded, panels, progress=lambda done, _all: progress(done))
            files = _written(made, output, 10.0 * allowance)
        print_table(_table(made))
        _print_seams(made)
        print_files(files)
        for words in made.warnings:
            print_note(words)
        return EXIT_LOOK if made.warnings else 0
    loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
    return _patches(loaded, output)


def _written(made: "Pattern", output: Path, allowance: float) -> list[Path]:
    from bodymeasure.pattern import pattern_json, pattern_svg, strain_svg

    files = {
        output / "pattern.svg": pattern_svg(made, allowance=allowance).encode(),
        output / "strain.svg": strain_svg(made).encode(),
        output / "pattern.json": pattern_json(made, allowance=allowance),
    }
    write_all(files)
    return list(files)


def _table(made: "Pattern") -> "Table":
    scale = 1000.0 * made.atlas.unit.meters
    table = new_table("piece", "strain, rms", "at most", "darts", words=("darts",))
    for piece in made.pieces:
        darts = ", ".join(f"{dart.name} {scale * dart.intake:.0f} mm" for dart in piece.darts)
        table.add_row(
            Text(piece.name),
            f"{100.0 * piece.rms_strain:.1f} %",
            f"{100.0 * float(np.abs(piece.strains).max()):.0f} %",
            Text(darts),
        )
    return table


def _print_seams(made: "Pattern") -> None:
    if not made.seams:
        return
    scale = 1000.0 * made.atlas.unit.meters
    worst = max(abs(scale * seam.difference) for seam in made.seams)
    words = (
        f"{counted(len(made.seams), 'seam')} between pieces; both sides differ by at most "
        f"{worst:.1g} mm"
    )
    RESULTS.print(Text(words), soft_wrap=True)


def _patches(loaded: Atlas, output: Path) -> int:
    with output_folder(output):
        from bodymeasure.pattern import patches_sheet, patches_table, unfold_patches

        unfolded = unfold_patches(loaded)
        files = {
            output / "patches.svg": patches_sheet(unfolded).encode(),
            output / "patches.csv": patches_table(unfolded).encode(),
        }
        write_all(files)
    worst = 1000.0 * loaded.unit.meters * unfolded.worst
    turned = int(unfolded.turned_over.sum())
    words = (
        f"{counted(len(loaded), 'patch', 'patches')}: misfit {np.median(worst):.2f} mm in the "
        f"median, {np.percentile(worst, 95):.2f} mm for 95 %, {worst.max():.2f} mm at most; "
        f"{turned or 'none'} turned over"
    )
    RESULTS.print(Text(words), soft_wrap=True)
    print_files(files)
    return EXIT_LOOK if turned else 0
