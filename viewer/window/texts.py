"""Lines of text in a window, at a size in pixels, so that they fit it whatever its shape."""

from collections.abc import Sequence
from typing import Any

# Ink of the texts.
INK = (0.15, 0.16, 0.17)
# Height of small letters' lines and mean width of their letters, in pixels, for VTK's font.
SMALL = 15
LINE = 1.3 * SMALL
LETTER = 0.5 * SMALL
# Room between the texts and the window's edge, in pixels.
EDGE = 10
# Room between two entries of the help.
BETWEEN = "    "


def help_lines(entries: Sequence[str], width: int) -> list[str]:
    """Distribute the entries of the help over lines that fit a window.

    Parameters
    ----------
    entries : sequence of str
        Such as ``click: what is there``; none is torn apart.
    width : int
        The window's width in pixels.
    """
    most = int((width - 2 * EDGE) / LETTER)
    lines: list[str] = []
    for entry in entries:
        longer = f"{lines[-1]}{BETWEEN}{entry}" if lines else ""
        if lines and len(longer) <= most:
            lines[-1] = longer
        else:
            lines.append(entry)
    return lines


def list_lines(rows: Sequence[str], columns: int, most: int) -> list[str]:
    """Shorten a list to the lines that there is room for, and say how many there are more.

    Parameters
    ----------
    rows : sequence of str
    columns : int
        The most letters of a line; longer ones end with an ellipsis.
    most : int
        The most lines.
    """
    shown = [row if len(row) <= columns else f"{row[: columns - 1]}…" for row in rows]
    if len(shown) <= most:
        return shown
    kept = max(most - 1, 0)
    return [*shown[:kept], f"and {len(shown) - kept} more"]


def add_lines(plotter: Any, lines: Sequence[str], *, name: str, top: float | None = None) -> None:
    """Write lines at the left of a window, in place of those of the same name.

    Parameters
    ----------
    plotter : pyvista.Plotter
    lines : sequence of str
    name : str
    top : float, optional
        Where the lines begin, in pixels below the top of the window; by default they end at its
        bottom.
    """
    if not lines:
        plotter.remove_actor(name, render=False)
        return
    height = plotter.window_size[1]
    place = (EDGE, EDGE) if top is None else (EDGE, height - top)
    actor = plotter.add_text(
        "\n".join(lines), position=place, color=INK, name=name, render=not plotter.off_screen
    )
    actor.prop.font_size = SMALL
    actor.prop.justification_vertical = "bottom" if top is None else "top"
