"""A benchmark of a few problems, run once for all tests of a process."""

from functools import lru_cache

from bodymeasure.bench import BenchDocument, Size, run_benchmark

SMALL = Size(
    mild=4,
    wild=3,
    body=4,
    limits={"fast": 2, "slow": 1, "very slow": 1},
    rounds=1,
    largest_exponent=3,
)


# The counts that were reported while it ran.
PROGRESS: list[int] = []


@lru_cache
def small_benchmark() -> BenchDocument:
    return run_benchmark(SMALL, progress=PROGRESS.append)
