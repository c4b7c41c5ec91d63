"""Percentiles of a population, and how far a sample of people leaves them uncertain."""

from dataclasses import dataclass

import numpy as np
import scipy

from bodymeasure._typing import Array

PERCENTILES = (1.0, 5.0, 25.0, 50.0, 75.0, 95.0, 99.0)
CONFIDENCE = 0.95


@dataclass(frozen=True)
class Percentile:
    """A percentile of a sample.

    Parameters
    ----------
    percent, value : float
    low, high : float or None
        The ends of the 95 % interval for that of the population; None where the sample is too small
        to have such an end.
    """

    percent: float
    value: float
    low: float | None
    high: float | None


@dataclass(frozen=True)
class Summary:
    """A measurement over all bodies that have a value of it.

    Parameters
    ----------
    count : int
    mean, deviation : float or None
        The sample's; None for too few.
    minimum, maximum : float or None
    percentiles : tuple of Percentile
    """

    count: int
    mean: float | None
    deviation: float | None
    minimum: float | None
    maximum: float | None
    percentiles: tuple[Percentile, ...]


def summary(values: Array) -> Summary:
    """Return what a measurement comes to.

    Parameters
    ----------
    values : ndarray, shape (n,)
        NaN where there is none.
    """
    known = np.sort(values[np.isfinite(values)])
    count = len(known)
    if not count:
        return Summary(0, None, None, None, None, ())
    return Summary(
        count=count,
        mean=float(known.mean()),
        deviation=float(known.std(ddof=1)) if count > 1 else None,
        minimum=float(known[0]),
        maximum=float(known[-1]),
        percentiles=tuple(
            Percentile(
                percent,
                float(np.quantile(known, percent / 100.0)),
                *percentile_interval(known, percent / 100.0),
            )
            for percent in PERCENTILES
        ),
    )


def percentile_interval(
    ordered: Array, part: float, confidence: float = CONFIDENCE
) -> tuple[float | None, float | None]:
    """Return an interval that holds a quantile of the population with a probability.

    Parameters
    ----------
    ordered : ndarray, shape (n,)
        The sample, in ascending order.
    part : float
        The quantile, between 0 and 1.
    confidence : float
        The probability; that either end misses is half of the rest, at most.

    Returns
    -------
    tuple of (float or None, float or None)

    Notes
    -----
    How many of a sample lie below a quantile of the population is distributed binomially, whatever
    the population is like, so that two members of the sample are the ends of the interval (Conover,
    *Practical Nonparametric Statistics*, 1999, 3.2).
    """
    count, tail = len(ordered), 0.5 * (1.0 - confidence)
    below = scipy.stats.binom(count, part)
    low, high = int(below.ppf(tail)) - 1, int(below.isf(tail))
    return (
        float(ordered[low]) if low >= 0 else None,
        float(ordered[high]) if high < count else None,
    )
