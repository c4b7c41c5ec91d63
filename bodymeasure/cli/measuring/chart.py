"""`bodymeasure chart`."""

import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.text import Text

from bodymeasure.cli.console import (
    RESULTS,
    count_calls,
    print_files,
    print_note,
    print_table,
    progress_bar,
)
from bodymeasure.cli.measuring.paths import check_paths_file, tape_curves, write_curves
from bodymeasure.cli.measuring.subjects import Subject, charts_of, subjects_of
from bodymeasure.cli.options import (
    CHART_PAGE,
    CHART_PICTURES,
    DEFAULT_SAMPLE,
    EXIT_CODES,
    definitions_option,
    despite_errors_option,
    folder_option,
    format_option,
    length_unit,
    load_sound_atlas,
    no_pictures_option,
    only_option,
    paths_option,
    require,
    several_atlases_argument,
    unit_option,
)
from bodymeasure.cli.tables import facts_table, new_table
from bodymeasure.errors import InputError
from bodymeasure.files import output_folder

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.atlas import Atlas
    from bodymeasure.chart import Chart, Definitions
    from bodymeasure.report.body import BodyRecord, ChartDocument, TapePictures
    from bodymeasure.report.population import PopulationDocument

EXIT_NOT_MEASURED = 1
# Outcomes of measurements that lack a landmark. No body has all landmarks of the default set.
ABSENT = ("missing landmark", "missing operand")
SIDES = 4
# The number of names that are listed of what could not be measured; the page has all.
NAMED = 6
# The number of points to pick that are listed.
PICKS = 3


def _print_set(ctx: click.Context, _parameter: click.Parameter, wanted: bool) -> None:
    if not wanted or ctx.resilient_parsing:
        return
    from bodymeasure.chart import default_set

    click.echo(default_set(), nl=False)
    ctx.exit()


@click.command(short_help="Chart the body measurements of a body.", epilog=EXIT_CODES)
@several_atlases_argument
@definitions_option
@folder_option(
    help="Folder for chart.html, measurements.csv, measurements.json and its schema, and files for "
    "pattern programs: a .smis file for SeamlyMe, freesewing.json and garmentcode.yaml; made if it "
    "is not there. Without it, the chart is printed.",
)
@format_option(
    default=None,
    show_default=False,
    help="Format of the chart where it is printed.  [default: table]",
)
@click.option(
    "--print-set",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_print_set,
    help="Print the default set, which may be copied and changed, and exit.",
)
@only_option
@paths_option
@click.option(
    "--sensitivity",
    is_flag=True,
    help="Say by how much each value changes if a landmark lies 5 mm elsewhere; takes some five "
    "times as long.",
)
@unit_option
@no_pictures_option
@despite_errors_option
def chart(
    atlases: tuple[str, ...],
    definitions: Path | None,
    output: Path | None,
    form: str | None,
    only: tuple[str, ...],
    paths_file: Path | None,
    sensitivity: bool,
    unit: str,
    no_pictures: bool,
    despite_errors: bool,
) -> int:
    """Take the body measurements of ATLAS: girths, lengths over the skin, heights.

    They follow the smooth surface across its patches, and the tape is drawn taut where that is
    asked for. ATLAS is the average female sample if not given.

    Several of them, a folder of atlases or an .npz file of many bodies give one table with a row
    for each subject: population.html, wide.csv, summary.csv and measurements.csv.

    The measurements are defined by a file: the default set (--print-set), or one of yours. Where
    both sides are measured, the files for pattern programs hold the wearer's right one.

    Measurements of the default set that lack a landmark are listed, but the exit code stays 0
    unless nothing is left; in a set of yours, or if --only names them, they lead to exit code 1.
    """
    if output is not None and form is not None:
        raise click.UsageError("--format is for printing; with -o, all formats are written.")
    begin = time.perf_counter()
    pictures_wanted = output is not None and not no_pictures
    require(
        *((CHART_PAGE,) if output is not None else ()),
        *((CHART_PICTURES,) if pictures_wanted else ()),
    )
    # Slow imports, which `--help` does not need.
    from bodymeasure.chart import load_definitions, selected_keys
    from bodymeasure.report.body import chart_document, check_codes, write_chart

    loaded_definitions = load_definitions(definitions)
    check_codes(loaded_definitions)
    selected_keys(loaded_definitions, only)
    asked_for = definitions is not None or any(
        name not in loaded_definitions.presets for name in only
    )
    if paths_file is not None:
        check_paths_file(paths_file)
    several = len(atlases) > 1
    load = partial(load_sound_atlas, despite_errors=despite_errors, if_none=several)
    bodies = subjects_of(atlases or (DEFAULT_SAMPLE,), load, despite_errors=despite_errors)
    if len(bodies) > 1:
        unit = length_unit(unit, bodies[0].atlas)
        if paths_file is not None:
            raise click.UsageError("--paths is for one body; chart them one by one.")
        charting = partial(
            charts_of, bodies, loaded_definitions, unit=unit, only=only, sensitivity=sensitivity
        )
        return _population(bodies, charting, output, form)
    body = bodies[0].atlas
    unit = length_unit(unit, body)
    measuring = partial(
        measured_chart,
        body,
        loaded_definitions,
        only=only,
        sensitivity=sensitivity,
        despite_errors=despite_errors,
    )
    if output is None:
        measured = measuring()
        document = chart_document(measured, unit)
        if paths_file is not None:
            write_curves(paths_file, body, tape_curves(measured))
        _print(document, form or "table")
        return _exit_code(document, asked_for=asked_for)
    with output_folder(output):
        measured = measuring()
        pictures = _pictures(measured) if pictures_wanted else None
        stem = bodies[0].name
        files = write_chart(measured, output, unit=unit, stem=stem, pictures=pictures or False)
    document = chart_document(measured, unit)
    if paths_file is not None:
        write_curves(paths_file, body, tape_curves(measured))
        files = (*files, paths_file)
    print_table(_summary(document, time.perf_counter() - begin))
    print_files(files)
    if pictures is not None and pictures.note:
        print_note(pictures.note)
    code = _exit_code(document, asked_for=asked_for)
    if code:
        print_note("Some measurements could not be taken; see “Not measured” in chart.html.")
    return code


