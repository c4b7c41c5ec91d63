"""`bodymeasure bench`."""

from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.text import Text

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import RESULTS, print_files, print_note, print_table, progress_bar
from bodymeasure.cli.needs import BENCHMARK, BENCHMARK_FIGURE, require
from bodymeasure.cli.options import folder_option
from bodymeasure.cli.tables import new_table
from bodymeasure.files import output_folder

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.bench.records import BenchDocument, SetRecord


@click.command(epilog=EXIT_CODES)
@folder_option(
    help="Folder for bench.json, bench.csv and two pictures; made if it is not there. "
    "Without it, the tables are printed and nothing is written.",
)
@click.option(
    "--quick",
    is_flag=True,
    help="Take few problems and repeats: two minutes, not twelve.",
)
def bench(output: Path | None, quick: bool) -> None:
    """Compare methods side by side, in processor time on one thread.

    bodymeasure's methods, scipy's solve_bvp, libigl, potpourri3d and pygeodesic measure diagonals
    of mild and wild random patches and of a body; errors are against an independent method.
    Paths, girths, loops, tapes and a chart of a body stand beside what libraries measure on its
    triangle meshes. Further tables show how time and memory grow with the number of patches, and
    where the time goes.
    """
    require(*BENCHMARK, *((BENCHMARK_FIGURE,) if output else ()))
    with output_folder(output) if output else nullcontext():
        # Slow imports, which `--help` does not need.
        from bodymeasure.bench import FULL, QUICK, benchmark_steps, run_benchmark, write_benchmark

        size = QUICK if quick else FULL

        with progress_bar("measuring", benchmark_steps(size)) as progress:
            document = run_benchmark(size, progress=progress)
        files = write_benchmark(document, output) if output else ()
    _print(document)
    if "pygeodesic" not in document.versions:
        print_note("pygeodesic is not installed, and takes no part.")
    print_files(files)


def _print(document: "BenchDocument") -> None:
    for record in document.sets:
        print_table(_comparison(document, record))
    print_table(_growth(document))
    print_table(_stages(document))
    print_table(_figures(document))
    threads = document.threads
    libraries = ", ".join(threads.pools) or "no library with threads found"
    text = (
        f"One thread ({libraries} held to {threads.limit}); other threads took "
        f"{threads.others:.1%} of {document.processor_seconds:.0f} s of processor time. "
        + ", ".join(f"{name} {version}" for name, version in document.versions.items())
        + f"; {document.machine.system} {document.machine.architecture}, "
        f"{document.machine.cores} cores."
    )
    RESULTS.print(Text(text), soft_wrap=True)


def _comparison(document: "BenchDocument", record: "SetRecord") -> "Table":
    left_out = [
        f"{count} {why}"
        for count, why in (
            (record.leaving_patch, "leave their patch"),
            (record.unresolved_truth, "without a true length"),
        )
        if count
    ]
    on_patches = record.noun == "diagonals"
    title = f"{record.title}: {record.compared} of {record.drawn} {record.noun}"
    if left_out:
        title += f" (left out: {', '.join(left_out)})"
    if record.confirmed_to is not None:
        title += f", confirmed to {record.confirmed_to:.0e} by an extrapolated peer"
    unit, scale = ("µs", 1.0) if on_patches else ("ms", 1e-3)
    times, errors = (f"{unit} each", "quartiles", "times ours"), ("error", "10-90 %", "worst")
    table = new_table("method", "tried", "failed", *times, *errors, title=f"\n{title}")
    for result in document.results:
        if result.set != record.name:
            continue
        name = f"{result.method}, {result.setting}" if result.setting else result.method
        table.add_row(
            Text(name),
            str(result.problems),
            Text(str(result.failures), "yellow" if result.failures else ""),
            _time(scale * result.time_median),
            f"{_time(scale * result.time_lower_quartile)}-"
            f"{_time(scale * result.time_upper_quartile)}",
            _time(result.times_ours),
            _error(result.error_median),
            f"{_error(result.error_tenth)} {_error(result.error_ninetieth)}",
            _error(result.error_worst),
        )
    return table


def _growth(document: "BenchDocument") -> "Table":
    headings = ("patches", "µs each", "quartiles", "failed", "peak MiB", "bytes each")
    table = new_table(*headings, title="\ngrowth with the number of patches")
    for record in document.growth:
        table.add_row(
            f"{record.patches:,}",
            _time(record.time_median),
            f"{_time(record.time_lower_quartile)}-{_time(record.time_upper_quartile)}",
            str(record.failures),
            f"{record.peak_bytes / 2**20:,.1f}",
            f"{record.peak_bytes / record.patches:,.0f}",
        )
    return table


def _stages(document: "BenchDocument") -> "Table":
    table = new_table("stage", *document.stages, title="\nwhere the time goes")
    for stage in next(iter(document.stages.values())):
        table.add_row(stage, *(f"{shares[stage]:.0%}" for shares in document.stages.values()))
    return table


def _figures(document: "BenchDocument") -> "Table":
    table = new_table("figure", "value", "", words=("",), title="\nin short")
    for figure in document.figures:
        small = figure.value is not None and figure.value < 1e-2
        value = _error(figure.value) if small else _time(figure.value)
        table.add_row(Text(figure.name), value, figure.unit)
    return table


def _time(value: float | None) -> str:
    """Return a time with three digits, without an exponent."""
    if value is None:
        return ""
    decimals = 2 if value < 10.0 else 1 if value < 100.0 else 0
    return f"{value:,.{decimals}f}"


def _error(value: float | None) -> str:
    return "" if value is None else f"{value:.1e}"
