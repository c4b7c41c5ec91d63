"""Clicks in a pyvista plotter: pressing a button to turn the body is none."""

import math
from collections.abc import Callable
from typing import Any

# A pointer that moved farther than this many pixels while its button was pressed has turned the
# body: hands are not quite still when they click.
STILL = 4.0
# The distance within which a click picks a thing, as a fraction of the window's diagonal.
PICK_TOLERANCE = 0.003
# The same on the body itself, where the exact place counts: far less than a pixel, so that no click
# falls through the seam between two patches onto the back of the body.
SEAM_TOLERANCE = 1e-5


def listen_for_clicks(plotter: Any, clicked: Callable[[int, int], object]) -> None:
    """Let a function be called at each click of the left button.

    Parameters
    ----------
    plotter : pyvista.Plotter
        Its style of interaction must not be changed later, since that also listens.
    clicked : callable
        It gets the place in the window, in pixels from the left and from the bottom.
    """
    pressed: list[tuple[int, int]] = []

    def press(*_event: Any) -> None:
        pressed[:] = [plotter.iren.get_event_position()]

    def release(*_event: Any) -> None:
        if pressed and math.dist(pressed[0], plotter.iren.get_event_position()) < STILL:
            clicked(*pressed[0])
        pressed.clear()

    plotter.iren.add_observer("LeftButtonPressEvent", press)
    plotter.iren.add_observer("LeftButtonReleaseEvent", release)


def picked_at(plotter: Any, x: float, y: float, only: Any = None) -> Any:
    """Find what is seen at a place of the window.

    Parameters
    ----------
    plotter : pyvista.Plotter
    x, y : float
        Pixels from the left and from the bottom.
    only : pyvista.Actor, optional
        The only thing to look for; others are looked through.

    Returns
    -------
    vtkCellPicker
        The mesh, its cell and the position; the cell is -1 if there is nothing.
    """
    import pyvista

    vtk: Any = pyvista._vtk
    picker = vtk.vtkCellPicker()
    picker.SetTolerance(PICK_TOLERANCE if only is None else SEAM_TOLERANCE)
    if only is not None:
        picker.InitializePickList()
        picker.AddPickList(only)
        picker.PickFromListOn()
    picker.Pick(x, y, 0.0, plotter.renderer)
    return picker
