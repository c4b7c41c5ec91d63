"""How often the error estimate covers the true error of a length, and how sharp it is.

On the diagonals of all five bodies and on mild and wild random patches: for the default settings,
with their search where the straight start fails; for the default method without it; and for fixed
numbers of functions with every length accepted whose correction is small enough to be trusted. The
references are independent (`reference.py`). Run it by hand: ``python
tests/benchmarks/patches/error_estimate.py [--quick]``; it takes ten minutes, more if the machine is
busy.

The columns: problems converged, leaving their patch and failed otherwise, in %; converged ones for
which no reference was found (all that run along an edge are among them), and those whose path is
another geodesic than the one first found from a straight line; of all that have a reference: the
true errors that the estimate covers, in %; the medians of estimate / true error of the corrected
and of the raw length, where that error is above rounding; relative errors of the lengths as
computed and with the correction; how many corrected lengths are more than 1e-8 off. Below each line
stand the worst lengths that are so far off, or whose error is more than the estimate.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
from pathlib import Path

import numpy as np

from bodymeasure import (
    WU_C2,
    GeodesicSolution,
    PolynomialCollocation,
    RBFCollocation,
    Ritz,
    Status,
    solve_geodesic,
)
from bodymeasure.geodesic import Method

sys.path.insert(0, str(Path(__file__).parents[2]))
from benchmarks.independent import reference
from benchmarks.independent.reference import Problems, Reference
from helpers.bodies import BODIES

from bodymeasure._typing import Array, Bools

# Relative errors below this are rounding; no estimate is sharp there.
ROUNDING = 1e-15
# A path this close to the reference's, in u and v, counts as the same geodesic.
SAME_PATH = 0.05
# Lengths further off than this, relative, should be rare, and have a status.
FAR_OFF = 1e-8
# How many of the lengths that break a promise are listed.
LISTED = 4
# A tolerance that every length meets whose correction is trusted.
ANY = 1.0
METHODS: dict[str, Method | None] = {"search": None, "default": RBFCollocation()}
METHODS |= {f"C10 {n:2d}": RBFCollocation(functions=n, tolerance=ANY) for n in (6, 8, 12, 16)}
METHODS["C2   8"] = RBFCollocation(kernel=WU_C2, functions=8, tolerance=ANY)
METHODS["poly  8"] = PolynomialCollocation(8, tolerance=ANY)
METHODS["Ritz  8"] = Ritz(8, tolerance=ANY)


def problem_sets(quick: bool) -> dict[str, Problems]:
    rng = np.random.default_rng(2)
    count = 24 if quick else 2000
    bodies = [reference.body_diagonals(name) for name in BODIES]
    sets = {"bodies": Problems(*map(np.concatenate, zip(*bodies, strict=True)))}
    if quick:
        sets["bodies"] = sets["bodies"].take(rng.choice(len(sets["bodies"].nets), count))
    for height in (0.15, 0.3):
        nets = reference.mild_patches(rng, count, height)
        sets[f"mild {height:g}"] = reference.first_diagonals(nets)
    for side in (1.0, 0.6):
        # Wild patches cost the most: their references need the highest degrees.
        nets = reference.wild_patches(rng, count // 4 if quick else count, side)
        sets[f"wild {side:g}"] = reference.first_diagonals(nets)
    return sets


def compare(
    problems: Problems, solution: GeodesicSolution, known: Reference
) -> tuple[Array, Bools]:
    """The true lengths of the converged paths (NaN if unknown), and which are other geodesics.

    Where the reference has no length, or its path is another one, one is sought from the path in
    question; if it moves far away from there, it does not count. What was unknown is entered.
    """
    path = solution.path(reference.GAUSS)
    true = np.where(_is_near(known.paths, path), known.length, np.nan)
    other = np.isnan(true) & np.isfinite(known.length)
    rows = np.flatnonzero(solution.converged & np.isnan(true))
    guess = solution.path(reference.GUESS_TIMES)[rows]
    refined = reference.geodesics(problems.take(rows), guess=guess, pairs=reference.FINEST)
    near = _is_near(refined.paths, path[rows])
    true[rows[near]] = refined.length[near]
    new = ~other[rows] & near
    known.length[rows[new]] = refined.length[new]
    known.paths[rows[new]] = refined.paths[new]
    return true, other


def _is_near(paths: Array, others: Array) -> Bools:
    return np.asarray(np.nan_to_num(np.abs(paths - others), nan=1.0).max(axis=(1, 2)) < SAME_PATH)


def row(solution: GeodesicSolution, true: Array, other: Bools) -> str:
    """Print one line of the table, and one for each of the worst lengths that break a promise."""
    compared = np.flatnonzero(solution.converged & np.isfinite(true))
    if len(compared) == 0:
        return "nothing to compare"
    length = true[compared]
    error = np.abs(solution.length[compared] / length - 1.0)
    raw = np.abs(solution.raw_length[compared] / length - 1.0)
    estimate = solution.error_estimate[compared] / length
    share = 100.0 / len(true)
    converged, leaves = (
        solution.converged.sum(),
        (np.asarray(solution.status) == Status.LEAVES_PATCH).sum(),
    )
    numbers = [*np.quantile(raw, [0.5, 0.99, 1.0]), *np.quantile(error, [0.5, 0.99, 1.0])]
    line = (
        f"{converged * share:6.1f} {leaves * share:6.1f}"
        f" {(len(true) - converged - leaves) * share:6.1f} {converged - len(compared):6d} "
        f"{other[compared].sum():5d} {100 * np.mean(error <= estimate):8.2f} "
        f"{_median_ratio(estimate, error):9.1f} {_median_ratio(estimate, raw):9.2g}   "
        + " ".join(f"{number:7.0e}" for number in numbers)
        + f" {(error > FAR_OFF).sum():6d}"
    )
    broken = np.flatnonzero((error > FAR_OFF) | (error > estimate))
    broken = broken[np.argsort(-error[broken])][:LISTED]
    return line + "".join(
        f"\n    problem {compared[i]}: error {error[i]:.1e}, estimate {estimate[i]:.1e}"
        for i in broken
    )


def _median_ratio(estimate: Array, error: Array) -> float:
    clear = error > ROUNDING
    return float(np.median(estimate[clear] / error[clear])) if clear.any() else np.nan


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="few problems of each kind")
    options = parser.parse_args()
    print(f"{'':79s}raw length              corrected length")
    print(
        f"{'':18s}  conv. leaves failed no ref other covers %  est/true   est/raw   "
        + 2 * " median    99 %   worst"
        + "  >1e-8"
    )
    for kind, problems in problem_sets(options.quick).items():
        known = reference.geodesics(problems)
        found = np.isfinite(known.length)
        print(
            f"{kind}: {found.sum()} references found from straight lines, {known.leaves.sum()} "
            f"leave their patch, {(~found & ~known.leaves).sum()} excluded unless found later"
        )
        for name, method in METHODS.items():
            solution = solve_geodesic(*problems, method=method, on_failure="status")
            print(
                f"{kind:10s} {name:7s}",
                row(solution, *compare(problems, solution, known)),
                flush=True,
            )


if __name__ == "__main__":
    main()
