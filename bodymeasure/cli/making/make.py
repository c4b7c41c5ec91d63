"""`bodymeasure make`."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.text import Text

from bodymeasure.atlas import Unit
from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import RESULTS, print_files, print_note, print_table, progress_bar
from bodymeasure.cli.making.arguments import given_values, values_argument, vary_option
from bodymeasure.cli.options import definitions_option, only_option
from bodymeasure.cli.tables import new_table
from bodymeasure.errors import InputError
from bodymeasure.files import output_folder, require_writable, write_all

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.make import MadeBody

EXIT_LOOK = 1
VALUES = (".csv", ".json")


@click.command(epilog=EXIT_CODES)
@values_argument
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="FILE|FOLDER",
    help="The .atlas file to write; with several bodies, a folder.  [default: the name of the "
    "measurements, here]",
)
@click.option("--sex", type=click.Choice(["female", "male"]), help="Of the person, if known.")
@click.option(
    "--age", type=click.FloatRange(18.0, 90.0), metavar="YEARS", help="Of the person, if known."
)
@click.option(
    "--unit",
    type=click.Choice([unit.value for unit in Unit]),
    help="Unit of lengths that say none; never guessed.",
)
@definitions_option
@only_option
@vary_option
@click.option(
    "--tolerance",
    type=click.FloatRange(0.001, 50.0),
    default=0.1,
    show_default=True,
    metavar="MM",
    help="Standard deviation with which values are to be met; 3 to 5 for what a hand took.",
)
@click.option(
    "--components",
    type=click.IntRange(10, 120),
    default=120,
    show_default=True,
    metavar="N",
    help="Components of the space of bodies that are used.",
)
@click.option(
    "--values",
    "values_file",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Write the whole chart of each body with the standard deviation of each value to FILE: "
    ".csv, or .json with the coefficients, too.",
)
@click.option(
    "--despite-doubts",
    is_flag=True,
    help="Make the nearest body even if no body is likely to have the measurements.",
)
def make(
    measurements: tuple[str, ...],
    output: Path | None,
    sex: str | None,
    age: float | None,
    unit: str | None,
    definitions: Path | None,
    only: tuple[str, ...],
    vary: dict[str, list[str]] | None,
    tolerance: float,
    components: int,
    values_file: Path | None,
    despite_doubts: bool,
) -> int:
    """Make the most plausible body that has some MEASUREMENTS.

    MEASUREMENTS is a file, or three to forty of the chart's measurements as KEY=VALUE, such as
    bust_girth=88cm. Files are those of SeamlyMe (.smis) and Valentina (.vit), .json of FreeSewing
    or of a chart, and .csv: with the columns measurement, value and unit, or a table of sizes with
    one row for each size and the measurements as columns, which makes a body of each.

    A body is sought among those of a space of bodies; which values of it are known by how much is
    in --values. Sets that no body has are refused, with the measurement that is likely wrong; the
    exit code is 1 if there is something to look at.

    \b
    Examples:
      bodymeasure make ann.smis -o ann.atlas
      bodymeasure make bust_girth=88cm waist_girth=72cm hip_girth=97cm stature=168cm -o ann.atlas
      bodymeasure make ann.csv --vary bust_girth=+4cm,+8cm -o family
      bodymeasure make sizes.csv --sex female -o roll
      bodymeasure pattern roll/*.atlas --set skirt -o skirts
    """  # noqa: D301  (click wants the character itself)
    if values_file is not None and values_file.suffix.lower() not in VALUES:
        raise InputError(f"{values_file}: expected a name that ends in one of {', '.join(VALUES)}")
    # Slow imports, which `--help` does not need.
    from bodymeasure.chart import load_definitions
    from bodymeasure.cli.making.files import atlas_content, file_names, values_content
    from bodymeasure.make import grade_body, make_sizes

    loaded = load_definitions(definitions)
    sizes = given_values(measurements, loaded, unit, only)
    if vary and len(sizes) > 1:
        raise click.UsageError("--vary changes one body; give the measurements of one.")
    several = len(sizes) > 1 or bool(vary)
    names = file_names([one.name for one in sizes], output, several=several)
    folder = names.folder
    with output_folder(folder):
        for path in (names.single, values_file):
            if path is not None:
                require_writable(path)
        count = 1 + len(next(iter(vary.values()))) if vary else len(sizes)
        making: Callable[..., dict[str, MadeBody]]
        making = partial(grade_body, sizes[0], vary) if vary else partial(make_sizes, sizes)
        with progress_bar("making", count) as progress:
            made = making(
                sex=sex,
                age=age,
                definitions=loaded,
                tolerance=tolerance,
                components=components,
                despite_doubts=despite_doubts,
                progress=lambda done, _all: progress(done),
            )
        contents = {names.path_of(name): atlas_content(body) for name, body in made.items()}
        if values_file is not None:
            contents[values_file] = values_content(made, values_file)
        write_all(contents)
    for name, body in made.items():
        if several:
            RESULTS.print(Text(name, style="bold"))
        print_table(_table(body))
        _print_summary(body)
    print_files(contents)
    looks = False
    for name, body in made.items():
        begin = f"{name}: " if several else ""
        for words in (*body.notes, *body.warnings):
            print_note(f"{begin}{words}")
        looks |= bool(body.warnings)
    return EXIT_LOOK if looks else 0


def _table(body: "MadeBody") -> "Table":
    from bodymeasure.chart import both_sides
    from bodymeasure.report.units import LENGTH_DECIMALS

    every = {one.key: one.name for one in both_sides(body.definitions.measurement)}
    table = new_table("measurement", "asked", "body", "miss, mm")
    for one in body.asked:
        value, unit = one.value, one.value.unit
        decimals = LENGTH_DECIMALS.get(unit, 2)
        shown = f"{one.found:.{decimals}f} {unit}" if one.found == one.found else "none"
        miss = "" if unit == "deg" else f"{1e3 * one.miss / value.factor:.3f}"
        table.add_row(Text(every[value.key]), f"{value.value:.{decimals}f} {unit}", shown, miss)
    return table


def _print_summary(body: "MadeBody") -> None:
    away = body.coefficients - body.prior.mean
    RESULTS.print(
        f"{body.rounds} rounds; the largest miss of a length is {1e3 * body.largest_miss:.2g} mm; "
        f"chi-square {body.chi_square:.1f} for {len(body.asked)} measurements, which "
        f"{100.0 * body.probability:.3g} % of bodies exceed; largest coefficient "
        f"{abs(away).max():.1f}.",
        soft_wrap=True,
        highlight=False,
    )
