"""`bodymeasure view`."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import click

from bodymeasure.cli.console import print_note, progress_bar
from bodymeasure.cli.options import (
    COMPARISON,
    EXIT_CODES,
    VIEWER,
    VIEWER_COLORS,
    despite_errors_option,
    load_sound_atlas,
    no_cross_check_option,
    optional_atlas_argument,
    processes_option,
    require,
    same_unit_option,
)
from bodymeasure.errors import InputError
from bodymeasure.files import require_writable
from bodymeasure.measure import Survey, measure_atlas

PICTURE_SUFFIXES = (".png", "")


@click.command(short_help="Show a body and its diagonals in a window.", epilog=EXIT_CODES)
@optional_atlas_argument
@same_unit_option
@click.option(
    "--screenshot",
    type=click.Path(path_type=Path),
    metavar="FILE",
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

    Click a patch or a diagonal for its name and lengths. ATLAS is the average female sample if not
    given.
    """
    require(VIEWER, VIEWER_COLORS, *(() if no_cross_check else (COMPARISON,)))
    viewer = _viewer()
    loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
    if screenshot is None:
        _check_display()
    else:
        _check_screenshot(screenshot)
    with progress_bar("comparing with libigl", 2 * len(loaded)) as progress:
        survey = measure_atlas(
            loaded, compare=not no_cross_check, processes=processes, progress=progress
        )
    note = viewer(survey, screenshot)
    if note:
        print_note(note)
    if screenshot is not None:
        click.echo(screenshot)


def _check_display() -> None:
    """Refuse a window that could not be opened, before the work."""
    from bodymeasure.scene.choice import opengl_trouble

    if trouble := opengl_trouble(window=True):
        raise InputError(
            f"no window can be opened, since {trouble}; "
            "write a picture instead with --screenshot FILE.png"
        )


def _check_screenshot(path: Path) -> None:
    """Refuse a file that could not be written, before the work."""
    if path.suffix.lower() not in PICTURE_SUFFIXES:
        raise InputError(
            f"{path}: the picture is a PNG file; give a name that ends in .png, not {path.suffix}"
        )
    require_writable(path)


def _viewer() -> Callable[[Survey, Path | None], str]:
    try:
        from bodymeasure.viewer import view as viewer
    except ModuleNotFoundError as error:
        if error.name != "bodymeasure.viewer":
            raise
        raise InputError(
            "the viewer is part of an installed bodymeasure, and this is a bare checkout; "
            "install it with: pip install -e ."
        ) from None
    # Installed under another name than its folder's, so that the type checker does not see it.
    show: Callable[[Survey, Path | None], str] = viewer
    return show
