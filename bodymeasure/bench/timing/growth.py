"""How processor time and memory grow with the number of patches."""

import tracemalloc
from dataclasses import dataclass

import numpy as np

from bodymeasure.bench.problems.patches import first_diagonals, mild_patches
from bodymeasure.bench.problems.sets import MILD_HEIGHTS, SEED
from bodymeasure.bench.timing.timing import processor_seconds
from bodymeasure.geodesic import RBFCollocation, solve_geodesic

# Few patches are timed so often that there is something to time.
PATCHES_TIMED = 20_000
MOST_CALLS = 50
# So that there is a spread; twice for batches that take half a minute.
FEWEST_CALLS = 3
TWICE_FROM = 1_000_000


@dataclass(frozen=True)
class Growth:
    """What a batch of some size takes, with the default method.

    Parameters
    ----------
    patches : int
        One diagonal is measured on each.
    seconds : tuple of float
        Processor time of the whole batch, each time.
    failures : int
        Diagonals without a length.
    peak_bytes : int
        Largest memory of NumPy and Python during a call, beyond the patches given to it.
    """

    patches: int
    seconds: tuple[float, ...]
    failures: int
    peak_bytes: int


def measure_growth(patches: int) -> Growth:
    """Measure one diagonal of each of many mild patches."""
    rng = np.random.default_rng(SEED)
    problems = first_diagonals(mild_patches(rng, patches, MILD_HEIGHTS[-1]))
    failures = 0

    def solve() -> None:
        nonlocal failures
        solution = solve_geodesic(
            *problems, method=RBFCollocation(), search="straight", on_failure="status"
        )
        failures = int(np.isnan(solution.length).sum())

    # By itself: following every allocation takes time.
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
