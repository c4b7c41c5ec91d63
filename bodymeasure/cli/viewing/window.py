"""`bodymeasure view --desktop` and `--screenshot`: pyvista's window."""

import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import click

from bodymeasure.cli.console import print_note, progress_bar
from bodymeasure.cli.inputs import load_sound_atlas
from bodymeasure.cli.measuring.measured import measured_chart
from bodymeasure.cli.needs import COMPARISON, VIEWER, VIEWER_COLORS, require
from bodymeasure.cli.viewing.page import EVERY, not_installed
from bodymeasure.errors import InputError
from bodymeasure.files import require_writable
from bodymeasure.measure import Survey, measure_atlas
from bodymeasure.wording import nearest

if TYPE_CHECKING:
    from bodymeasure.atlas import Atlas
    from bodymeasure.chart import Chart

PICTURE_SUFFIXES = (".png", "")


def show_window(
    atlas: str,
    screenshot: Path | None,
    chart: tuple[Path | None, str, str | None] | None,
    *,
    no_cross_check: bool,
    processes: int,
    despite_errors: bool,
) -> None:
    """Open a window on a body, or write a picture of it.

    Parameters
    ----------
    atlas : str
        The name that the command was given.
    screenshot : Path or None
        The picture to write in place of a window.
    chart : tuple or None
        The file of definitions, the preset and the only key, if tapes are to be shown.
    no_cross_check : bool
    processes : int
    despite_errors : bool
    """
    compared = chart is None and not no_cross_check
    require(VIEWER, VIEWER_COLORS, *((COMPARISON,) if compared else ()))
    viewer, chart_viewer = _viewers()
    loaded = load_sound_atlas(atlas, despite_errors=despite_errors)
    if screenshot is None:
        _check_display()
    else:
        _check_screenshot(screenshot)
    if chart is not None:
        definitions, preset, key = chart
        measured = _chart(loaded, definitions, preset, key, despite_errors)
        note = chart_viewer(measured, screenshot, key=key)
    else:
        note = viewer(_survey(loaded, no_cross_check, processes), screenshot)
    if note:
        print_note(note)
    if screenshot is not None:
        click.echo(screenshot)


def _survey(loaded: "Atlas", no_cross_check: bool, processes: int) -> Survey:
    with progress_bar("comparing with meshes", 2 * len(loaded)) as progress:
        return measure_atlas(
            loaded, compare=not no_cross_check, processes=processes, progress=progress
        )


def _chart(
    loaded: "Atlas", definitions: Path | None, preset: str, key: str | None, despite_errors: bool
) -> "Chart":
    """Measure the chart of a body, in which a measurement that is to be shown must have a tape.

    Raises
    ------
    InputError
        If there is no such measurement, or it has no tape, or no measurement has one.
    """
    from bodymeasure.chart import both_sides, load_definitions

    wanted = load_definitions(definitions)
    keys = [item.key for item in both_sides(wanted.measurement)]
    if key is not None and key not in keys:
        near = nearest(key, keys)
        hint = f"did you mean {near!r}?" if near else f"expected one such as {', '.join(keys[:3])}"
        raise InputError(f"there is no measurement {key!r} in {wanted.name!r}; {hint}")
    only = () if preset == EVERY else (preset,) if key is None else (preset, key)
    chart = measured_chart(loaded, wanted, only=only, despite_errors=despite_errors)
    if key is not None and not (chart[key].tapes and math.isfinite(chart[key].value)):
        reason = chart[key].reason or "what it is calculated from has none"
        raise InputError(f"{key}: there is no tape to show: {reason}")
    if not any(item.tapes for item in chart.measured):
        first = chart.measured[0]
        raise InputError(
            "there is no tape to show, since nothing was measured; "
            f"{first.definition.key}: {first.reason}"
        )
    return chart


def _check_display() -> None:
    """Refuse a window that could not be opened, before anything is measured."""
    from bodymeasure.scene.drawing.opengl_check import opengl_trouble

    if trouble := opengl_trouble(window=True):
        raise InputError(
            f"no window can be opened, since {trouble}; "
            "write a picture instead with --screenshot FILE.png"
        )


def _check_screenshot(path: Path) -> None:
    """Refuse a file that could not be written, before anything is measured."""
    if path.suffix.lower() not in PICTURE_SUFFIXES:
        raise InputError(
            f"{path}: the picture is a PNG file; give a name that ends in .png, not {path.suffix}"
        )
    require_writable(path)


def _viewers() -> tuple[Callable[[Survey, Path | None], str], Callable[..., str]]:
    """Import the functions that show a survey and a chart."""
    try:
        from bodymeasure.viewer import view, view_chart
    except ModuleNotFoundError as error:
        if error.name != "bodymeasure.viewer":
            raise
        raise not_installed() from None
    # Installed under another name than its folder's, so that the type checker does not see it.
    return view, view_chart
