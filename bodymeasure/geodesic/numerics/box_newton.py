"""Newton's method in the box [0, 1] for one function with a banded Hessian."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.numerics.banded import BoxModels
from bodymeasure.native import NewtonSettings

# The most steps. From straight lines, three to fifteen are usual; the rest is for bad routes.
MAX_STEPS = 80
# Steps of large systems are few: at most so many entries of Hessians are looked at in all, which
# takes a second, but always some steps are made.
MAX_ENTRIES, FEWEST = 3e6, 12
# At rest when a step would lower the value by less than this part: the next one would, since
# Newton's method squares its error, lower it by far less than rounding.
REST = 1e-14
# With at most this damping such a step shows rest, too: no undamped step exists where the Hessian
# is singular, as in the place where a path that runs along a seam changes sides.
REST_DAMPING = 1e-4
# The part of itself by which a value may rise through rounding.
ROUNDING = 2e-15
# Damping, as a part of the Hessian's diagonal: its first value, its factors after a good and a bad
# step, the value below which it is zero, and that past which no step helps.
FIRST, LESS, MORE, LEAST, MOST = 1e-4, 0.1, 8.0, 1e-8, 1e8
# Its first value where the start is near the minimum, from which more damping would keep it.
NEAR = 1e-6


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
    """The place where Newton's method came to rest.

    Parameters
    ----------
    unknowns : ndarray, shape (unknowns,)
    value : float
    held : ndarray of bool, shape (unknowns,)
        The unknowns on a bound to which the gradient presses them.
    converged : bool
        Whether a step with little or no damping would change nothing.
    iterations : int
    bands : ndarray
        The Hessian's lower bands there.
    """

    unknowns: Array
    value: float
    held: Bools
    converged: bool
    iterations: int
    bands: Array

    @classmethod
    def at(
        cls, place: Array, here: SecondOrder, idle: Bools, *, converged: bool, iterations: int
    ) -> "BoxMinimum":
        """Return what is known of a place, with the function expanded there."""
        model = BoxModels(here.bands[None], here.gradient[None], place[None], idle[None])
        held = model.pressed()[0] & ~idle
        return cls(place, here.value, held, converged, iterations, here.bands)


def steps_allowed(most_steps: int, entries: int) -> int:
    """Return the most steps for a Hessian with so many entries in its bands."""
    return min(most_steps, max(FEWEST, int(MAX_ENTRIES / entries)))


def newton_settings(most_steps: int, entries: int, damping: float) -> NewtonSettings:
    """Return the constants of this method for compiled kernels."""
    steps = steps_allowed(most_steps, entries)
    rest = REST, REST_DAMPING, ROUNDING
    return NewtonSettings(steps, *rest, damping, FIRST, LESS, MORE, LEAST, MOST)


def minimize_in_box(
    expand: Callable[[Array], SecondOrder],
    start: Array,
    idle: Bools,
    most_steps: int = MAX_STEPS,
    damping: float = FIRST,
) -> BoxMinimum:
    """Find a local minimum over [0, 1]^k.

    Each step leads to the minimum, in the box, of the quadratic model with the exact Hessian,
    damped as by Levenberg and Marquardt.

    Parameters
    ----------
    expand : callable
    start : ndarray, shape (unknowns,)
        A place within the box.
    idle : ndarray of bool, shape (unknowns,)
        Unknowns that stay as they are.
    most_steps : int
        The most steps.
    damping : float
        Its first value.
    """
    place, here = start, expand(start)
    most_steps = steps_allowed(most_steps, here.bands.size)
    converged, iterations = False, 0
    while iterations < most_steps and not converged and damping <= MOST:
        iterations += 1
        bands = here.bands.copy()
        bands[0] += damping * np.abs(here.bands[0])
        model = BoxModels(bands[None], here.gradient[None], place[None], idle[None])
        (step,), (definite,) = model.steps()
        trial = np.clip(place + step, 0.0, 1.0)
        decrease = float(model.decrease((trial - place)[None])[0]) if definite else np.inf
        there = expand(trial) if definite else here
        small = decrease <= REST * here.value
        if there.value < here.value or (small and there.value <= here.value * (1.0 + ROUNDING)):
            converged = bool(small and damping <= REST_DAMPING)
            place, here = trial, there
            damping = 0.0 if damping * LESS < LEAST else damping * LESS
        else:
            damping = max(damping * MORE, FIRST)
    return BoxMinimum.at(place, here, idle, converged=converged, iterations=iterations)
