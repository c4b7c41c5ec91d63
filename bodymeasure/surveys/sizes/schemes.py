"""How sizes are chosen: by steps of the key measurements, or so that most bodies are near to one.

A scheme says where the sizes lie; whom they fit is the same for all.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.arguments import shown
from bodymeasure.errors import InputError, MissingExtraError

# Bodies among which medoids are looked for: distances of all pairs have to fit into memory. Of
# more, a random sample serves (CLARA, Kaufman and Rousseeuw, 1990).
MOST = 4000
SEED = 0
# The least part of a population for which it is worth making a size.
LEAST = 0.01


class SizeScheme(Protocol):
    """A way to choose sizes."""

    @property
    def steps(self) -> Mapping[str, float]:
        """The key measurements, each with the difference of neighboring sizes.

        They are in the survey's unit; a size fits bodies within half of it to both sides.
        """
        ...

    def centers(self, values: Array) -> Array:
        """Return where the sizes lie.

        Parameters
        ----------
        values : ndarray, shape (bodies, k)
            Key measurements of bodies that have all of them.

        Returns
        -------
        ndarray, shape (sizes, k)
        """
        ...


def _checked(steps: Mapping[str, float]) -> None:
    if not isinstance(steps, Mapping) or not steps:
        raise InputError(
            f"the steps are {shown(steps)}; expected key measurements with the difference of "
            "neighboring sizes, such as {'stature': 8, 'bust_girth': 4}"
        )
    for key, step in steps.items():
        if not isinstance(step, (int, float)) or not 0.0 < step < float("inf"):
            raise InputError(f"the step of {key} is {shown(step)}; expected a number above zero")


@dataclass(frozen=True)
class StepSizes:
    """Sizes at multiples of steps, as in tables of standards; those that enough bodies have.

    Parameters
    ----------
    steps : mapping of str to float
        The key measurements, each with the difference of neighboring sizes, in the survey's unit.
    least : float
        The least part of the bodies for which there is a size.
    most : int, optional
        The largest number of sizes; those of the most bodies are kept.

    Examples
    --------
    >>> from bodymeasure.surveys import StepSizes
    >>> StepSizes({"stature": 8.0, "bust_girth": 4.0}, least=0.02)
    StepSizes(steps={'stature': 8.0, 'bust_girth': 4.0}, least=0.02, most=None)
    """

    steps: Mapping[str, float]
    least: float = LEAST
    most: int | None = None

    def __post_init__(self) -> None:
        _checked(self.steps)
        if not isinstance(self.least, (int, float)) or not 0.0 <= self.least <= 1.0:
            raise InputError(f"least is {shown(self.least)}; expected a part between 0 and 1")
        if self.most is not None and (not isinstance(self.most, int) or self.most < 1):
            raise InputError(f"most is {shown(self.most)}; expected a number from 1 on, or None")

    def centers(self, values: Array) -> Array:
        """Return the multiples of the steps that enough bodies are nearest to."""
        step = np.array(list(self.steps.values()), dtype=np.float64)
        cells, counts = np.unique(np.floor(values / step + 0.5), axis=0, return_counts=True)
        order = np.argsort(-counts, kind="stable")
        kept = order[counts[order] >= max(self.least * len(values), 1.0)][: self.most]
        return np.asarray(cells[np.sort(kept)] * step)


@dataclass(frozen=True)
class MedoidSizes:
    """So many sizes, each that of a body, so that bodies are as near as can be to one of them.

    Parameters
    ----------
    steps : mapping of str to float
        The key measurements, each with the difference that counts as much as those of the others,
        in the survey's unit; a size fits bodies within half of it.
    count : int
        How many sizes.

    Examples
    --------
    >>> from bodymeasure.surveys import MedoidSizes
    >>> MedoidSizes({"stature": 8.0, "bust_girth": 4.0}, count=12).count
    12

    Notes
    -----
    k-medoids by FasterPAM (Schubert and Rousseeuw, 2021), from the package kmedoids, on the sum of
    distances in steps.
    """

    steps: Mapping[str, float]
    count: int = field(default=12)

    def __post_init__(self) -> None:
        _checked(self.steps)
        if not isinstance(self.count, int) or self.count < 1:
            raise InputError(f"count is {shown(self.count)}; expected a number from 1 on")

    def centers(self, values: Array) -> Array:
        """Return the key measurements of the bodies that are the sizes."""
        try:
            import kmedoids
        except ImportError:
            raise MissingExtraError("sizes by medoids", "kmedoids", "survey") from None
        step = np.array(list(self.steps.values()), dtype=np.float64)
        distinct = np.unique(values, axis=0)
        if len(distinct) > MOST:
            chosen = np.random.default_rng(SEED).choice(len(distinct), MOST, replace=False)
            distinct = distinct[np.sort(chosen)]
        if len(distinct) <= self.count:
            return distinct
        apart = np.zeros((len(distinct), len(distinct)))
        for column in (distinct / step).T:
            apart += (column[:, None] - column) ** 2
        np.sqrt(apart, out=apart)
        found = kmedoids.fasterpam(apart, self.count, init="build", random_state=SEED, n_cpu=1)
        medoids = distinct[np.asarray(found.medoids, dtype=np.int64)]
        return np.asarray(medoids[np.lexsort(medoids.T[::-1])])
