"""The files of a chart: the page, and the outputs for programs, one module each."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from bodymeasure.arguments import file_path, require_members
from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError
from bodymeasure.report.body.freesewing import to_freesewing
from bodymeasure.report.body.from_chart import chart_document
from bodymeasure.report.body.garmentcode import to_garmentcode
from bodymeasure.report.body.page import TapePictures, render_chart
from bodymeasure.report.body.records import ChartDocument, chart_to_csv
from bodymeasure.report.body.smis import to_smis
from bodymeasure.report.files import write_files
from bodymeasure.report.serial import schema_bytes, to_json

if TYPE_CHECKING:
    from bodymeasure.chart import Chart

# The functions that make the files, by names in which {stem} stands for the name of the body. An
# output is added by its own module and one line here.
OUTPUTS: dict[str, Callable[[ChartDocument], bytes]] = {
    "measurements.json": to_json,
    "measurements.csv": chart_to_csv,
    "measurements.schema.json": lambda document: schema_bytes(type(document)),
    "{stem}.smis": to_smis,
    "freesewing.json": to_freesewing,
    "garmentcode.yaml": to_garmentcode,
}


def write_chart(
    chart: "Chart",
    folder: Path | str,
    *,
    unit: Unit | str = Unit.CM,
    stem: str = "body",
    pictures: TapePictures | bool | Literal["all"] = True,
    scene: bytes | None = None,
) -> tuple[Path, ...]:
    """Write ``chart.html``, ``measurements.json`` and ``.csv``, and files for pattern programs.

    These are a ``.smis`` file for SeamlyMe and Seamly2D, ``freesewing.json`` and
    ``garmentcode.yaml``. All files are computed before the first is written, and all are written
    or none.

    Parameters
    ----------
    chart : Chart
        The result of `measure_chart`.
    folder : Path or str
        Made if it is not there; files of these names in it are replaced.
    unit : Unit or str
        Unit of the lengths; angles stay in degrees.
    stem : str
        Name of the file for SeamlyMe, without its ``.smis``.
    pictures : bool, "all" or TapePictures
        Whether the page has pictures, which are drawn then; or pictures that are drawn already,
        by `bodymeasure.scene.tape_pictures`. Beside a `scene`, they are few: the body, but no
        measurement from near, unless "all" are wanted.
    scene : bytes, optional
        A page that shows the body with its tapes, to turn, which is put into ``chart.html``:
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
        If a measurement has a name that Seamly2D would not take, the folder cannot be made or
        written to, or the disk is full.

    Examples
    --------
    >>> import tempfile
    >>> from msgspec.structs import replace
    >>> import bodymeasure as bm
    >>> from bodymeasure.report.body import write_chart
    >>> definitions = bm.load_definitions()
    >>> bust = [each for each in definitions.measurement if each.key == "bust_girth"]
    >>> definitions = replace(definitions, measurement=tuple(bust), landmark=())
    >>> chart = bm.measure_chart(bm.load_sample("female_average"), definitions)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     files = write_chart(chart, folder, unit="inch", stem="anna", pictures=False)
    >>> [file.name for file in files][-3:]
    ['anna.smis', 'freesewing.json', 'garmentcode.yaml']
    """
    expected = "a Chart, as measure_chart returns it"
    require_members(chart, ("atlas", "measured"), "the chart", expected)
    file_path(folder, "the folder")
    if isinstance(pictures, str) and pictures != "all":
        raise InputError(f"pictures is {pictures!r}; expected True, False or 'all'")
    document = chart_document(chart, unit, subject=stem)
    drawn = _pictures(chart, pictures, scene)
    contents = {name.format(stem=stem): make(document) for name, make in OUTPUTS.items()}
    page = render_chart(document, drawn, scene=scene)
    return write_files(folder, {"chart.html": page, **contents})


def _pictures(
    chart: "Chart", wanted: TapePictures | bool | Literal["all"], scene: bytes | None
) -> TapePictures | None:
    if not isinstance(wanted, bool | str):
        return wanted
    if not wanted:
        return None
    # Matplotlib is slow to load, and not needed without pictures.
    from bodymeasure.scene import tape_pictures

    return tape_pictures(chart, few=scene is not None and wanted != "all")
