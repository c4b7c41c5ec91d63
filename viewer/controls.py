"""Keys, clicks and words that the windows have in common."""

import textwrap
from collections.abc import Callable, Mapping
from typing import Any

from bodymeasure.scene import SIDES

WINDOW_SIZE = (1000, 1100)
INK = (0.15, 0.16, 0.17)
TEXT_SIZE = 10
TEXT_COLUMNS = 60
# How near a click must be, as a fraction of the window's diagonal.
PICK_TOLERANCE = 0.003


def listen(
    plotter: Any,
    help_text: str,
    keys: Mapping[str, Callable[[], object]],
    look_from: Callable[[str], None],
    pick: Callable[[Any, int], object],
) -> None:
    """Let keys and clicks do what they are for, and say so in a line.

    Parameters
    ----------
    plotter : pyvista.Plotter
    help_text : str
    keys : mapping of str to callable
        What each key does; F1 to F4 turn to the four sides.
    look_from : callable
        Called with one of `SIDES`.
    pick : callable
        Called with the mesh and the cell that was clicked on.
    """
    plotter.add_text(help_text, position=(10, 10), font_size=TEXT_SIZE - 2, color=INK)
    for key, action in keys.items():
        plotter.add_key_event(key, action)
    for number, side in enumerate(SIDES, start=1):
        plotter.add_key_event(f"F{number}", lambda side=side: look_from(side))
    plotter.enable_surface_point_picking(
        lambda _, picker: pick(picker.GetDataSet(), picker.GetCellId()),
        show_message=False,
        show_point=False,
        left_clicking=True,
        use_picker=True,
        tolerance=PICK_TOLERANCE,
    )


def say(plotter: Any, words: str) -> None:
    """Show words in the upper right corner, in place of those that were there."""
    lines = [line for part in words.splitlines() for line in textwrap.wrap(part, TEXT_COLUMNS)]
    plotter.add_text(
        "\n".join(lines),
        position="upper_right",
        font_size=TEXT_SIZE,
        color=INK,
        name="words",
        render=not plotter.off_screen,
    )
