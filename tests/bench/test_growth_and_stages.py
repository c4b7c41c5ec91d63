"""The time and memory of batches, and the stages in which the time is spent."""

from importlib import import_module

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
    # On so few problems nothing may be left to the full form.
    assert all(0.0 <= share < 1.0 for share in shares.values()), shares
    assert shares[next(iter(STAGES))] > 0.0
    assert sum(shares.values()) == pytest.approx(1.0)


def test_stages_are_made_of_functions_that_there_are() -> None:
    for module, name in (function for functions in STAGES.values() for function in functions):
        home = import_module(f"bodymeasure.geodesic.{module.replace('/', '.')}")
        assert callable(getattr(home, name))
