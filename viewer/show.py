"""Opening the window, or saving what it would show."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from bodymeasure.viewer.window import build

from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.files import write_bytes
from bodymeasure.scene import body_overview, png
from bodymeasure.scene.choice import SOFTWARE, opengl_trouble

if TYPE_CHECKING:
    from bodymeasure.measure import Survey


def view(survey: Survey, screenshot: Path | None = None) -> str:
    """Open a window on a measured body, or save what it would show.

    Parameters
    ----------
    survey : Survey
    screenshot : Path, optional
        PNG file to write instead of opening a window.

    Returns
    -------
    str
        A sentence for the user if it had to be done in another way than usual, otherwise empty.

    Raises
    ------
    InputError
        If a window is wanted but there is no display, or the file cannot be written.
    MissingExtraError
        If pyvista is not installed.
    """
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
            build(survey).plotter.show()
        return ""
    if trouble:
        write_bytes(screenshot, body_overview(survey, renderer=SOFTWARE))
        return f"The picture was drawn without OpenGL, since {trouble}."
    with pyvista.vtk_verbosity("off"):
        plotter = build(survey, off_screen=True).plotter
        try:
            image = np.asarray(plotter.screenshot(None, return_img=True))
        finally:
            plotter.close()
    write_bytes(screenshot, png(image[..., :3]))
    return ""