def _population(
    bodies: Sequence[Subject],
    charting: Callable[[], list["ChartDocument"]],
    output: Path | None,
    form: str | None,
) -> int:
    """Chart several bodies; return 1 if a subject lacks a value that others have."""
    from bodymeasure.report.population import population_document, write_population_chart

    names = [name for name, _ in bodies]
    if output is None:
        document = population_document(names, charting())
        _print_population(document, form or "table")
    else:
        with output_folder(output):
            document = population_document(names, charting())
            files = write_population_chart(document, output)
        print_table(_population_facts(document))
        print_files(files)
    return EXIT_NOT_MEASURED if any(each.missing for each in document.summaries) else 0


def _print_population(document: "PopulationDocument", form: str) -> None:
    from bodymeasure.report.body import tape_text
    from bodymeasure.report.population import long_csv
    from bodymeasure.report.serial import to_json

    if form == "json":
        click.echo(to_json(document), nl=False)
        return
    if form == "csv":
        click.echo(long_csv(document), nl=False)
        return
    table = new_table(
        "measurement", "subjects", f"mean, {document.unit}", "deviation", "least", "greatest"
    )
    for each in document.summaries:
        degrees = "°" if each.unit != document.unit else ""
        values = (each.mean, each.deviation, each.minimum, each.maximum)
        shown = (tape_text(value, each.unit) + degrees for value in values)
        table.add_row(Text(each.name), str(each.subjects), *shown)
    print_table(table)


def _population_facts(document: "PopulationDocument") -> "Table":
    table = facts_table(f"{len(document.subjects)} subjects")
    table.add_row("set", Text(document.definitions))
    table.add_row("subjects", Text(_first(document.subjects)))
    total = len(document.summaries)
    whole = sum(each.missing == 0 for each in document.summaries)
    color = "green" if whole == total else "yellow"
    table.add_row("measured", Text(f"{whole:,} of {total:,} on every subject", color))
    lacking = [f"{each.name} ({each.missing})" for each in document.summaries if each.missing]
    if lacking:
        table.add_row("", Text(f"without a value on some: {_first(lacking)}", "yellow"))
    return table


def measured_chart(
    atlas: "Atlas",
    definitions: "Definitions",
    *,
    only: Sequence[str] = (),
    sensitivity: bool = False,
    despite_errors: bool = False,
) -> "Chart":
    """Measure a body, with a progress bar.

    Raises
    ------
    InputError
        If the set of definitions is empty.
    """
    from bodymeasure.chart import both_sides, measure_chart, restricted

    total = len(both_sides(restricted(definitions, only)[0].measurement))
    if not total:
        raise InputError(f"the set {definitions.name!r} defines no measurement; add one to it")
    with progress_bar("measuring", total) as progress:
        return measure_chart(
            atlas,
            definitions,
            only=only,
            sensitivity=sensitivity,
            progress=lambda done, _total: progress(done),
            despite_errors=despite_errors,
        )


def _pictures(chart: "Chart") -> "TapePictures":
    from bodymeasure.scene import tape_pictures

    drawn = [item for item in chart.measured if item.tapes]
    # The bar may end early, since not all sides of all groups are drawn.
    most = SIDES * len({item.definition.group for item in drawn}) + len(drawn)
    with progress_bar("drawing", most) as progress:
        return tape_pictures(chart, advance=count_calls(progress))


def _exit_code(document: "ChartDocument", *, asked_for: bool) -> int:
    """Return 1 if a measurement failed although its landmarks are there, or if none was taken.

    A user's own set of definitions asks for all of its measurements, and so do keys.
    """
    outcomes = [record.outcome for record in document.measurements]
    harmless = ("measured", *(() if asked_for else ABSENT))
    wanting = "measured" not in outcomes or any(each not in harmless for each in outcomes)
    return EXIT_NOT_MEASURED if wanting else 0


