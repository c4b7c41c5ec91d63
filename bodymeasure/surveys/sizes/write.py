"""Writing a table of sizes: a page, CSV, and the mannequin of each size as an atlas."""

from os import PathLike
from pathlib import Path

from bodymeasure.arguments import file_path, require_kind
from bodymeasure.errors import BodymeasureError
from bodymeasure.files import make_folder
from bodymeasure.formats import write_atlas
from bodymeasure.report.body import tape_text
from bodymeasure.report.files import write_files
from bodymeasure.report.numbers import percent
from bodymeasure.report.serial import csv_bytes
from bodymeasure.report.templating import render_page
from bodymeasure.report.units import UNIT_NAMES
from bodymeasure.surveys.bodies.again import BodiesAgain
from bodymeasure.surveys.page.links import settings_beside
from bodymeasure.surveys.sizes.sizes import SizeTable
from bodymeasure.threads import one_blas_thread

MANNEQUINS = "mannequins"


@one_blas_thread()
def write_sizes(table: SizeTable, folder: str | PathLike[str]) -> tuple[Path, ...]:
    """Write a table of sizes.

    Parameters
    ----------
    table : SizeTable
    folder : path-like
        For ``sizes.html``, ``sizes.csv`` with a row for each size, ``controls.csv`` with the other
        measurements of each, and ``mannequins`` with the surveyed body that is nearest to each, as
        an atlas. Made if it is not there.

    Returns
    -------
    tuple of Path
        The files, the page first. The mannequin of a body that cannot be read any more is not
        among them.

    Raises
    ------
    InputError
        If the folder cannot be written to.
    MissingExtraError
        If jinja2 is not installed.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> with TemporaryDirectory() as folder:
    ...     survey = bm.survey(["female_average"], folder=folder, only=["bust_girth"])
    ...     table = bm.size_table(survey, bm.StepSizes({"bust_girth": 4.0}))
    ...     [path.name for path in bm.write_sizes(table, folder)]
    ['sizes.html', 'sizes.csv', 'controls.csv', '84.atlas']
    """
    require_kind(table, SizeTable, "the table", "what size_table returns")
    place = file_path(folder, "the folder")
    make_folder(place)
    mannequins = _mannequins(table, place)
    contents = {
        "sizes.html": render_sizes(
            table, {number: path.name for number, path in mannequins.items()}
        ),
        "sizes.csv": _sizes_csv(table),
        "controls.csv": _controls_csv(table),
    }
    return (*write_files(place, contents), *mannequins.values())


def _mannequins(table: SizeTable, folder: Path) -> dict[int, Path]:
    """Write the mannequins, and return their files by the numbers of the sizes."""
    survey = table.survey
    again = BodiesAgain(survey.path.parent.resolve(), settings_beside(survey))
    subjects, sources = survey.subjects, survey.sources
    written = {}
    # In the order of the survey, in which they are read the fastest.
    for number in sorted(range(len(table.sizes)), key=lambda each: table.sizes[each].mannequin):
        size = table.sizes[number]
        path = folder / MANNEQUINS / f"{size.name.replace('/', '-')}.atlas"
        try:
            atlas = again.atlas(subjects[size.mannequin], sources[size.mannequin])
        except BodymeasureError:
            continue
        make_folder(path.parent)
        write_atlas(atlas, path)
        written[number] = path
    return dict(sorted(written.items()))


def _sizes_csv(table: SizeTable) -> bytes:
    keys = [column.key for column in table.keys]
    columns = ["size", *keys]
    columns += [f"{key}_{end}" for key in keys for end in ("from", "to")]
    columns += ["bodies", "part", "together", "mannequin", "source", "distance"]
    rows: list[list[object]] = []
    for size in table.sizes:
        row: list[object] = [size.name, *size.center.values()]
        for key, center in size.center.items():
            half = 0.5 * table.steps[key]
            row += [center - half, center + half]
        row += [size.bodies, size.part, size.together, table.survey.subjects[size.mannequin]]
        rows.append([*row, table.survey.sources[size.mannequin], size.distance])
    return csv_bytes(columns, rows)


def _controls_csv(table: SizeTable) -> bytes:
    units = {column.key: column.unit for column in table.survey.measurements}
    rows = (
        (size.name, each.key, units[each.key], each.bodies, each.mean, each.deviation)
        for size in table.sizes
        for each in size.controls
    )
    return csv_bytes(("size", "key", "unit", "bodies", "mean", "deviation"), rows)


def render_sizes(table: SizeTable, mannequins: dict[int, str]) -> bytes:
    """Return the page of a table of sizes, which loads nothing else.

    Parameters
    ----------
    table : SizeTable
    mannequins : dict of int to str
        The files of the mannequins by the numbers of the sizes.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed.
    """
    survey = table.survey
    keys = {column.key for column in table.keys}
    controls = [
        (column, [size.controls[number] for size in table.sizes])
        for number, column in enumerate(survey.measurements)
        if column.key not in keys and any(size.controls[number].bodies for size in table.sizes)
    ]
    context = {
        "table": table,
        "subjects": [survey.subjects[size.mannequin] for size in table.sizes],
        "mannequins": mannequins,
        "folder": MANNEQUINS,
        "controls": controls,
        "unit_name": UNIT_NAMES[survey.unit],
    }
    return render_page(
        "bodymeasure.surveys",
        "sizes.html.j2",
        context,
        feature="the page of sizes",
        styles=("measurements.css",),
        filters={"tape": tape_text, "part": lambda value: percent(value, 1).lstrip("+")},
    )
