"""Shortest paths along edges, compared with extrapolated shortest polygons, and their times.

On random patches as rough as the paper's, and on all diagonals of the five bodies, every path whose
status is ON_BOUNDARY is compared with `polygons.py`, which knows nothing of free legs and arcs. The
polygons begin at the path itself, moved off the edges, so that they must find where edges hold
them. Whether a shorter path runs elsewhere is the subject of ``shortest.py``. Run it by hand:
``python tests/benchmarks/patches/contact.py [--patches N]``; 500 patches of each kind and the
bodies take two minutes.

Then each problem is solved alone, as a user would, with the default search; the processor time is
the best of three.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
import time
from collections import Counter
from pathlib import Path
from typing import NamedTuple

import numpy as np

import bodymeasure as bm

sys.path.insert(0, str(Path(__file__).parents[2]))
from benchmarks.independent import reference
from benchmarks.independent.polygons import LEVELS, Polygons, shortest_polygons
from benchmarks.independent.reference import Problems
from helpers.bodies import BODIES

from bodymeasure._typing import Array

# The bar of the project for paths along edges, relative.
BAR = 1e-7
# Arcs that are shorter than so many edges of the finest polygon are too short for it to tell.
SHORT = 3.0
REPEATS = 3


class Case(NamedTuple):
    """One path along edges, the polygons beside it, and seconds to solve it alone."""

    solution: bm.GeodesicSolution
    polygons: Polygons
    seconds: float

    @property
    def difference(self) -> float:
        return float(self.solution.length / self.polygons.length - 1.0)

    @property
    def doubt(self) -> float:
        """The sum of both error estimates, relative to the length."""
        both = self.solution.error_estimate + self.polygons.uncertainty
        return float(both / self.polygons.length)

    @property
    def contact_gap(self) -> float:
        """How far apart arcs begin or end, in edges of the finest polygon; inf for other edges."""
        runs = self.polygons.runs
        spacing = max((run.spacing for run in runs), default=1.0 / LEVELS[-1])
        ours, theirs = (
            [arc for arc in arcs if abs(arc.end - arc.start) > SHORT * spacing]
            for arcs in (self.solution.contacts, runs)
        )
        if [arc.edge for arc in ours] != [arc.edge for arc in theirs]:
            return np.inf
        gaps = [
            max(abs(arc.start - run.start), abs(arc.end - run.end)) / run.spacing
            for arc, run in zip(ours, theirs, strict=True)
        ]
        return max(gaps, default=0.0)


def examined(problems: Problems) -> tuple[list[Case], Counter[str]]:
    """The paths along edges, and how often each status occurs."""
    together = bm.solve_geodesic(*problems, on_failure="status")
    cases = []
    for row in np.flatnonzero(together.status == bm.Status.ON_BOUNDARY):
        net, start, end = problems.nets[row], problems.start[row], problems.end[row]
        seconds = []
        for _ in range(REPEATS):
            begin = time.process_time()
            solution = bm.solve_geodesic(net, start, end)
            seconds.append(time.process_time() - begin)
        path = solution.path(np.linspace(0.0, 1.0, LEVELS[0] + 1))
        cases.append(Case(solution, shortest_polygons(net, path), min(seconds)))
    return cases, Counter(status.name for status in np.asarray(together.status))


def report(kind: str, problems: Problems) -> None:
    """Print what was found for one kind of problems."""
    cases, statuses = examined(problems)
    print(f"{kind}: " + ", ".join(f"{n} {name}" for name, n in sorted(statuses.items())))
    if not cases:
        return
    difference = np.abs([case.difference for case in cases])
    doubt = np.array([case.doubt for case in cases])
    uncertainty = np.array([c.polygons.uncertainty / c.polygons.length for c in cases])
    estimate = np.array([c.solution.error_estimate / c.solution.length for c in cases])
    gap = np.array([case.contact_gap for case in cases])
    milliseconds = 1e3 * np.array([case.seconds for case in cases])
    print(
        f"  difference {quantiles(difference)}   estimate {quantiles(estimate)}"
        f"   polygons' uncertainty {quantiles(uncertainty)}"
    )
    print(
        f"  {(difference > BAR).sum()} beyond {BAR:.0e}, {(difference > doubt).sum()} beyond "
        f"estimate + uncertainty, {sum(not case.polygons.at_rest for case in cases)} polygons not "
        f"at rest"
    )
    print(
        f"  contacts: {np.isinf(gap).sum()} on other edges; places differ by "
        f"{np.median(gap):.1f} edges of the finest polygon (median), {gap.max():.1f} (most)"
    )
    print(
        "  milliseconds: median {:.0f}, 90 % {:.0f}, worst {:.0f}".format(
            *np.quantile(milliseconds, [0.5, 0.9, 1.0])
        )
    )
    for level, moves in zip(LEVELS[2:], levels(cases), strict=True):
        print(f"  {level:5d} edges: extrapolated length moved by {quantiles(moves)}")
    for case in cases:
        if abs(case.difference) > min(case.doubt, BAR) or np.isinf(case.contact_gap):
            described(case)


def levels(cases: list[Case]) -> Array:
    """Relative moves of the extrapolated lengths, by level and case."""
    return np.array(
        [np.abs(np.diff(case.polygons.extrapolated)) / case.polygons.length for case in cases]
    ).T


def quantiles(values: Array) -> str:
    return "{:.0e} (median) {:.0e} (worst)".format(*np.quantile(values, [0.5, 1.0]))


def described(case: Case) -> None:
    """Print one case that needs to be looked at."""
    print(
        f"    off: difference {case.difference:.1e}, estimate "
        f"{case.solution.error_estimate / case.solution.length:.1e}, uncertainty "
        f"{case.polygons.uncertainty / case.polygons.length:.1e}"
    )
    for name, arcs in (("path", case.solution.contacts), ("polygon", case.polygons.runs)):
        arcs_told = "; ".join(f"{arc.edge} {arc.start:.5f} to {arc.end:.5f}" for arc in arcs)
        print(f"      {name}: {arcs_told}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--patches", type=int, default=500, help="of each kind")
    count = parser.parse_args().patches
    rng = np.random.default_rng(7)
    for side in (1.0, 0.6):
        nets = reference.wild_patches(rng, count, side)
        report(f"wild {side:g}", reference.first_diagonals(nets))
    bodies = [reference.body_diagonals(name) for name in BODIES]
    report("bodies", Problems(*map(np.concatenate, zip(*bodies, strict=True))))


if __name__ == "__main__":
    main()