def _print(document: "ChartDocument", form: str) -> None:
    from bodymeasure.report.body import chart_to_csv, scan_sentences
    from bodymeasure.report.serial import to_json

    # Bytes are UTF-8, whatever the encoding of the terminal.
    if form == "json":
        click.echo(to_json(document), nl=False)
    elif form == "csv":
        click.echo(chart_to_csv(document), nl=False)
    else:
        print_table(_table(document))
        for sentence in (*(document.approximation or ()), *scan_sentences(document)):
            RESULTS.print(Text(f"\n{sentence}"), soft_wrap=True)
        reasons = _reasons(document)
        if reasons:
            RESULTS.print(Text("\n".join(["", *reasons])), soft_wrap=True)


def _reasons(document: "ChartDocument") -> list[str]:
    """Return why measurements have no value, and remarks, each cause once."""
    from bodymeasure.report.body import absences, gains, remarked

    lines = []
    for each in gains(document):
        lines.append(f"pick {each.landmarks} to gain {each.count}: {each.measurements}")
        lines += (f"    {place}" for place in each.places)
    if lines:
        lines.append("`bodymeasure landmarks add` adds landmarks.")
    lines += (f"{each.names}: {each.reason}" for each in absences(document))
    return [*lines, *(f"{record.name}: {record.reason}" for record in remarked(document))]


def _table(document: "ChartDocument") -> "Table":
    from bodymeasure.report.body import input_text, largest_shift, tailor_inches, tape_text

    inches = document.unit == "inch"
    lengths = (document.unit, *(("fraction",) if inches else ()), "along skin", "taut", "error")
    shifted = any(record.shifts for record in document.measurements)
    lengths = (*lengths, *(("5 mm off",) if shifted else ()))
    if document.scan:
        lengths = (*lengths, "from the scan")
    if document.approximation:
        lengths = (*lengths, "approximation", "on the mesh")
    table = new_table("measurement", *lengths, "status", words=("status",))
    group = ""
    for record in document.measurements:
        if record.group != group:
            group = record.group
            table.add_row(Text(group, "bold"))
        error = record.error_estimate
        angle = record.unit != document.unit

        def shown(value: float | None, unit: str = record.unit, error: float | None = error) -> str:
            return "" if value is None else tape_text(value, unit, error)

        value = f"{shown(record.value)}°" if angle and record.value is not None else None
        fraction = "" if angle or record.value is None else tailor_inches(record.value, error)
        good = record.outcome == "measured"
        table.add_row(
            Text(record.name),
            value or shown(record.value),
            *((fraction,) if inches else ()),
            shown(record.contact),
            shown(record.taut),
            "" if error is None or record.value is None else f"{error:.0e}",
            *((largest_shift(record),) if shifted else ()),
            *((input_text(record),) if document.scan else ()),
            *(_costs(record) if document.approximation else ()),
            Text(record.outcome, "" if good else "yellow"),
        )
    return table


def _costs(record: "BodyRecord") -> tuple[str, str]:
    """Return the error from the approximation and the difference on the mesh."""
    error, difference = record.approximation_error, record.mesh_difference
    return f"{error:.0e}" if error else "", f"{difference:+.1g}" if difference else ""


def _summary(document: "ChartDocument", seconds: float) -> "Table":
    """Return the facts that a reader wants to know first."""
    from bodymeasure.report.body import FREESEWING_KEYS, gains, missing_freesewing

    table = facts_table(document.name)
    total, measured = len(document.measurements), document.outcomes.get("measured", 0)
    table.add_row("set", Text(document.definitions))
    table.add_row(
        "measured", Text(f"{measured:,} of {total:,}", "green" if measured == total else "yellow")
    )
    for outcome in document.outcomes:
        if outcome != "measured":
            table.add_row("", Text(f"{outcome}: {_named(document, outcome)}", "yellow"))
    for number, pick in enumerate(gains(document)[:PICKS]):
        words = f"{pick.landmarks}, which gains {pick.count}"
        table.add_row("" if number else "to pick", Text(words, "yellow"))
    absent = missing_freesewing(document)
    given = len(FREESEWING_KEYS) - len(absent)
    table.add_row("FreeSewing", f"{given} of {len(FREESEWING_KEYS)} keys")
    if absent:
        table.add_row("", Text(f"missing: {', '.join(absent)}"))
    table.add_row("time", f"{seconds:.1f} s")
    return table


def _named(document: "ChartDocument", outcome: str) -> str:
    return _first([record.name for record in document.measurements if record.outcome == outcome])


def _first(names: list[str]) -> str:
    """Return the first names, and how many more there are."""
    more = len(names) - NAMED
    # Names have commas in them.
    return "; ".join(names[:NAMED]) + (f"; and {more} more" if more > 0 else "")
