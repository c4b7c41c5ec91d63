"""`bodymeasure chart`."""

import time
from functools import partial
from pathlib import Path

import click

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import print_note
from bodymeasure.cli.fitting.files import fitted_in_words
from bodymeasure.cli.fitting.scans import is_scan, require_fit, scan_subject
from bodymeasure.cli.inputs import load_sound_atlas, require_sound
from bodymeasure.cli.measuring.many_scans import Charting, chart_scans
from bodymeasure.cli.measuring.measured import measured_chart
from bodymeasure.cli.measuring.one_chart import Wanted, print_one, write_one
from bodymeasure.cli.measuring.paths import check_paths_file
from bodymeasure.cli.measuring.scene import pictures_wanted
from bodymeasure.cli.measuring.several_charts import chart_several
from bodymeasure.cli.measuring.subjects import Subject, charts_of, subjects_of
from bodymeasure.cli.needs import CHART_PAGE, CHART_PICTURES, require
from bodymeasure.cli.options import (
    DEFAULT_SAMPLE,
    all_pictures_option,
    definitions_option,
    despite_errors_option,
    folder_option,
    format_option,
    length_unit,
    no_pictures_option,
    only_option,
    paths_option,
    picks_option,
    several_atlases_argument,
    topology_option,
    unit_option,
)


def _print_set(ctx: click.Context, _parameter: click.Parameter, wanted: bool) -> None:
    if not wanted or ctx.resilient_parsing:
        return
    from bodymeasure.chart import default_set

    click.echo(default_set(), nl=False)
    ctx.exit()


@click.command(epilog=EXIT_CODES)
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
@picks_option
@topology_option
@paths_option
@click.option(
    "--sensitivity",
    is_flag=True,
    help="Say by how much each value changes if a landmark lies 5 mm elsewhere; takes some five "
    "times as long.",
)
@unit_option
@no_pictures_option
@all_pictures_option
@despite_errors_option
def chart(
    atlases: tuple[str, ...],
    definitions: Path | None,
    output: Path | None,
    form: str | None,
    only: tuple[str, ...],
    picks: Path | None,
    paths_file: Path | None,
    sensitivity: bool,
    unit: str,
    no_pictures: bool,
    all_pictures: bool,
    despite_errors: bool,
) -> int:
    """Take the body measurements of ATLAS: girths, lengths over the skin, heights.

    They follow the smooth surface across its patches, and the tape is drawn taut where that is
    asked for. ATLAS is the average female sample if not given.

    ATLAS may be a scan, a triangle mesh in STL, PLY, OBJ, OFF or GLB: a body is fitted to it first,
    as `bodymeasure fit` does, and each value has the uncertainty of the scan beside it.

    Several of them, a folder of atlases or an .npz file of many bodies give one table with a row
    for each subject: population.html, wide.csv, summary.csv and measurements.csv. With scans among
    them, what fails is listed and the rest done, and a second run goes on where the first ended.

    The measurements are defined by a file: the default set (--print-set), or one of yours. Where
    both sides are measured, the files for pattern programs hold the wearer's right one.

    Measurements of the default set that lack a landmark are listed, but the exit code stays 0
    unless nothing is left; in a set of yours, or if --only names them, they lead to exit code 1.
    """
    if output is not None and form is not None:
        raise click.UsageError("--format is for printing; with -o, all formats are written.")
    begin = time.perf_counter()
    with_pictures = pictures_wanted(none=no_pictures, every=all_pictures) and output is not None
    require(
        *((CHART_PAGE,) if output is not None else ()),
        *((CHART_PICTURES,) if with_pictures else ()),
    )
    # Slow imports, which `--help` does not need.
    from bodymeasure.chart import load_definitions, selected_keys
    from bodymeasure.report.body import check_codes

    loaded_definitions = load_definitions(definitions)
    check_codes(loaded_definitions)
    selected_keys(loaded_definitions, only)
    asked_for = definitions is not None or any(
        name not in loaded_definitions.presets for name in only
    )
    if paths_file is not None:
        check_paths_file(paths_file)
    scans = [name for name in atlases if is_scan(name)]
    if scans:
        require_fit(page=output is not None, pictures=with_pictures)
    if picks is not None and (not scans or len(atlases) > 1):
        raise click.UsageError("--landmarks are the picks of one scan; chart it by itself.")
    several = len(atlases) > 1
    if several and scans and output is not None:
        if paths_file is not None:
            raise click.UsageError("--paths is for one body; chart them one by one.")
        return chart_scans(
            atlases,
            output,
            Charting(loaded_definitions, unit, only, sensitivity, despite_errors),
            pictures=with_pictures,
        )
    load = partial(load_sound_atlas, despite_errors=despite_errors, if_none=several)
    fit = None if not scans or several else scan_subject(scans[0], picks)
    if fit is None:
        bodies = subjects_of(atlases or (DEFAULT_SAMPLE,), load, despite_errors=despite_errors)
    else:
        print_note(fitted_in_words(fit), style="dim")
        require_sound(fit.atlas, scans[0], despite_errors=despite_errors)
        bodies = [Subject(Path(scans[0]).stem, fit.atlas)]
    unit = length_unit(unit, bodies[0].atlas)
    if len(bodies) > 1:
        if paths_file is not None:
            raise click.UsageError("--paths is for one body; chart them one by one.")
        charting = partial(
            charts_of, bodies, loaded_definitions, unit=unit, only=only, sensitivity=sensitivity
        )
        return chart_several(bodies, charting, output, form)
    body = bodies[0]
    measuring = partial(
        measured_chart,
        body.atlas,
        loaded_definitions,
        only=only,
        sensitivity=sensitivity,
        despite_errors=despite_errors,
    )
    wanted = Wanted(unit, asked_for, paths_file, with_pictures, all_pictures, begin)
    if output is None:
        return print_one(body, measuring, form or "table", wanted)
    return write_one(body, measuring, output, wanted, fit=fit)
