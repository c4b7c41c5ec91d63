"""`bodymeasure paper`."""

from pathlib import Path

import click
from rich.table import Table
from rich.text import Text

from bodymeasure.cli.console import RESULTS, print_table, progress_bar
from bodymeasure.cli.options import EXIT_CODES, PAGE, processes_option, require
from bodymeasure.files import output_folder
from bodymeasure.paper.data.published import MEAN_LOSS

SURFACE = ("Table 5", "igl", "libigl", "report")
CHARTS = ("the page's charts", "matplotlib", "matplotlib", "report")


@click.command(
    short_help="Reproduce the paper of 2007: its tables, beside the truth.", epilog=EXIT_CODES
)
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path, file_okay=True),
    metavar="FOLDER",
    default=Path("paper"),
    show_default=True,
    help="Folder for paper.html, summary.md, tables.json and tables.csv; made if it is not there.",
)
@click.option("--quick", is_flag=True, help="Few patches: seconds instead of minutes.")
@click.option(
    "--seed",
    type=click.IntRange(min=0),
    metavar="N",
    default=2007,
    show_default=True,
    help="Of all that is random; the same seed gives the same tables, timings aside.",
)
@processes_option
def paper(output: Path, quick: bool, seed: int, processes: int) -> int:
    """Reproduce Ng, Pong and Wong (2007), and go on from there.

    Radial basis functions against Ritz's method on random patches, as in the paper's Tables 3 and
    4, with the converged lengths beside them; a body's diagonals against its surface, as in Table
    5; distributed collocation; accuracy and cost of more functions.
    """
    require(PAGE, CHARTS, SURFACE)
    with output_folder(output):
        # Not needed by `--help` and the like, and slow to load.
        from bodymeasure.paper.reproduce import reproduce
        from bodymeasure.paper.reproduction import Settings
        from bodymeasure.paper.write import write_reproduction

        settings = Settings(seed=seed, quick=quick, processes=processes)
        found = reproduce(settings, progress_bar)
        files = write_reproduction(found, output)
    print_table(_summary(found.table("closest").rows, sum(found.seconds.values())))
    for path in files:
        RESULTS.print(Text(str(path), "bold" if path.suffix == ".html" else ""), soft_wrap=True)
    return 0


def _summary(rows: tuple[tuple[object, ...], ...], seconds: float) -> Table:
    """What a reader wants to know first: the mean accuracy loss of each reading."""
    table = Table(
        title=Text(f"Mean accuracy loss (paper: {_percent(MEAN_LOSS)})", "bold"),
        title_justify="left",
        box=None,
    )
    table.add_column("reading")
    table.add_column("inside the patch", justify="right")
    table.add_column("of all solutions", justify="right")
    for name, _, inside, every, *_rest in rows:
        table.add_row(str(name), _percent(inside), _percent(every))
    table.add_row("", "", "")
    table.add_row(Text("time", "dim"), f"{seconds:.0f} s", "")
    return table


def _percent(value: object) -> str:
    return f"{100.0 * value:.2f} %" if isinstance(value, float) else "-"
