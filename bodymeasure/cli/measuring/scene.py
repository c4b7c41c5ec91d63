"""The scene that pages of charts and reports hold: their body, to turn."""

from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from bodymeasure.chart import Chart
    from bodymeasure.measure import Survey


def pictures_wanted(*, none: bool, every: bool) -> bool:
    """Return whether a page is to have pictures.

    Raises
    ------
    click.UsageError
        If both none and all are asked for.
    """
    if none and every:
        raise click.UsageError("--no-pictures and --all-pictures contradict each other.")
    return not none


def scene_of(shown: "Chart | Survey") -> bytes | None:
    """Return the page that turns the body of a chart or a survey.

    In a bare checkout, of which the viewer is no part, there is none.
    """
    try:
        from bodymeasure.viewer import export_page
    except ModuleNotFoundError as error:
        if error.name != "bodymeasure.viewer":
            raise
        return None
    # Installed under another name than its folder's, so that the type checker does not see it.
    page: bytes = export_page(shown)
    return page
