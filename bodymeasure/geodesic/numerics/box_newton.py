"""Newton's method in the box [0, 1] for one function with a banded Hessian."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dpbsv

from bodymeasure._typing import Array

# Steps at most. From straight lines, three to fifteen are usual; the rest is for bad routes.
MAX_STEPS = 80
# Sets of held unknowns that are tried for a step: any step downhill is a good one.
MOST_SETS = 20
# At rest when a step would lower the value by less than this part: the next one would, since
# Newton's method squares its error, lower it by far less than rounding.
REST = 1e-14
# With no more damping than this such a step tells of rest, too: there is none to be had where the
# Hessian is singular, as by where a path that runs along a seam changes sides.
REST_DAMPING = 1e-4
# What a value may rise by rounding, relative.
ROUNDING = 2e-15
# Damping, as a part of the Hessian's diagonal: first value, factors after a good and a bad step,
# the value below which it is none, and that past which no step helps.
FIRST, LESS, MORE, LEAST, MOST = 1e-4, 0.1, 8.0, 1e-8, 1e8


class SecondOrder(NamedTuple):
    """A function of several unknowns to the second order.

    Parameters
    ----------
    value : float
    gradient : ndarray, shape (unknowns,)
    bands : ndarray, shape (bandwidth + 1, unknowns)
        The lower bands of the Hessian: ``bands[i, j]`` is its entry at row i + j, column j.
    """

    value: float
    gradient: Array
    bands: Array


@dataclass(frozen=True, eq=False)
class BoxMinimum:
    """Where Newton's method came to rest.

    Parameters
    ----------
    unknowns : ndarray, shape (unknowns,)
    value : float
    held : ndarray of bool, shape (unknowns,)
        Those on a bound that the gradient presses outwards.
    converged : bool
        Whether a step that is damped little or not would change nothing.
    iterations : int
    bands : ndarray
        The Hessian's lower bands there.
    """

    unknowns: Array
    value: float
    held: NDArray[np.bool_]
    converged: bool
    iterations: int
    bands: Array


def minimize_in_box(
    expand: Callable[[Array], SecondOrder],
    start: Array,
    idle: NDArray[np.bool_],
    most_steps: int = MAX_STEPS,
) -> BoxMinimum:
    """A local minimum over [0, 1]^k.

    Steps with the exact Hessian, damped as by Levenberg and Marquardt, each to the minimum of the
    quadratic model in the box.

    Parameters
    ----------
    expand : callable
    start : ndarray, shape (unknowns,)
        Within the box.
    idle : ndarray of bool, shape (unknowns,)
        Unknowns that stay as they are.
    most_steps : int
        Steps at most.
    """
    place, here, damping = start, expand(start), FIRST
    converged, iterations = False, 0
    while iterations < most_steps and not converged and damping <= MOST:
        iterations += 1
        step, foretold = _step(here, place, damping, idle)
        trial = np.clip(place + step, 0.0, 1.0)
        there = expand(trial) if np.isfinite(foretold) else here
        small = foretold <= REST * here.value
        if there.value < here.value or (small and there.value <= here.value * (1.0 + ROUNDING)):
            converged = bool(small and damping <= REST_DAMPING)
            place, here = trial, there
            damping = 0.0 if damping * LESS < LEAST else damping * LESS
        else:
            damping = max(damping * MORE, FIRST)
    pressed = np.where(place < 0.5, here.gradient, -here.gradient) > 0.0
    held = pressed & ((place == 0.0) | (place == 1.0)) & ~idle
    return BoxMinimum(place, here.value, held, converged, iterations, here.bands)


def _step(
    here: SecondOrder, place: Array, damping: float, idle: NDArray[np.bool_]
) -> tuple[Array, float]:
    """A step to the minimum of the damped model in the box, and the decrease it foretells.

    By a primal-dual active set, as in `box_steps`. The decrease is infinite where the model has no
    minimum: more damping is called for.
    """
    bands = here.bands.copy()
    bands[0] += damping * np.abs(here.bands[0])
    # What the gradient presses to its bound stays there: free, it might leave no minimum.
    outwards = np.where(place < 0.5, here.gradient, -here.gradient) > 0.0
    kept = (outwards & ((place == 0.0) | (place == 1.0))) | idle
    bound = np.where(kept, place, np.nan)
    step = np.zeros_like(place)
    for _ in range(MOST_SETS):
        free = np.isnan(bound)
        step = np.where(free, 0.0, bound - place)
        right = np.where(free, -here.gradient - banded_product(bands, step), step)
        solved = solve_free(bands, right, free)
        if solved is None:
            return np.zeros_like(place), np.inf
        step = solved
        slope, there = here.gradient + banded_product(bands, step), place + step
        # A product with NaN compares as false.
        pressed = ((1.0 - 2.0 * bound) * slope > 0.0) | idle
        outside = free & ((there < 0.0) | (there > 1.0))
        now = np.where(pressed, bound, np.where(outside, np.where(there < 0.5, 0.0, 1.0), np.nan))
        if np.array_equal(now, bound, equal_nan=True):
            break
        bound = now
    step = np.clip(place + step, 0.0, 1.0) - place
    return step, -float((here.gradient + 0.5 * banded_product(bands, step)) @ step)


def solve_free(bands: Array, right: Array, free: NDArray[np.bool_]) -> Array | None:
    """The solution of a banded system in what is free; the rest of the right side stays.

    None if the matrix is not positive definite there.
    """
    cut = bands * free
    for row in range(1, len(bands)):
        cut[row, :-row] *= free[row:]
    cut[0, ~free] = 1.0
    _, solution, failed = dpbsv(cut, right, lower=1)
    return solution if failed == 0 and np.isfinite(solution).all() else None


def banded_product(bands: Array, vector: Array) -> Array:
    """A symmetric matrix, given by its lower bands, times a vector."""
    result: Array = bands[0] * vector
    for row in range(1, len(bands)):
        part = bands[row, :-row]
        result[row:] += part * vector[:-row]
        result[:-row] += part * vector[row:]
    return result
