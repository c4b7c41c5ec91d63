"""Writing a chart's files."""

from pathlib import Path

from bodymeasure.files import make_folder, write_all
from bodymeasure.report.body.freesewing import to_freesewing
from bodymeasure.report.body.page import TapePictures, render_chart
from bodymeasure.report.body.records import (
    ChartDocument,
    chart_schema,
    chart_to_csv,
    chart_to_json,
)
from bodymeasure.report.body.smis import to_smis
from bodymeasure.report.serial import schema_bytes


def write_chart(
    document: ChartDocument,
    folder: Path,
    *,
    stem: str = "body",
    pictures: TapePictures | None = None,
) -> tuple[Path, ...]:
    """Write ``chart.html``, ``measurements.json`` and ``.csv``, and files for pattern programs.

    All are computed before the first is written, and all are written or none.

    Parameters
    ----------
    document : ChartDocument
        As `chart_document` makes it.
    folder : Path
        Made if it is not there; files of these names in it are replaced.
    stem : str
        Name of the file for SeamlyMe, without its ``.smis``.
    pictures : TapePictures, optional
        What `bodymeasure.scene.tape_pictures` returns; the page has none if not given.

    Returns
    -------
    tuple of Path
        The files, the page first.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed.
    InputError
        If a measurement has a name that Seamly2D would not take, the folder cannot be made or
        written to, or the disk is full.
    """
    contents = {
        folder / "chart.html": render_chart(document, pictures),
        folder / "measurements.json": chart_to_json(document),
        folder / "measurements.csv": chart_to_csv(document.measurements),
        folder / "measurements.schema.json": schema_bytes(chart_schema()),
        folder / f"{stem}.smis": to_smis(document),
        folder / "freesewing.json": to_freesewing(document),
    }
    make_folder(folder)
    write_all(contents)
    return tuple(contents)
