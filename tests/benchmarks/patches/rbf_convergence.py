"""The study behind the default kernel, the numbers of functions and the placement of centers.

Every setting is tried on the diagonals of one body that stay in their patch and on mild random
patches, against independent references (`reference.py`), with every length accepted whose
correction is small enough to be trusted. Run it by hand:
``python tests/benchmarks/patches/rbf_convergence.py [--quick] [--all]``; it takes a minute.

Placements: *outside*: half of the centers on either side of [0, 1], the rest, where there are more
than the kernel's degree, inside (`default_centers`); *t >= 1*: at 1 + i / N, the paper's 1 and 1.5
for N = 2; *Chebyshev*: all inside, at Chebyshev-Lobatto points with the ends; *even*: all
inside, evenly spaced, with evenly spaced collocation points, which elsewhere are Chebyshev points.

The columns: condition number of the collocation system; relative errors of the lengths as computed
and with the correction (median, 99 %, worst; for mild patches median and worst); problems with no
length, in % (Newton's method or the correction failed, or the path found leaves its patch); those
whose error estimate meets the default tolerance, in %; processor time each, in microseconds.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from bodymeasure import WU_C2, WU_C4, WU_C6, WU_C10, Kernel, RBFCollocation, solve_geodesic
from bodymeasure.errors import InputError
from bodymeasure.geodesic.methods.rbf_collocation import chebyshev_points, default_centers

sys.path.insert(0, str(Path(__file__).parents[2]))
from benchmarks.independent import reference
from benchmarks.independent.reference import Problems

from bodymeasure._typing import Array, Bools

# A body's diagonals and mild patches, each with their true lengths.
Sets = tuple[tuple[Problems, Array], tuple[Problems, Array]]
DEFAULT = RBFCollocation()
# A tolerance that every length meets whose correction is trusted.
ANY = 1.0


def outside(kernel: Kernel, count: int) -> RBFCollocation:
    return RBFCollocation(kernel=kernel, centers=default_centers(kernel, count).tolist())


def one_sided(kernel: Kernel, count: int) -> RBFCollocation:
    return RBFCollocation(kernel=kernel, centers=(1.0 + np.arange(count) / count).tolist())


def inside(kernel: Kernel, count: int) -> RBFCollocation:
    return RBFCollocation(kernel=kernel, centers=[0.0, *chebyshev_points(count - 2), 1.0])


def even(kernel: Kernel, count: int) -> RBFCollocation:
    return RBFCollocation(
        kernel=kernel,
        centers=np.linspace(0.0, 1.0, count).tolist(),
        collocation_points=np.linspace(0.0, 1.0, count + 1)[1:-1].tolist(),
    )


PLACEMENTS: dict[str, Callable[[Kernel, int], RBFCollocation]] = {
    "outside": outside,
    "t >= 1": one_sided,
    "Chebyshev": inside,
    "even": even,
}


def known(problems: Problems) -> tuple[Problems, Array]:
    """The problems whose geodesic stays in its patch, and their true lengths."""
    length = reference.geodesics(problems, pairs=reference.FINEST).length
    rows = np.flatnonzero(np.isfinite(length))
    return problems.take(rows), length[rows]


def errors(lengths: Array, true: Array, good: Bools, quantiles: list[float]) -> str:
    error = np.abs(lengths[good] / true[good] - 1.0)
    figures = np.quantile(error, quantiles) if len(error) else [np.nan] * len(quantiles)
    return " ".join(f"{figure:7.0e}" for figure in figures)


def row(name: str, method: RBFCollocation, sets: Sets) -> None:
    """Print what one setting reaches."""
    try:
        condition = max(space.condition for space in method.spaces)
    except InputError:
        print(f"{name:20s} degenerate")
        return
    parts = []
    for (problems, true), quantiles in zip(sets, ([0.5, 0.99, 1.0], [0.5, 1.0]), strict=True):
        solve = partial(solve_geodesic, *problems, method=method, on_failure="status")
        least = np.inf
        for _ in range(2):
            start = time.process_time()
            solution = solve()
            least = min(least, 1e6 * (time.process_time() - start) / len(true))
        good = solution.converged
        meets = good & (solution.error_estimate <= DEFAULT.tolerance * solution.raw_length)
        parts.append(
            f"{errors(solution.raw_length, true, good, quantiles)} | "
            f"{errors(solution.length, true, good, quantiles)} | "
            f"{100 * np.mean(~good):5.1f} {100 * np.mean(meets):5.1f} {least:5.0f}"
        )
    print(f"{name:20s} {condition:6.0e} | {' || '.join(parts)}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="few settings and problems")
    parser.add_argument("--all", action="store_true", help="every N for every placement")
    options = parser.parse_args()
    counts = (6, 8, 12, 16) if options.quick else tuple(range(4, 21, 2))
    fewer = counts if options.all else (8, 12) if options.quick else (8, 12, 16)
    body = reference.body_diagonals("female_average")
    if options.quick:
        body = body.take(np.arange(0, len(body.nets), 12))
    rng = np.random.default_rng(3)
    mild = reference.mild_patches(rng, 40 if options.quick else 300, 0.3)
    sets = known(body), known(reference.first_diagonals(mild))

    print(f"{len(sets[0][1])} diagonals of a body || {len(sets[1][1])} mild patches")
    heads = ("", "cond.", "raw: median, 99 %, worst", "corrected", "fails, meets %, microsec.")
    print("{:20s} {:>6s} | {:23s} | {:23s} | {} || the same".format(*heads))
    for placement, make in PLACEMENTS.items():
        print(f"centers {placement}")
        for kernel in (WU_C2, WU_C10) if options.quick else (WU_C2, WU_C4, WU_C6, WU_C10):
            for count in counts if placement == "outside" else fewer:
                row(f"{kernel.name} N = {count}", replace(make(kernel, count), tolerance=ANY), sets)
    print(f"the default: centers outside, {DEFAULT.kernel.name}, N = {DEFAULT.functions} in turn")
    row("", DEFAULT, sets)


if __name__ == "__main__":
    main()
