"""`bodymeasure survey`."""

from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

import click

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import print_files, print_note, print_table
from bodymeasure.cli.needs import require
from bodymeasure.cli.options import (
    definitions_option,
    despite_errors_option,
    file_options,
    file_settings,
    folder_option,
    given_topology,
    only_option,
    processes_option,
    topology_option,
)
from bodymeasure.cli.surveys.progress import long_progress
from bodymeasure.cli.surveys.size import size_option
from bodymeasure.cli.tables import facts_table
from bodymeasure.errors import InputError
from bodymeasure.files import output_folder

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.surveys import SurveyTable

TABLE = ("the survey", "pyarrow", "pyarrow", "survey")
PAGE = ("the page of a survey (--no-page leaves it out)", "jinja2", "jinja2", "survey")
CLUSTER = ("a survey on a cluster", "distributed", "distributed", "cluster")
EXIT_FAILED = 1
# How many failures are printed; failures.csv has all.
NAMED = 5


@click.command(epilog=EXIT_CODES)
@click.argument("bodies", metavar="BODIES...", nargs=-1, required=True)
@file_options
@topology_option
@definitions_option
@folder_option(
    required=True,
    help="Folder for survey.parquet and the page, survey.html; made if it is not there.",
)
@only_option
@click.option(
    "--unit",
    type=click.Choice(["m", "cm", "mm", "inch"]),
    default="cm",
    show_default=True,
    help="Unit of the lengths.",
)
@processes_option
@click.option(
    "--scheduler",
    metavar="ADDRESS",
    help="Measure on the workers of Dask's scheduler there, such as tcp://host:8786, in place of "
    "processes on this machine. They have to see the files under the same names.",
)
@size_option
@click.option("--no-page", is_flag=True, help="Leave out the page and the CSV files.")
@despite_errors_option
def survey(
    bodies: tuple[str, ...],
    definitions: Path | None,
    output: Path,
    only: tuple[str, ...],
    unit: str,
    processes: int,
    scheduler: str | None,
    sizes: tuple[dict[str, float], ...],
    no_page: bool,
    despite_errors: bool,
) -> int:
    """Take the charts of many BODIES into one table, and say what they come to.

    BODIES are atlases and scans, folders of them, or one file .npz of many bodies: coefficients of
    the space of bodies, vertices of its mesh, or what bodymeasure.write_population writes
    (`bodymeasure docs surveys` has the formats).

    survey.parquet has a row for each body, with all digits and the errors. The page has percentiles
    with confidence intervals, distributions, correlations, bodies to look at, and the bodies that
    are nearest to a size. A body that cannot be read or measured is listed with the reason, and the
    others are measured all the same.

    A survey that was ended goes on where it was when the same command is given again.
    """
    require(TABLE, *(() if no_page else (PAGE,)), *((CLUSTER,) if scheduler else ()))
    # Slow imports, which `--help` does not need.
    from bodymeasure.atlas import Unit
    from bodymeasure.chart import load_definitions, selected_keys
    from bodymeasure.surveys import write_survey
    from bodymeasure.surveys.engine.cluster import connected
    from bodymeasure.surveys.records import Charting
    from bodymeasure.surveys.run import run_survey
    from bodymeasure.surveys.take import bodies_given, engine_of

    loaded = load_definitions(definitions)
    selected_keys(loaded, only)
    topology = given_topology()
    settings = {**file_settings(), **({} if topology is None else {"topology": topology})}
    found = bodies_given(bodies, output, settings)
    charting = Charting(loaded, only, Unit.parse(unit), despite_errors, found.layout)
    known = {column.key for column in charting.columns}
    for size in sizes:
        if not size.keys() <= known:
            missing = ", ".join(sorted(size.keys() - known))
            raise InputError(f"--size names {missing}, which the survey does not measure")
    cluster = nullcontext() if scheduler is None else connected(scheduler)
    try:
        with cluster as client, output_folder(output), long_progress("surveying") as progress:
            engine = engine_of(processes, client)
            table = run_survey(found, charting, output, engine, progress=progress)
    except KeyboardInterrupt:
        print_note("What is done is kept; the same command goes on from there.")
        raise
    files = [table.path]
    if not no_page:
        files = [*write_survey(table, sizes=sizes), table.path]
    print_table(_facts(table))
    print_files(files)
    failures = table.failures
    if failures:
        listed = "".join(f"\n  {each.subject}: {each.reason}" for each in failures[:NAMED])
        more = f"\n  and {len(failures) - NAMED} more" if len(failures) > NAMED else ""
        print_note(f"{len(failures)} of {len(table)} bodies could not be measured:{listed}{more}")
    return EXIT_FAILED if failures else 0


def _facts(table: "SurveyTable") -> "Table":
    facts = facts_table(f"Survey by the set “{table.definitions}”")
    facts.add_row("bodies", f"{len(table):,}")
    facts.add_row("measured", f"{len(table) - len(table.failures):,}")
    facts.add_row("measurements", f"{len(table.measurements):,}")
    return facts
