"""Newton's method, its steps halved until the residual falls, for one problem or for many."""

from collections.abc import Callable, Generator
from functools import partial
from typing import NamedTuple, cast

import numpy as np

from bodymeasure._typing import Array, Ints

# A Newton step smaller than this part of the way from start to end is the last one: the next would
# be about its square, and the error of the length, which is stationary, the square of that again.
# How good the path really is, is measured afterwards by its residual between the nodes.
LAST_STEP = 1e-4
# A step this many times halved leads nowhere.
SMALLEST_STEP = 2.0**-8
# No step moves a node further than this in a parameter: the equations say nothing out there.
LONGEST_STEP = 0.5
# The most evaluations of the system, for whole and halved steps together. From polygons, legs that
# have a solution take 3 to 12, a few up to 25; those that have none took 100.
MOST_EVALUATIONS = 40


class Solved(NamedTuple):
    """The unknowns at which the equations hold, and how often they were evaluated."""

    unknowns: Array
    evaluations: int


def damped_newton(
    system: Callable[[Array], tuple[Array, Array]],
    direction: Callable[[Array, Array], Array],
    guess: Array,
    *,
    span: float = 1.0,
) -> Solved | None:
    """Solve a system of equations from a guess.

    Parameters
    ----------
    system : callable
        A function from unknowns to the equations' left sides and their derivatives.
    direction : callable
        A function from these to Newton's direction, of the shape of the unknowns, which is not
        finite if the system is singular.
    guess : ndarray
    span : float
        The size beside which the last step is small.

    Returns
    -------
    Solved or None
        None if it failed.
    """
    steps = _steps(guess, span)
    trial = next(steps)
    while True:
        residual, matrix = system(trial)
        try:
            trial = steps.send((residual, partial(direction, residual, matrix)))
        except StopIteration as end:
            return cast("Solved | None", end.value)


def damped_newton_of_many(
    system: Callable[[Ints, Array], tuple[Array, Array]], guesses: Array, spans: Array
) -> list[Solved | None]:
    """Solve many systems, each as `damped_newton` does, evaluated together.

    Parameters
    ----------
    system : callable
        A function from the numbers of some systems, and their unknowns, to the left sides and to
        Newton's directions, each with one row a system.
    guesses : ndarray, shape (systems, ...)
    spans : ndarray, shape (systems,)
    """
    found: list[Solved | None] = [None] * len(guesses)
    steps = [_steps(guess, span) for guess, span in zip(guesses, spans.tolist(), strict=True)]
    trials = {number: next(each) for number, each in enumerate(steps)}
    while trials:
        numbers = np.array(list(trials))
        residuals, ways = system(numbers, np.stack(list(trials.values())))
        for number, residual, way in zip(numbers.tolist(), residuals, ways, strict=True):
            try:
                trials[number] = steps[number].send((residual, partial(np.asarray, way)))
            except StopIteration as end:
                found[number] = end.value
                del trials[number]
    return found


def _steps(
    guess: Array, span: float
) -> Generator[Array, tuple[Array, Callable[[], Array]], Solved | None]:
    """The unknowns to evaluate next; sent back are left sides, and what returns the direction."""
    unknowns = guess
    residual, direction = yield unknowns
    evaluations = 1
    while evaluations < MOST_EVALUATIONS:
        way = direction()
        size = np.abs(way).max(initial=0.0)
        if not np.isfinite(size):
            return None
        if size < LAST_STEP * span:
            return Solved(np.asarray(unknowns + way), evaluations)
        step, norm = min(1.0, LONGEST_STEP / size), np.linalg.norm(residual)
        while True:
            trial = unknowns + step * way
            residual, direction = yield trial
            evaluations += 1
            if np.linalg.norm(residual) < norm:
                break
            step /= 2.0
            if step < SMALLEST_STEP or evaluations == MOST_EVALUATIONS:
                return None
        unknowns = trial
    return None
