"""The style of all figures, whatever they show."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from bodymeasure.errors import MissingExtraError
from bodymeasure.scene.figures.canvas import INK

TEXT_SIZE = 9.0
STYLE: Any = {
    "svg.hashsalt": "bodymeasure",  # the same chart gives the same file
    "svg.fonttype": "none",  # text stays text: it can be searched, and takes the page's size
    "font.family": "sans-serif",
    "font.size": TEXT_SIZE,
    "axes.edgecolor": INK,
    "text.color": INK,
    "axes.labelcolor": INK,
    "xtick.color": INK,
    "ytick.color": INK,
}


@contextmanager
def chart_style(what: str = "a chart", extra: str = "report") -> Iterator[None]:
    """Apply matplotlib's settings for figures for as long as one is drawn.

    Parameters
    ----------
    what, extra : str
        The name of what is drawn, and the extra that installs matplotlib for it.

    Raises
    ------
    MissingExtraError
        If matplotlib is not installed.
    """
    try:
        from matplotlib import rc_context
    except ImportError:
        raise MissingExtraError(what, "matplotlib", extra) from None
    with rc_context(STYLE):
        yield


def power_of_ten(power: int) -> str:
    """Write a power of ten in plain letters, which need no fonts of matplotlib's own."""
    return "10" + str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
