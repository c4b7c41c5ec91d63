"""The growth of processor time and memory with the number of patches."""

import tracemalloc
from dataclasses import dataclass

import numpy as np

from bodymeasure.bench.problems.patches import first_diagonals, mild_patches
from bodymeasure.bench.problems.sets import MILD_HEIGHTS, SEED
from bodymeasure.bench.timing.timing import processor_seconds
from bodymeasure.geodesic import RBFCollocation, solve_geodesic

# Small batches are repeated until so many patches are timed, but no more often than this.
PATCHES_TIMED = 20_000
MOST_CALLS = 50
# At least so many calls show a spread. Batches of half a minute are timed only twice.
FEWEST_CALLS = 3
TWICE_FROM = 1_000_000


@dataclass(frozen=True)
class Growth:
    """The time and memory of a batch of some size, with the default method.

    Parameters
    ----------
    patches : int
        One diagonal is measured on each.
    seconds : tuple of float
        Processor time of the whole batch, for each call.
    failures : int
        Diagonals without a length.
    peak_bytes : int
        Largest memory of NumPy and Python during a call, besides the patches given to it.
    """

    patches: int
    seconds: tuple[float, ...]
    failures: int
    peak_bytes: int


def measure_growth(patches: int) -> Growth:
    """Return time and memory for one diagonal of each of many mild patches."""
    rng = np.random.default_rng(SEED)
    problems = first_diagonals(mild_patches(rng, patches, MILD_HEIGHTS[-1]))
    failures = 0

    def solve() -> None:
        nonlocal failures
        solution = solve_geodesic(
            *problems, method=RBFCollocation(), search="straight", on_failure="status"
        )
        failures = int(np.isnan(solution.length).sum())

    # This call is not timed, since following every allocation takes time.
    tracemalloc.start()
    try:
        solve()
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    calls = min(MOST_CALLS, max(FEWEST_CALLS, PATCHES_TIMED // patches))
    if patches >= TWICE_FROM:
        calls = 2
    seconds = tuple(processor_seconds(solve) for _ in range(calls))
    return Growth(patches, seconds, failures, peak)
