"""How many geodesics are proven to be the only shortest paths on their patches, and in what time.

Run it by hand: ``python tests/benchmarks/patches/proofs.py``; it takes a few seconds.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import time
from dataclasses import replace

import numpy as np

import bodymeasure as bm
from bodymeasure.bench.problems.patches import mild_patches, wild_patches
from bodymeasure.geodesic import GeodesicSolution

BODIES = ("female_average", "female_heavy", "female_old", "female_full_bust", "male_average")
REPEATS = 3
# With so many functions, lengths are between their bounds to the last bit.
FINE = 20


def row(name: str, solution: GeodesicSolution) -> None:
    """Print how many paths of a batch are proven, and the least time of some runs."""
    seconds = []
    for _ in range(REPEATS):
        # A copy does not know the verdict yet.
        solution = replace(solution)
        begin = time.process_time()
        proven = solution.proven_shortest
        seconds.append(time.process_time() - begin)
    each = 1e3 * min(seconds) / proven.size
    print(
        f"{name:18s} {proven.sum():7d} of {solution.converged.sum():5d} with a length, "
        f"{1e3 * min(seconds):6.0f} ms, {each:.3f} ms each"
    )


def width(name: str, body: bm.Atlas, functions: int | None) -> None:
    """Print how close the bounds of a body's diagonals are, and the time of solving and bounds."""
    method = None if functions is None else bm.RBFCollocation(functions=functions)
    seconds = []
    for _ in range(REPEATS):
        begin = time.process_time()
        solution = bm.diagonals(body, method=method, on_failure="status")
        solved = time.process_time() - begin
        proven = solution.proven_shortest
        begin = time.process_time()
        lower, upper = solution.bounds
        seconds.append(solved + time.process_time() - begin)
    known = solution.converged
    # Computed lengths are known up to their error estimates.
    outside = np.maximum(lower - solution.length, solution.length - upper) > (
        0.0 if functions == FINE else solution.error_estimate
    )
    relative = upper / lower - 1.0
    every = np.quantile(relative[known], [0.5, 0.95])
    print(
        f"{name:18s} {functions or 'default':>8} functions: "
        f"width {every[0]:.1e}, 95 % {every[1]:.0e}, "
        f"of the {proven.sum()} proven {np.quantile(relative[proven], 0.95):.0e}; "
        f"{outside[known].sum()} lengths outside; {1e3 * min(seconds):.0f} ms"
    )


def main() -> None:
    """Print the table."""
    for name in BODIES:
        body = bm.load_sample(name)
        row(name, bm.diagonals(body, on_failure="status"))
        for functions in (None, 12, FINE):
            width(name, body, functions)
    rng = np.random.default_rng(1)
    kinds = {
        "mild, height 0.3": mild_patches(rng, 1000, 0.3),
        "mild, height 1": mild_patches(rng, 1000, 1.0),
        "wild, side 1": wild_patches(rng, 1000, 1.0),
        "wild, side 0.6": wild_patches(rng, 1000, 0.6),
    }
    for name, nets in kinds.items():
        row(name, bm.solve_geodesic(nets, (0.0, 0.0), (1.0, 1.0), on_failure="status"))


if __name__ == "__main__":
    main()
