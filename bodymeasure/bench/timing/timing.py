"""Processor times of calls that take turns."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

from bodymeasure._typing import Array
from bodymeasure.bench.entrants.entrant import Entrant
from bodymeasure.bench.problems.sets import Batch, ProblemSet
from bodymeasure.bench.size import Size


@dataclass
class Trial:
    """The results of one method on the first problems of a set.

    Parameters
    ----------
    entrant : Entrant
    count : int
        Number of problems.
    length : ndarray, shape (count,)
        NaN where there is no length.
    seconds : list of float
        Processor time of all problems together, for each round.
    """

    entrant: Entrant[Any]
    count: int
    length: Array
    seconds: list[float] = field(default_factory=list)


def processor_seconds(call: Callable[[], object]) -> float:
    """Return the processor time of a call, in all of its threads."""
    begin = time.process_time()
    call()
    return time.process_time() - begin


def take_turns(
    entrants: Sequence[Entrant[Batch]],
    problem_set: ProblemSet[Batch],
    size: Size,
    advance: Callable[[], object],
) -> list[Trial]:
    """Time every method on a set of problems, once in each round.

    In this way a time in which the machine is slow does not affect one method alone. A first call
    of each is not timed: it gives the lengths, fills caches and loads libraries.

    Parameters
    ----------
    entrants : sequence of Entrant
    problem_set : ProblemSet
    size : Size
    advance : callable
        Called after each round and after the first calls.
    """
    trials, calls = [], []
    for entrant in entrants:
        limit = size.limits.get(entrant.pace, len(problem_set))
        problems = problem_set.problems.take(slice(limit))
        call = entrant.prepare(problems)
        length = call()
        trials.append(Trial(entrant, len(length), length))
        calls.append(call)
    advance()
    for number in range(size.rounds):
        for trial, call in zip(trials, calls, strict=True):
            if trial.entrant.pace != "very slow" or number % 2 == 0:
                trial.seconds.append(processor_seconds(call))
        advance()
    return trials
