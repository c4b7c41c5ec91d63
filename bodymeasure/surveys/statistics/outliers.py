"""Bodies to look at: values that are far from those of the others."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array

# The median absolute deviation of a normal distribution, as a part of its standard deviation.
MAD = 0.6744897501960817
# A value is to be looked at from so many standard deviations on: of 16,000 normal values, one.
FAR = 4.0
# Fewer values do not tell what is far.
FEWEST = 8


@dataclass(frozen=True)
class Outlier:
    """A body to look at.

    Parameters
    ----------
    body : int
        Its place in the survey.
    column : int
        The measurement that is farthest off.
    value : float
    deviations : float
        By how many standard deviations, estimated without regard to the far ones; its sign says
        to which side.
    others : int
        How many more of its measurements are far off.
    """

    body: int
    column: int
    value: float
    deviations: float
    others: int


def deviations(values: Array) -> Array:
    """Return how far values are from their median, in standard deviations.

    Parameters
    ----------
    values : ndarray, shape (n,)
        NaN where there is none.

    Returns
    -------
    ndarray, shape (n,)
        The deviation is estimated by the median of the distances from the median, which outliers
        leave as it is. NaN where there is no value; 0 where there are too few to tell, or more than
        half are the same.
    """
    known = values[np.isfinite(values)]
    if len(known) < FEWEST:
        return np.where(np.isfinite(values), 0.0, np.nan)
    middle = np.median(known)
    spread = float(np.median(np.abs(known - middle))) / MAD
    if spread == 0.0:
        return np.where(np.isfinite(values), 0.0, np.nan)
    return np.asarray((values - middle) / spread)


class Outliers:
    """Collects the outliers of one measurement after another."""

    def __init__(self, bodies: int) -> None:
        self._farthest = np.zeros(bodies)
        self._column = np.zeros(bodies, dtype=np.int64)
        self._value = np.full(bodies, np.nan)
        self._count = np.zeros(bodies, dtype=np.int64)

    def add(self, column: int, values: Array) -> None:
        """Take note of the values of a measurement."""
        found = np.nan_to_num(deviations(values))
        farther = np.abs(found) > np.abs(self._farthest)
        self._farthest[farther] = found[farther]
        self._column[farther], self._value[farther] = column, values[farther]
        self._count += np.abs(found) >= FAR

    def found(self) -> tuple[Outlier, ...]:
        """Return the bodies to look at, the farthest first."""
        far = np.flatnonzero(self._count)
        order = far[np.argsort(-np.abs(self._farthest[far]), kind="stable")]
        return tuple(
            Outlier(
                int(body),
                int(self._column[body]),
                float(self._value[body]),
                float(self._farthest[body]),
                int(self._count[body]) - 1,
            )
            for body in order
        )


def outliers(values: Array) -> tuple[Outlier, ...]:
    """Return the bodies to look at, the farthest first.

    Parameters
    ----------
    values : ndarray, shape (bodies, k)
        NaN where there is none.
    """
    found = Outliers(len(values))
    for column, each in enumerate(values.T):
        found.add(column, each)
    return found.found()
