"""`bodymeasure view`."""

from __future__ import annotations

from pathlib import Path

import click

from bodymeasure.cli.console import ERRORS, progress_bar
from bodymeasure.cli.options import (
    despite_errors_option,
    load_sound_atlas,
    no_cross_check_option,
    optional_atlas_argument,
    processes_option,
)
from bodymeasure.errors import InputError
from bodymeasure.measure import measure_atlas


@click.command()
@optional_atlas_argument
@click.option(
    "--screenshot",
    type=click.Path(path_type=Path, dir_okay=False),
    help="Write a PNG file instead of opening a window.",
)
@no_cross_check_option
@processes_option
@despite_errors_option
def view(
    atlas: str,
    screenshot: Path | None,
    no_cross_check: bool,
    processes: int,
    despite_errors: bool,
) -> None:
    """Show ATLAS in a window: patches, diagonals colored by their difference from the mesh.

    Click a patch or a diagonal for its name and lengths. ATLAS is a sample's body by default.
    """
    viewer = _viewer()
    loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
    with progress_bar("comparing with libigl", len(loaded)) as progress:
        survey = measure_atlas(
            loaded, compare=not no_cross_check, processes=processes, progress=progress
        )
    note = viewer(survey, screenshot)
    if note:
        ERRORS.print(note)
    if screenshot is not None:
        click.echo(screenshot)


def _viewer():  # type: ignore[no-untyped-def]  # installed under another name than its folder's
    try:
        from bodymeasure.viewer import view as viewer
    except ModuleNotFoundError as error:
        if error.name != "bodymeasure.viewer":
            raise
        raise InputError(
            "the viewer is part of an installed bodymeasure, and this is a bare checkout; "
            "install it with: pip install -e ."
        ) from None
    return viewer
