"""`bodymeasure compare`."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.text import Text

from bodymeasure.atlas import Unit
from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import RESULTS, print_note, print_table
from bodymeasure.cli.fitting.done import FILE as DONE
from bodymeasure.cli.inputs import lacks_unit, load_sound_atlas, path_of_atlas
from bodymeasure.cli.measuring.measured import measured_chart
from bodymeasure.cli.measuring.subjects import Subject, charts_of, subjects_of
from bodymeasure.cli.needs import CHART_PAGE, require
from bodymeasure.cli.options import definitions_option, despite_errors_option, file_options
from bodymeasure.cli.tables import new_table
from bodymeasure.errors import InputError
from bodymeasure.files import require_writable, write_bytes
from bodymeasure.formats import EXTENSIONS

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.chart import Definitions
    from bodymeasure.compare import Comparison, Readings

EXIT_EXCEEDS = 1
# The value of `bodymeasure.compare`, which is slow to load; a test keeps the two equal.
MINIMUM_SUBJECTS = 40
# Suffixes of files of values; any other file is an atlas.
READ_SUFFIXES = (".csv", ".json", ".parquet")
# The file of values in a folder that `chart -o` has written.
VALUES = "measurements.json"
# That in a folder of `survey`.
SURVEY = "survey.parquet"
# Files of atlases but for .json, which may hold values.
ATLASES = tuple(suffix for suffix in EXTENSIONS if suffix != ".json")
WRITTEN_SUFFIXES = (".csv", ".json", ".html")
COLORS = {"within": "green", "exceeds": "red", "too few subjects": "yellow"}


@click.command(epilog=EXIT_CODES)
@click.argument("first", metavar="A")
@click.argument("second", metavar="B")
@file_options
@definitions_option
@click.option(
    "--unit",
    type=click.Choice([unit.value for unit in Unit]),
    help="Unit of the lengths.  [default: that of A, or cm]",
)
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Write the differences to FILE: .csv, .json or .html.",
)
@click.option(
    "--minimum-subjects",
    type=click.IntRange(min=2),
    metavar="N",
    default=MINIMUM_SUBJECTS,
    show_default=True,
    help="Number of subjects from which on there is a verdict; the default is ISO 20685-1's.",
)
@despite_errors_option
def compare(
    first: str,
    second: str,
    definitions: Path | None,
    unit: str | None,
    output: Path | None,
    minimum_subjects: int,
    despite_errors: bool,
) -> int:
    """Compare the measurements of A with those of B; a difference is A - B.

    Each of the two is an atlas or a sample, which is measured; a chart's measurements.json or
    measurements.csv; a survey's survey.parquet; or a CSV file typed by hand, with the columns
    measurement (key or name), value, unit (m, cm, mm, inch, deg) and, if there are several,
    subject; values such as 94 cm need no column unit. --file-unit, --up and --front are for an
    atlas whose format says none.

    A folder that `chart -o` has written stands for its measurements.json, and one of `survey` for
    its survey.parquet.

    A folder of atlases, an .npz file of many bodies, and the files of `chart` for several bodies
    are several subjects, which are paired by their names.

    With several subjects, the mean difference of each measurement is assessed by ISO 20685-1: its
    95 % confidence interval has to lie within the maximum allowable error. Beside it stand the
    limits of agreement (Bland and Altman) and the intra-class correlation; an .html page has plots.
    """
    writer = _writer(output)
    # Slow imports, which `--help` does not need.
    from bodymeasure.chart import both_sides, load_definitions
    from bodymeasure.compare import compare as compared
    from bodymeasure.compare import known_from

    loaded = load_definitions(definitions)
    first, second = map(_values_in, (first, second))
    atlases = [name for name in (first, second) if not _is_file_of_values(name)]
    # With one that lacks a unit, --file-unit is meant for it; else it must not contradict.
    if_none = any(path_of_atlas(name).is_dir() or lacks_unit(name) for name in atlases)
    load = partial(load_sound_atlas, despite_errors=despite_errors, if_none=if_none)
    readings = [
        _readings(name, loaded, partial(subjects_of, load=load, despite_errors=despite_errors))
        for name in (first, second)
    ]
    if readings[0].name == readings[1].name:
        # Two charts of one body, for instance, are distinguished by their files.
        readings = [
            replace(each, name=name) for each, name in zip(readings, (first, second), strict=True)
        ]
    comparison = compared(
        *readings,
        known=known_from(both_sides(loaded.measurement)),
        unit=unit,
        minimum_subjects=minimum_subjects,
    )
    if output is not None:
        write_bytes(output, writer(comparison))
    _print(comparison)
    if output is not None:
        RESULTS.print(Text(str(output), "bold"), soft_wrap=True)
    exceeding = any(each.verdict == "exceeds" for each in comparison.agreements)
    return EXIT_EXCEEDS if exceeding else 0


def _writer(output: Path | None) -> "Callable[[Comparison], bytes]":
    """Return what makes the content of a file; refuse first a file that cannot be written."""
    if output is not None:
        suffix = output.suffix.lower()
        if suffix not in WRITTEN_SUFFIXES:
            raise InputError(
                f"{output}: expected a name that ends in one of {', '.join(WRITTEN_SUFFIXES)}"
            )
        if suffix == ".html":
            require(CHART_PAGE)
        require_writable(output)

    def write(comparison: "Comparison") -> bytes:
        from bodymeasure import compare
        from bodymeasure.report.serial import to_json

        assert output is not None
        writers: dict[str, Callable[[Comparison], bytes]] = {
            ".csv": compare.comparison_to_csv,
            ".json": to_json,
            ".html": compare.render_comparison,
        }
        return writers[output.suffix.lower()](comparison)

    return write


def _values_in(name: str) -> str:
    """Return the file of values in a folder of `chart -o` or `survey`; else the name as it is."""
    folder = Path(name)
    if (folder / SURVEY).is_file():
        return str(folder / SURVEY)
    values = folder / VALUES
    if not values.is_file():
        return name
    # Atlases are measured again, unless the chart's own fits are what lies beside the values.
    atlases = any(file.suffix.lower() in ATLASES for file in folder.iterdir())
    return str(values) if (folder / DONE).is_file() or not atlases else name


def _is_file_of_values(name: str) -> bool:
    return Path(name).suffix.lower() in READ_SUFFIXES


def _readings(
    name: str, definitions: "Definitions", bodies: Callable[[list[str]], list[Subject]]
) -> "Readings":
    from bodymeasure.compare import read_readings, readings_of, readings_of_subjects
    from bodymeasure.report.body import chart_document

    if _is_file_of_values(name):
        return read_readings(Path(name))
    subjects = bodies([name])
    if len(subjects) == 1:
        # Errors that were to be refused were refused when the atlas was loaded.
        chart = measured_chart(subjects[0].atlas, definitions, despite_errors=True)
        return readings_of(chart_document(chart, Unit.CM, subject=subjects[0].name))
    charts = charts_of(subjects, definitions, unit=Unit.CM)
    return readings_of_subjects(Path(name).name, [each for each, _ in subjects], charts)


def _print(comparison: "Comparison") -> None:
    from bodymeasure.compare.shown import summary

    several = len(comparison.subjects) > 1
    title = f"A {comparison.a}, B {comparison.b}, in {comparison.unit}"
    RESULTS.print(Text(title), soft_wrap=True)
    print_table(_agreements(comparison) if several else _differences(comparison))
    if several:
        RESULTS.print("\nISO 20685-1")
        print_table(_classes(comparison))
        if len(comparison.subjects) < comparison.minimum_subjects:
            print_note(
                f"{len(comparison.subjects)} subjects are not enough for a verdict of ISO 20685-1, "
                f"which takes {comparison.minimum_subjects}."
            )
    RESULTS.print(Text("\n" + "\n".join(summary(comparison))), soft_wrap=True)
    for note in comparison.notes:
        print_note(note)


def _differences(comparison: "Comparison") -> "Table":
    from bodymeasure.compare.shown import error_text, signed
    from bodymeasure.report.body import tape_text
    from bodymeasure.report.numbers import percent

    table = new_table("measurement", "A", "B", "A - B", "relative", "combined error")
    for each in comparison.differences:
        degrees = "°" if each.unit == "deg" else ""
        table.add_row(
            Text(each.name),
            tape_text(each.a, each.unit) + degrees,
            tape_text(each.b, each.unit) + degrees,
            signed(each.difference, each.unit) + degrees,
            percent(each.relative),
            error_text(each),
        )
    return table


def _agreements(comparison: "Comparison") -> "Table":
    from bodymeasure.compare.shown import icc, interval, limits, signed

    spread = ("subjects", "mean A - B", "95 % interval", "limits", "ICC", "largest")
    table = new_table("measurement", *spread, "class", "verdict")
    for each in comparison.agreements:
        table.add_row(
            Text(each.name),
            str(each.subjects),
            signed(each.mean, each.unit),
            interval(each),
            limits(each),
            icc(each),
            signed(each.largest, each.unit),
            each.accuracy_class or "",
            Text(each.verdict, COLORS.get(each.verdict, "")),
        )
    return table


def _classes(comparison: "Comparison") -> "Table":
    from bodymeasure.compare.shown import signed

    table = new_table("class", f"allowed, {comparison.unit}", "measurements", "within", "verdict")
    for each in comparison.classes:
        table.add_row(
            each.accuracy_class,
            signed(each.maximum_error, comparison.unit).lstrip("+"),
            str(each.measurements),
            str(each.within),
            Text(each.verdict, COLORS.get(each.verdict, "")),
        )
    return table
