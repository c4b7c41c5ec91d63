"""What takes part in the benchmark: a method, and the call of it that is timed."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Literal

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bench.problems.sets import Batch
from bodymeasure.errors import BodymeasureError
from bodymeasure.native import without_kernels

Solve = Callable[[], Array]
Family = Literal["bodymeasure", "scipy", "mesh"]
# Determines how many problems a method is given, and how often; see `bodymeasure.bench.size`.
Pace = Literal["batch", "fast", "slow", "very slow"]

# The errors by which a library reports that it cannot measure a problem, which is counted.
FAILURES = (ArithmeticError, RuntimeError, ValueError, BodymeasureError)


@dataclass(frozen=True)
class Entrant(Generic[Batch]):
    """A method with its settings.

    Parameters
    ----------
    method : str
        Its name.
    setting : str
        The setting that is varied, in words; may be empty.
    family : {"bodymeasure", "scipy", "mesh"}
    pace : {"batch", "fast", "slow", "very slow"}
        Determines how many problems the method is given.
    prepare : callable
        Takes problems and returns the call that is timed, which returns their lengths, shape (p,),
        with NaN where there is none.
    """

    method: str
    setting: str
    family: Family
    pace: Pace
    prepare: Callable[[Batch], Solve]

    @property
    def label(self) -> str:
        """The method and its setting."""
        return f"{self.method}, {self.setting}" if self.setting else self.method


def lengths(calls: list[Callable[[], float]]) -> Array:
    """Return what calls return, with NaN for those that fail."""
    return np.array([_length_or_nan(call) for call in calls])


def in_numpy(prepare: Callable[[Batch], Solve]) -> Callable[[Batch], Solve]:
    """Return what prepares one of bodymeasure's own methods in its NumPy form."""

    def prepare_in_numpy(problems: Batch) -> Solve:
        solve = prepare(problems)

        def solve_in_numpy() -> Array:
            with without_kernels():
                return solve()

        return solve_in_numpy

    return prepare_in_numpy


def _length_or_nan(call: Callable[[], float]) -> float:
    try:
        return call()
    except FAILURES:
        return np.nan
