"""Writing a table of sizes: a page, CSV, and the mannequin of each size as an atlas."""

from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path

from bodymeasure.arguments import file_path, require_kind
from bodymeasure.atlas import Atlas
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
from bodymeasure.surveys.sizes.sizes import Size, SizeTable
from bodymeasure.threads import one_blas_thread

MANNEQUINS = "mannequins"


@one_blas_thread()
def write_sizes(
    table: SizeTable,
    folder: str | PathLike[str],
    *,
    made: Mapping[str, Atlas | str] | None = None,
) -> tuple[Path, ...]:
    """Write a table of sizes.

    Parameters
    ----------
    table : SizeTable
    folder : path-like
        For ``sizes.html``, ``sizes.csv`` with a row for each size, ``controls.csv`` with the other
        measurements of each, and ``mannequins`` with the surveyed body that is nearest to each, as
        an atlas. Made if it is not there.
    made : mapping of str to Atlas or str, optional
        Bodies that were made for the sizes, by their names, which are written besides; or words on
        why there is none. `make_body` makes a body with the key measurements of a size.

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
    bodies, words = ({}, []) if made is None else _made(table, place, made)
    contents = {
        "sizes.html": render_sizes(
            table,
            {number: path.name for number, path in mannequins.items()},
            {number: path.name for number, path in bodies.items()},
            words,
        ),
        "sizes.csv": _sizes_csv(table, words),
        "controls.csv": _controls_csv(table),
    }
    return (*write_files(place, contents), *mannequins.values(), *bodies.values())


def _made(
    table: SizeTable, folder: Path, made: Mapping[str, Atlas | str]
) -> tuple[dict[int, Path], list[str]]:
    """Write the bodies that were made; return them by the sizes' numbers, and words on each."""
    written, words = {}, []
    for number, size in enumerate(table.sizes):
        found = made.get(size.name, "none was made")
        words.append(found if isinstance(found, str) else "")
        if isinstance(found, Atlas):
            path = folder / MANNEQUINS / f"{_stem(size)}-made.atlas"
            make_folder(path.parent)
            write_atlas(found, path)
            written[number] = path
    return written, words


def _stem(size: Size) -> str:
    return size.name.replace("/", "-")


def _mannequins(table: SizeTable, folder: Path) -> dict[int, Path]:
    """Write the mannequins, and return their files by the numbers of the sizes."""
    survey = table.survey
    again = BodiesAgain(survey.path.parent.resolve(), settings_beside(survey))
    subjects, sources = survey.subjects, survey.sources
    written = {}
    # In the order of the survey, in which they are read the fastest.
    for number in sorted(range(len(table.sizes)), key=lambda each: table.sizes[each].mannequin):
        size = table.sizes[number]
        path = folder / MANNEQUINS / f"{_stem(size)}.atlas"
        try:
            atlas = again.atlas(subjects[size.mannequin], sources[size.mannequin])
        except BodymeasureError:
            continue
        make_folder(path.parent)
        write_atlas(atlas, path)
        written[number] = path
    return dict(sorted(written.items()))


def _sizes_csv(table: SizeTable, made: Sequence[str]) -> bytes:
    keys = [column.key for column in table.keys]
    columns = ["size", *keys]
    columns += [f"{key}_{end}" for key in keys for end in ("from", "to")]
    columns += ["bodies", "part", "together", "mannequin", "source", "distance"]
    columns += ["not_made"] if made else []
    rows: list[list[object]] = []
    for number, size in enumerate(table.sizes):
        row: list[object] = [size.name, *size.center.values()]
        for key, center in size.center.items():
            half = 0.5 * table.steps[key]
            row += [center - half, center + half]
        row += [size.bodies, size.part, size.together, table.survey.subjects[size.mannequin]]
        row += [table.survey.sources[size.mannequin], size.distance]
        rows.append([*row, made[number]] if made else row)
    return csv_bytes(columns, rows)


def _controls_csv(table: SizeTable) -> bytes:
    units = {column.key: column.unit for column in table.survey.measurements}
    rows = (
        (size.name, each.key, units[each.key], each.bodies, each.mean, each.deviation)
        for size in table.sizes
        for each in size.controls
    )
    return csv_bytes(("size", "key", "unit", "bodies", "mean", "deviation"), rows)


def render_sizes(
    table: SizeTable,
    mannequins: Mapping[int, str],
    bodies: Mapping[int, str] | None = None,
    words: Sequence[str] = (),
) -> bytes:
    """Return the page of a table of sizes, which loads nothing else.

    Parameters
    ----------
    table : SizeTable
    mannequins, bodies : mapping of int to str
        The files of the mannequins, and of bodies that were made, by the numbers of the sizes.
    words : sequence of str
        Why no body was made for each size, empty where one was; none if that was not asked for.

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
        "bodies": bodies or {},
        "words": words,
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
