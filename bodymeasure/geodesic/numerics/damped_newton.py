"""Newton's method for one problem, its steps halved until the residual falls."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array

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
    unknowns = guess
    residual, matrix = system(unknowns)
    evaluations = 1
    while evaluations < MOST_EVALUATIONS:
        way = direction(residual, matrix)
        size = np.abs(way).max(initial=0.0)
        if not np.isfinite(size):
            return None
        if size < LAST_STEP * span:
            return Solved(np.asarray(unknowns + way), evaluations)
        step, norm = min(1.0, LONGEST_STEP / size), np.linalg.norm(residual)
        while True:
            trial = unknowns + step * way
            residual, matrix = system(trial)
            evaluations += 1
            if np.linalg.norm(residual) < norm:
                break
            step /= 2.0
            if step < SMALLEST_STEP or evaluations == MOST_EVALUATIONS:
                return None
        unknowns = trial
    return None
