"""`bodymeasure paper`."""

from pathlib import Path

import click
from rich.table import Table
from rich.text import Text

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import print_files, print_table, progress_bar
from bodymeasure.cli.needs import PAGE, require
from bodymeasure.cli.options import folder_option, processes_option
from bodymeasure.cli.tables import new_table
from bodymeasure.files import output_folder
from bodymeasure.paper.data.published import MEAN_LOSS

SURFACE = ("Table 5", "igl", "libigl", "report")
NAMED = ("the methods that the paper names", "potpourri3d", "potpourri3d", "report")
CHARTS = ("the page's charts", "matplotlib", "matplotlib", "report")


@click.command(epilog=EXIT_CODES)
@folder_option(
    default=Path("paper"),
    help="Folder for paper.html, summary.md, tables.json and tables.csv; made if it is not there.",
)
@click.option("--quick", is_flag=True, help="Few patches: seconds instead of minutes.")
@click.option(
    "--seed",
    type=click.IntRange(min=0),
    metavar="N",
    default=2007,
    show_default=True,
    help="Seed of all random numbers; the same seed gives the same tables, except for times.",
)
@processes_option
def paper(output: Path, quick: bool, seed: int, processes: int) -> int:
    """Reproduce Ng, Pong and Wong (2007), and go on from there.

    It compares radial basis functions with Ritz's method on random patches, as in the paper's
    Tables 3 and 4, with the converged lengths beside them, and a body's diagonals with its surface,
    as in Table 5; and it measures distributed collocation, and the accuracy and cost of more
    functions.
    """
    require(PAGE, CHARTS, SURFACE, NAMED)
    with output_folder(output):
        # Slow imports, which `--help` does not need.
        from bodymeasure.paper.reproduce import reproduce
        from bodymeasure.paper.reproduction import Settings
        from bodymeasure.paper.write import write_reproduction

        settings = Settings(seed=seed, quick=quick, processes=processes)
        found = reproduce(settings, progress_bar)
        files = write_reproduction(found, output)
    print_table(_summary(found.table("closest").rows, sum(found.seconds.values())))
    print_files(files)
    return 0


def _summary(rows: tuple[tuple[object, ...], ...], seconds: float) -> Table:
    """Return what a reader wants to know first: the mean accuracy loss of each reading."""
    title = f"Mean accuracy loss (paper: {_percent(MEAN_LOSS)})"
    table = new_table("reading", "inside the patch", "of all solutions", title=title)
    for name, _, inside, every, *_rest in rows:
        table.add_row(str(name), _percent(inside), _percent(every))
    table.add_row("", "", "")
    table.add_row(Text("time", "dim"), f"{seconds:.0f} s", "")
    return table


def _percent(value: object) -> str:
    return f"{100.0 * value:.2f} %" if isinstance(value, float) else "-"
