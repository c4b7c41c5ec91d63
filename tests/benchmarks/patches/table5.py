"""Table 5 of the paper for sample mannequins.

Run it by hand: ``python tests/benchmarks/patches/table5.py [SAMPLE ...]``.

The lengths of all diagonals and all boundary curves on the atlas are compared with those on the
surface to which it was fitted, by default for the average female, in two minutes on two free cores.
"""

import os
import resource
import sys
import time

import numpy as np

from bodymeasure.atlas import Unit, convert_length
from bodymeasure.paper.data.published import Table5Row
from bodymeasure.paper.surface.surface_comparison import Distribution, Row
from bodymeasure.paper.surface.table5 import Table5, table5

PROCESSES = 2


def main(names: list[str]) -> None:
    os.environ["OMP_NUM_THREADS"] = "1"
    for name in names:
        begin = time.perf_counter()
        table = table5(name, processes=PROCESSES)
        seconds = time.perf_counter() - begin
        print(f"\n{name}: {seconds:.0f} s with {PROCESSES} processes, {_cpu():.0f} s of CPU so far")
        report(table)


def report(table: Table5) -> None:
    for what, spread in zip(("diagonals", "boundary curves"), table.distributions(), strict=True):
        print_spread(what, spread)
    off = table.diagonals.offset
    print(
        f"  diagonals off the surface, on average: {1e3 * off.mean():+.3f} mm of "
        f"{1e3 * np.abs(off).mean():.3f} mm; the paths' part of the errors, largest: "
        f"{np.nanmax(table.diagonals.of_path):.4%}"
    )
    for published, row in table.in_the_papers_form():
        print_row(published, row, table.diagonals.unit)


def print_spread(what: str, spread: Distribution) -> None:
    print(
        f"  {spread.count} {what}, {spread.without_length} without a length: "
        f"mean {spread.mean:+.4%}, mean absolute {spread.mean_absolute:.4%}, "
        f"median {spread.median_absolute:.4%}, 95 % {spread.quantile_95:.4%}; "
        f"the meshes' uncertainty {spread.uncertainty:.1e}"
    )
    if spread.largest is not None:
        print(f"  largest: {spread.largest.name}. {spread.explanation}")


def print_row(published: Table5Row, row: Row, unit: Unit) -> None:
    calculated, physical = (
        convert_length(length, unit, Unit.CM) for length in (row.calculated, row.physical)
    )
    print(
        f"  {published.calculated:8.6g} {published.physical:6.5g} {published.relative_error:+.2%}"
        f"  |  {calculated:8.6g} {physical:8.6g} {row.relative_error:+.3%}  {row.name}"
    )


def _cpu() -> float:
    usage = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in usage)


if __name__ == "__main__":
    main(sys.argv[1:] or ["female_average"])
