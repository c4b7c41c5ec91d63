"""A benchmark of a few problems, run once for all tests of a process."""

from functools import lru_cache
from unittest.mock import patch

from bodymeasure.bench import BenchDocument, Size, run_benchmark

SMALL = Size(
    mild=4,
    wild=3,
    body=4,
    limits={"fast": 2, "slow": 1, "very slow": 1},
    rounds=1,
    largest_exponent=3,
    measurements=2,
)


POINTS_A_SIDE = (5, 9, 17)
SEGMENTS = (4, 8, 12)
# The counts that were reported while it ran.
PROGRESS: list[int] = []


@lru_cache
def small_benchmark() -> BenchDocument:
    # The finest meshes take most of the time, and tell no more of a document.
    with (
        patch("bodymeasure.bench.entrants.entrants.POINTS_A_SIDE", POINTS_A_SIDE),
        patch("bodymeasure.bench.summary.POINTS_A_SIDE", POINTS_A_SIDE),
        patch("bodymeasure.bench.bodies.sets.SEGMENTS", SEGMENTS),
        patch("bodymeasure.bench.summary.SEGMENTS", SEGMENTS),
    ):
        return run_benchmark(SMALL, progress=PROGRESS.append)
