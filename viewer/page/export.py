"""A body, its chart or its survey as one file that any browser opens, without a server."""

from dataclasses import replace
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, Any

import numpy as np
from bodymeasure.viewer.content.body import body_message
from bodymeasure.viewer.content.chart import chart_content
from bodymeasure.viewer.content.layers import diagonals_content
from bodymeasure.viewer.page.compact import compact
from bodymeasure.viewer.page.document import page_of
from bodymeasure.viewer.page.given import Given, given

from bodymeasure.arguments import file_path
from bodymeasure.atlas import Atlas, Unit
from bodymeasure.files import write_bytes
from bodymeasure.threads import one_blas_thread

if TYPE_CHECKING:
    from bodymeasure.chart import Chart
    from bodymeasure.measure import Survey

# Steps along a patch's side: a page is mailed, and 8 show no facets at the size of a screen.
SEGMENTS = 8


@one_blas_thread()
def export_page(
    shown: "Atlas | Chart | Survey | str | Path",
    path: str | Path | None = None,
    *,
    unit: Unit | str | None = None,
) -> bytes:
    """Write a page that shows a body to turn, and needs no server and no network.

    It has the body with its landmarks, to be turned and picked on; of a chart, all tapes and a
    list of the measurements to search; of a survey, both diagonals of each patch, colored by their
    difference from the mesh. It shows what was measured, and measures nothing itself but straight
    distances.

    Parameters
    ----------
    shown : Atlas, Chart, Survey, str or Path
        What the page shows, or the name of a file with an atlas.
    path : str or Path, optional
        Where the page is written, as HTML; a file of that name is replaced. By default it is only
        returned, as `bodymeasure.write_chart` takes it for its ``scene``.
    unit : Unit or str, optional
        Unit of a file's coordinates, for formats that state none.

    Returns
    -------
    bytes
        The page.

    Raises
    ------
    InputError
        If there is nothing to show, or a file cannot be read or written.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> page = bm.export_page(bm.load_sample("paraboloid"))
    >>> page[:15], len(page) < 1_000_000
    (b'<!doctype html>', True)
    """
    if path is not None:
        file_path(path, "the path")
    page = exported(given(shown, unit))
    if path is not None:
        write_bytes(Path(path), page)
    return page


def exported(content: Given) -> bytes:
    """Return the page of what is to be shown."""
    body, chart, survey = content
    # A page that is mailed does not tell where the file lies at home.
    body = replace(body, finest=SEGMENTS, file=PurePath(body.file).name)
    data = _data(Given(body, chart, survey))
    return page_of(f"{body.name or 'a body'} · bodymeasure", data)


def _data(content: Given) -> dict[str, Any]:
    """Return what the page holds: messages as text, and with what it begins."""
    body, chart, survey = content
    size = float(np.ptp(body.atlas.points, axis=0).max()) * body.meters
    options: dict[str, Any] = {"tool": "look"}
    data: dict[str, Any] = {"body": compact(body_message(body), size), "options": options}
    if chart is not None:
        data["chart"] = compact(chart_content(body, chart), size)
        options["chart"] = True
    if survey is not None:
        check = survey.cross_check
        differences = None if check is None else check.relative_difference
        lines = diagonals_content(body, survey.diagonals, differences)
        data["layers"] = {"diagonals": compact(lines, size)}
        options["settings"] = {
            "layers": {"diagonals": True},
            "lines": "error" if check is None else "difference",
        }
    return data
