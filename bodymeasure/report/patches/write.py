"""Writing a report's files."""

from pathlib import Path

from bodymeasure.files import make_folder, write_all
from bodymeasure.report.patches.page import Pictures, render_html
from bodymeasure.report.patches.records import Document, json_schema, to_csv, to_json
from bodymeasure.report.serial import schema_bytes


def write_report(
    document: Document,
    folder: Path,
    *,
    pictures: Pictures | None = None,
) -> tuple[Path, ...]:
    """Write ``report.html``, ``measurements.json``, its schema and ``measurements.csv``.

    All are computed before the first is written, and all are written or none.

    Parameters
    ----------
    document : Document
        As `survey_document` makes it.
    folder : Path
        Made if it is not there; files of these names in it are replaced.
    pictures : Pictures, optional
        What `bodymeasure.scene.pictures` returns; the page has none if not given.

    Returns
    -------
    tuple of Path
        The files, the page first.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed.
    InputError
        If the folder cannot be made or written to, or the disk is full.
    """
    contents = {
        folder / "report.html": render_html(document, pictures),
        folder / "measurements.json": to_json(document),
        folder / "measurements.csv": to_csv(document.measurements),
        folder / "measurements.schema.json": schema_bytes(json_schema()),
    }
    make_folder(folder)
    write_all(contents)
    return tuple(contents)
