"""Show a body in a cell of a notebook."""

from pathlib import Path
from typing import TYPE_CHECKING

from bodymeasure.viewer.page.given import given

from bodymeasure.atlas import Atlas, Unit
from bodymeasure.errors import InputError, MissingExtraError

if TYPE_CHECKING:
    from anywidget import AnyWidget

    from bodymeasure.chart import Chart
    from bodymeasure.measure import Survey

HEIGHTS = (200, 4000)


def show(
    shown: "Atlas | Chart | Survey | str | Path",
    *,
    unit: Unit | str | None = None,
    height: int = 620,
) -> "AnyWidget":
    """Show a body in a cell of a notebook, to be turned and measured by clicking.

    It is the page of ``bodymeasure view`` in the cell: tapes between points that are clicked,
    girths, landmarks, the list of a chart's measurements. What is clicked is measured in the
    notebook's kernel, on whatever machine that runs.

    Parameters
    ----------
    shown : Atlas, Chart, Survey, str or Path
        What the cell shows, or the name of a file with an atlas.
    unit : Unit or str, optional
        Unit of a file's coordinates, for formats that state none.
    height : int
        Height of the cell in pixels.

    Returns
    -------
    AnyWidget
        The widget, which a notebook displays as the value of a cell's last line.

    Raises
    ------
    MissingExtraError
        If anywidget is not installed, which the extra ``notebook`` brings.
    InputError
        If there is nothing to show, or the file cannot be read.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> view = bm.show(bm.load_sample("paraboloid"), height=400)
    >>> print(view.height)
    400
    """
    low, high = HEIGHTS
    if not (isinstance(height, int) and low <= height <= high):
        raise InputError(f"height is {height!r}; expected pixels from {low} to {high}")
    try:
        from bodymeasure.viewer.page.widget import BodyView
    except ModuleNotFoundError as error:
        if error.name not in ("anywidget", "traitlets"):
            raise
        raise MissingExtraError("a view in a notebook", "anywidget", "notebook") from None
    return BodyView(given(shown, unit), height=height)
