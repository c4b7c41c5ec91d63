"""The choice of a renderer: pyvista where OpenGL works, otherwise our own."""

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from importlib.util import find_spec
from threading import Thread
from typing import NamedTuple

from bodymeasure.errors import InputError

VARIABLE = "BODYMEASURE_RENDERER"
PYVISTA = "pyvista"
SOFTWARE = "software"
# The probe takes about a second; a machine that needs a minute draws faster without OpenGL.
PROBE_SECONDS = 60
# VTK ends the whole process when it finds neither a display nor EGL nor OSMesa, so that only
# another process can find out. It draws a background and reads it back.
PROBE = """
from vtkmodules.vtkCommonCore import vtkLogger
vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter
renderer, window, reader = vtkRenderer(), vtkRenderWindow(), vtkWindowToImageFilter()
renderer.SetBackground(1.0, 0.0, 0.0)
window.SetOffScreenRendering(True)
window.SetSize(8, 8)
window.AddRenderer(renderer)
window.Render()
reader.SetInput(window)
reader.Update()
pixel = [reader.GetOutput().GetScalarComponentAsDouble(4, 4, 0, i) for i in range(3)]
print("drawn" if pixel == [255, 0, 0] else f"blank {pixel}")
"""


class Choice(NamedTuple):
    """A renderer's name, and why it is not the usual one, as a sentence; empty if it is."""

    renderer: str
    note: str


def choose_renderer(name: str | None = None) -> Choice:
    """Choose a renderer.

    Parameters
    ----------
    name : str, optional
        ``pyvista`` or ``software``. By default it is taken from the environment variable
        BODYMEASURE_RENDERER; if that is not set, it is pyvista where that can draw.

    Raises
    ------
    InputError
        If there is no such renderer, or it cannot draw here.
    """
    source = "renderer"
    if name is None:
        source, name = VARIABLE, os.environ.get(VARIABLE) or None
    if name not in (None, PYVISTA, SOFTWARE):
        raise InputError(f"{source} is {name!r}; expected {PYVISTA!r} or {SOFTWARE!r}")
    if name == SOFTWARE:
        return Choice(SOFTWARE, "")
    trouble = opengl_trouble()
    if not trouble:
        return Choice(PYVISTA, "")
    if name == PYVISTA:
        raise InputError(
            f"{source} is {PYVISTA!r}, but {trouble}; leave it out, or use {SOFTWARE!r}"
        )
    return Choice(SOFTWARE, f"Pictures were drawn without OpenGL, since {trouble}.")


@contextmanager
def opengl_tried_beside() -> Iterator[None]:
    """Try OpenGL beside what is done in a `with` statement, so that nobody waits for it later."""
    # What names a renderer is not asked, or is an error that is for `choose_renderer` to report.
    thread = Thread(target=opengl_trouble) if not os.environ.get(VARIABLE) else None
    if thread is not None:
        thread.start()
    try:
        yield
    finally:
        if thread is not None:
            thread.join()


@cache
def opengl_trouble(*, window: bool = False) -> str:
    """Say why pyvista cannot draw here; empty if it can. It is tried once a process.

    Parameters
    ----------
    window : bool
        Whether a window is to be opened; otherwise pictures are drawn off screen.
    """
    if find_spec("pyvista") is None:
        return "pyvista is not installed"
    environment = dict(os.environ)
    if window and sys.platform.startswith("linux"):
        # Without a display VTK would draw off screen, and the window would never appear.
        environment["VTK_DEFAULT_OPENGL_WINDOW"] = "vtkXOpenGLRenderWindow"
    try:
        result = subprocess.run(
            [sys.executable, "-c", PROBE],
            capture_output=True,
            stdin=subprocess.DEVNULL,
            env=environment,
            timeout=PROBE_SECONDS,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return "VTK could not be tried"
    if result.returncode == 0 and result.stdout.strip() == b"drawn":
        return ""
    if window:
        return "there is no display that VTK can open a window on"
    return "VTK found no OpenGL (neither a display nor EGL nor OSMesa)"
