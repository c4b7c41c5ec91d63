"""`bodymeasure pattern`."""

from pathlib import Path

import click
import numpy as np
from rich.text import Text

from bodymeasure.cli.console import RESULTS, print_files
from bodymeasure.cli.options import (
    EXIT_CODES,
    despite_errors_option,
    folder_option,
    load_sound_atlas,
    optional_atlas_argument,
)
from bodymeasure.files import output_folder, write_all
from bodymeasure.wording import counted

EXIT_TURNED = 1


@click.command(short_help="Unfold the patches of a body into the plane.", epilog=EXIT_CODES)
@optional_atlas_argument
@folder_option(default=Path("pattern"), help="Folder for the files; made if it is not there.")
@click.option(
    "--patches",
    is_flag=True,
    required=True,
    help="Unfold each patch by itself: patches.svg, colored by the misfit, and patches.csv.",
)
@despite_errors_option
def pattern(atlas: str, output: Path, patches: bool, despite_errors: bool) -> int:  # noqa: ARG001
    """Unfold the patches of ATLAS into the plane.

    ATLAS is the average female sample if not given.
    """
    loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
    with output_folder(output):
        # Slow imports, which `--help` does not need.
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
    return EXIT_TURNED if turned else 0
