"""Open a window, or save what it would show."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from bodymeasure.viewer.window.base import BodyWindow
from bodymeasure.viewer.window.patches import Window
from bodymeasure.viewer.window.tapes import TapeWindow

from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.files import write_bytes
from bodymeasure.scene import body_overview, png, tapes_overview
from bodymeasure.scene.drawing.opengl_check import SOFTWARE, opengl_trouble

if TYPE_CHECKING:
    from bodymeasure.chart import Chart
    from bodymeasure.measure import Survey


def view(survey: "Survey", screenshot: Path | None = None) -> str:
    """Open a window on a measured body, or save what it would show.

    Parameters
    ----------
    survey : Survey
    screenshot : Path, optional
        PNG file to write instead of opening a window.

    Returns
    -------
    str
        Why it had to be done in another way than usual, as a sentence; empty if it had not.

    Raises
    ------
    InputError
        If a window is wanted but there is no display, or the file cannot be written.
    MissingExtraError
        If pyvista is not installed.
    """
    return _show(
        lambda off_screen: Window(survey, off_screen=off_screen),
        lambda: body_overview(survey, renderer=SOFTWARE),
        screenshot,
    )


def view_chart(chart: "Chart", screenshot: Path | None = None, *, key: str | None = None) -> str:
    """Open a window on a body with the tapes of its measurements, or save what it would show.

    Parameters
    ----------
    chart : Chart
    screenshot : Path, optional
        PNG file to write instead of opening a window.
    key : str, optional
        The only measurement to show, which must have a tape.

    Returns
    -------
    str
        Why it had to be done in another way than usual, as a sentence; empty if it had not.

    Raises
    ------
    InputError
        If a window is wanted but there is no display, or the file cannot be written.
    MissingExtraError
        If pyvista is not installed.
    """
    return _show(
        lambda off_screen: TapeWindow(chart, key, off_screen=off_screen),
        lambda: tapes_overview(chart, key, renderer=SOFTWARE),
        screenshot,
    )


def _show(
    window: Callable[[bool], BodyWindow],
    without_opengl: Callable[[], bytes],
    screenshot: Path | None,
) -> str:
    """Open a window, or save what it shows, drawn without OpenGL where there is none."""
    try:
        import pyvista
    except ImportError:
        raise MissingExtraError("the viewer", "pyvista", "viewer") from None
    trouble = opengl_trouble(window=screenshot is None)
    if screenshot is None:
        if trouble:
            raise InputError(
                f"no window can be opened, since {trouble}; "
                "write a picture instead with --screenshot FILE.png"
            )
        with pyvista.vtk_verbosity("off"):
            window(False).plotter.show()
        return ""
    if trouble:
        write_bytes(screenshot, without_opengl())
        return f"The picture was drawn without OpenGL, since {trouble}."
    with pyvista.vtk_verbosity("off"):
        plotter = window(True).plotter
        try:
            image = np.asarray(plotter.screenshot(None, return_img=True))
        finally:
            plotter.close()
    write_bytes(screenshot, png(image[..., :3]))
    return ""
