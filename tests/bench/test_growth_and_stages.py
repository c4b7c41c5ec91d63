"""The time and memory of batches, and the stages in which the time is spent."""

import pytest

from bodymeasure.bench.problems.sets import mild_set, wild_set
from bodymeasure.bench.timing.growth import measure_growth
from bodymeasure.bench.timing.stages import REST, STAGES, stage_shares


def test_memory_is_followed_and_nothing_fails() -> None:
    small, large = measure_growth(100), measure_growth(1000)
    assert (small.patches, large.patches) == (100, 1000)
    assert (small.failures, large.failures) == (0, 0)
    # The lengths, errors and paths of all diagonals need memory.
    assert large.peak_bytes > small.peak_bytes > 100 * 8 * 10
    assert len(small.seconds) > len(large.seconds) >= 3


@pytest.mark.parametrize("make", [mild_set, pytest.param(wild_set, marks=pytest.mark.slow)])
def test_each_stage_is_seen(make: type) -> None:
    shares = stage_shares(make(40))
    assert list(shares) == [*STAGES, REST]
    # If a function of the table had been renamed, its stage would have no share.
    may_be_empty = {"paths left to the full form"} if make is mild_set else set()
    assert all(0.0 < shares[name] < 1.0 for name in shares.keys() - may_be_empty), shares
    assert sum(shares.values()) == pytest.approx(1.0)
