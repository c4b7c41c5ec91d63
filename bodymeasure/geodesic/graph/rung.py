"""One trial space of several that are tried in turn: what is given to it, and what it gives."""

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.solving.protocol import PathBatch
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.spaces.trial_space import TrialSpace

# The first guess is made by Newton steps from the straight line on polynomials of this degree.
GUESS_DEGREE = 5
GUESS_STEPS = 2
# No step moves a node further: Newton's method from a straight line may go far astray.
LONGEST_STEP = 0.15
# An offset beyond this, where the patch ends at 1, comes from a system that was nearly singular.
MAX_OFFSET = 1.0


class Rung(NamedTuple):
    """A trial space, and how far it goes.

    Parameters
    ----------
    before : TrialSpace
        The space that the offsets come from.
    space : TrialSpace
    steps : int
        The number of Newton steps.
    small : float
        The size that the last of them may have.
    tolerance : float
        The relative error of the length that is asked for.
    """

    before: TrialSpace
    space: TrialSpace
    steps: int
    small: float
    tolerance: float


class Climbed(NamedTuple):
    """What became of some problems on a trial space.

    Parameters
    ----------
    done : PathBatch
        The paths that are done: whose lengths are good, or that run far outside their patch. Their
        problems are numbered as places among those that were given.
    left : ndarray of int, shape (k,)
        The places of those that are left to another space. What is in neither is left to the form
        with two unknown functions.
    offset : array, shape (n - 1, k)
        Their offsets at the inner nodes.
    """

    done: PathBatch
    left: Ints
    offset: Any


def guess_space() -> TrialSpace:
    """Return the space on which the first guess is made."""
    return polynomial_space(GUESS_DEGREE)


def inner_maps(space: TrialSpace, times: Array) -> Array:
    """Return the maps of `matrices` for functions that vanish at the ends, from inner nodes."""
    return _inner_at(space, tuple(times.tolist()))


@lru_cache(maxsize=64)
def _inner_at(space: TrialSpace, times: tuple[float, ...]) -> Array:
    return np.ascontiguousarray(space.matrices(np.array(times))[:, :, 1:-1])
