"""The files of a report: the page, the records as JSON and CSV, and their schema."""

from pathlib import Path
from typing import TYPE_CHECKING, Literal

from bodymeasure.arguments import file_path, require_members
from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError
from bodymeasure.report.files import write_files
from bodymeasure.report.patches.from_survey import survey_document
from bodymeasure.report.patches.page import Pictures, render_html
from bodymeasure.report.patches.ranking import closeup_patches
from bodymeasure.report.patches.records import Document, to_csv
from bodymeasure.report.serial import schema_bytes, to_json

if TYPE_CHECKING:
    from bodymeasure.measure import Survey


def write_report(
    survey: "Survey",
    folder: Path | str,
    *,
    unit: Unit | str = Unit.CM,
    pictures: Pictures | bool | Literal["all"] = True,
    scene: bytes | None = None,
) -> tuple[Path, ...]:
    """Write ``report.html``, ``measurements.json``, ``measurements.csv`` and the schema.

    All files are computed before the first is written, and all are written or none.

    Parameters
    ----------
    survey : Survey
        The result of `measure_atlas`.
    folder : Path or str
        Made if it is not there; files of these names in it are replaced.
    unit : Unit or str
        Unit of the lengths.
    pictures : bool, "all" or Pictures
        Whether the page has pictures, which are drawn then; or pictures that are drawn already,
        by `bodymeasure.scene.pictures`. Beside a `scene`, which shows more, they are only drawn
        for "all".
    scene : bytes, optional
        A page that shows the body with its diagonals, to turn, which is put into ``report.html``:
        `bodymeasure.export_page` makes it.

    Returns
    -------
    tuple of Path
        The files, the page first.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed, or pictures are to be drawn without matplotlib.
    InputError
        If the folder cannot be made or written to, or the disk is full.

    Examples
    --------
    >>> import tempfile
    >>> import bodymeasure as bm
    >>> from bodymeasure.report import write_report
    >>> survey = bm.measure_atlas(bm.load_sample("paraboloid"), compare=False)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     files = write_report(survey, folder, unit="mm", pictures=False)
    >>> [file.name for file in files]
    ['report.html', 'measurements.json', 'measurements.csv', 'measurements.schema.json']
    """
    expected = "a Survey, as measure_atlas returns it"
    require_members(survey, ("atlas", "diagonals"), "the survey", expected)
    file_path(folder, "the folder")
    if isinstance(pictures, str) and pictures != "all":
        raise InputError(f"pictures is {pictures!r}; expected True, False or 'all'")
    document = survey_document(survey, unit)
    drawn = _pictures(survey, document, pictures, scene)
    return write_files(
        folder,
        {
            "report.html": render_html(document, drawn, scene=scene),
            "measurements.json": to_json(document),
            "measurements.csv": to_csv(document.measurements),
            "measurements.schema.json": schema_bytes(Document),
        },
    )


def _pictures(
    survey: "Survey",
    document: Document,
    wanted: Pictures | bool | Literal["all"],
    scene: bytes | None,
) -> Pictures | None:
    if not isinstance(wanted, bool | str):
        return wanted
    if not wanted or (scene is not None and wanted is True):
        return None
    # Matplotlib is slow to load, and not needed without pictures.
    from bodymeasure.scene import pictures as draw

    return draw(survey, closeup_patches(document))
