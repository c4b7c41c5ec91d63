"""How methods take turns, failures are counted and threads are limited."""

import time

import numpy as np
import pytest
from helpers.charts.small_benchmark import SMALL
from threadpoolctl import threadpool_info, threadpool_limits

from bodymeasure.bench.entrants.entrant import Entrant, Pace
from bodymeasure.bench.problems.patches import Problems, first_diagonals
from bodymeasure.bench.problems.sets import ProblemSet
from bodymeasure.bench.size import FULL, Size
from bodymeasure.bench.summary import results
from bodymeasure.bench.timing.threads import one_thread
from bodymeasure.bench.timing.timing import take_turns

COUNT = 5


@pytest.fixture
def problem_set() -> ProblemSet[Problems]:
    problems = first_diagonals(np.zeros((COUNT, 4, 4, 3)))
    return ProblemSet("made", "made up", problems, np.full(COUNT, 2.0), COUNT, 0, 0)


def recorder(name: str, pace: Pace, calls: list[str], answer: float) -> Entrant[Problems]:
    """A method that records when it is called."""

    def prepare(problems: Problems) -> object:
        def solve() -> object:
            calls.append(name)
            length = np.full(len(problems.nets), answer)
            length[0] = np.nan
            return length

        return solve

    return Entrant(name, "", "mesh", pace, prepare)  # type: ignore[arg-type]


def test_methods_take_turns_and_slow_ones_are_spared(problem_set: ProblemSet[Problems]) -> None:
    calls: list[str] = []
    rounds = 4
    size = Size(1, 1, 1, {"very slow": 3}, rounds, 1, 1)
    methods = [recorder("a", "batch", calls, 2.0), recorder("b", "very slow", calls, 2.0)]
    steps: list[None] = []
    trials = take_turns(methods, problem_set, size, lambda: steps.append(None))
    assert calls == ["a", "b", "a", "b", "a", "a", "b", "a"]
    assert [len(trial.seconds) for trial in trials] == [4, 2]
    assert [trial.count for trial in trials] == [COUNT, 3]
    assert len(steps) == rounds + 1


def test_failures_are_counted_and_left_out_of_errors(problem_set: ProblemSet[Problems]) -> None:
    calls: list[str] = []
    methods = [
        recorder("good", "batch", calls, 2.0),
        recorder("off", "batch", calls, 2.5),
        recorder("bad", "batch", calls, np.inf),
    ]
    trials = take_turns(methods, problem_set, SMALL, lambda: None)
    trials[0].seconds[:] = [1e-6, 2e-6, 3e-6]
    trials[1].seconds[:] = [4e-6]
    good, off, bad = results(problem_set, trials)
    assert (good.failures, off.failures, bad.failures) == (1, 1, COUNT)
    assert (good.error_worst, off.error_median, bad.error_median) == (0.0, 0.25, None)
    assert good.time_median == pytest.approx(2.0 / COUNT)
    assert good.time_lower_quartile == pytest.approx(1.5 / COUNT)
    assert good.time_upper_quartile == pytest.approx(2.5 / COUNT)
    assert off.times_ours == pytest.approx(2.0)


def test_full_and_small_differ_in_size_alone() -> None:
    assert set(FULL.limits) == set(SMALL.limits)


def test_libraries_are_held_to_one_thread_and_let_go() -> None:
    with threadpool_limits(limits=2):
        before = [pool["num_threads"] for pool in threadpool_info()]
        _wait_until_idle()
        _use_one_thread()
        assert [pool["num_threads"] for pool in threadpool_info()] == before


def _wait_until_idle() -> None:
    """Wait for new threads, each of which keeps its processor busy for a while before it sleeps."""
    idle = 0
    for _ in range(600):
        begin = time.process_time()
        time.sleep(0.1)
        # One that waits for a busy processor looks as if it slept, but not several times over.
        idle = idle + 1 if time.process_time() - begin < 0.005 else 0
        if idle == 5:
            return


def _use_one_thread() -> None:
    with one_thread() as found:
        matrix = np.random.default_rng(0).random((500, 500))
        for _ in range(5):
            matrix = matrix @ matrix / 250.0
        assert all(pool["num_threads"] == 1 for pool in threadpool_info())
    assert found.limit == 1
    assert found.pools
    assert found.processor_seconds > 0.0
    # If there were two threads, each would take half of the time.
    assert found.other_threads < 0.2
