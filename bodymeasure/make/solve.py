"""The most plausible body whose measurements are the wanted ones."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.make.body.measuring import Measuring, Readout
from bodymeasure.make.body.prior import Prior

# Bodies are done when no length is off by more than this, in meters, and no angle by more than
# that, in degrees: far below what any tape tells.
SETTLED, SETTLED_DEGREES = 2e-5, 1e-2
# A round that changes no value by more than this part of that gains nothing more.
IDLE = 0.1
# Rounds after which a value that is still missed is taken for one with a kink, as the largest girth
# of a stretch is where its place jumps: its derivative is the mean of those on both sides.
SMOOTH = 3
# In standard deviations: the most that one round may move a coefficient, beyond which the linear
# rule does not hold.
LONGEST = 4.0


@dataclass(frozen=True, eq=False)
class Wanted:
    """What is asked of a body.

    Parameters
    ----------
    values : ndarray, shape (k,)
        In meters and degrees.
    tolerance : ndarray, shape (k,)
        The standard deviation with which they are to be met.
    degrees : ndarray of bool, shape (k,)
    """

    values: Array
    tolerance: Array
    degrees: Array

    @property
    def settled(self) -> Array:
        """By how much each may be off in the end."""
        return np.where(self.degrees, SETTLED_DEGREES, SETTLED)


@dataclass(frozen=True, eq=False)
class Solution:
    """A body that was found.

    Parameters
    ----------
    coefficients : ndarray, shape (120,)
    readout : Readout
        Its measurements.
    rounds : int
        How many times all measurements were taken after those of the first body.
    settled : bool
        Whether the last round changed nothing that counts.
    """

    coefficients: Array
    readout: Readout
    rounds: int
    settled: bool


def solved(
    measuring: Measuring,
    wanted: Wanted,
    prior: Prior,
    *,
    first: Readout,
    components: int,
    most_rounds: int,
    report: Callable[[int], None] | None = None,
) -> Solution:
    """Return the most plausible body that meets the wanted values within their tolerances.

    Parameters
    ----------
    measuring : Measuring
    wanted : Wanted
    prior : Prior
    first : Readout
        The measurements of the prior's mean body.
    components : int
        How many of the coefficients are free; the others stay at the prior's mean.
    most_rounds : int
    report : callable, optional
        Called with the number of rounds done.

    Notes
    -----
    The body has the least ``|b - mean|^2 + sum ((m(b) - t) / s)^2``, which is found by the rounds
    ``b = mean + J' (J J' + s^2)^-1 (t - m(b) + J (b - mean))`` of Gauss and Newton.
    """
    b, readout = prior.mean.copy(), first
    for number in range(1, most_rounds + 1):
        step = _step(readout, wanted, b - prior.mean, components)
        longest = float(np.abs(step).max())
        step *= min(1.0, LONGEST / longest) if longest > 0.0 else 1.0
        known = np.isfinite(readout.values)
        b = b + step
        before, readout = readout, _with_gaps(measuring.of(b), readout, step)
        if number > SMOOTH:
            readout = _smoothed(readout, before, wanted)
        if report is not None:
            report(number)
        miss = np.abs(readout.values - wanted.values)
        moved = np.abs(readout.values - before.values)[known]
        met = bool((miss <= wanted.settled).all())
        idle = longest <= LONGEST and bool((moved <= IDLE * wanted.settled[known]).all())
        if met or (idle and number > 1):
            return Solution(b, readout, number, True)
    return Solution(b, readout, most_rounds, False)


def _step(readout: Readout, wanted: Wanted, away: Array, components: int) -> Array:
    known = np.isfinite(readout.values)
    slopes = readout.slopes[known, :components]
    tolerance = wanted.tolerance[known]
    rest = wanted.values[known] - readout.values[known] + slopes @ away[:components]
    # Rows in units of their tolerances, so that lengths and angles are alike.
    scaled = slopes / tolerance[:, None]
    system = scaled @ scaled.T + np.eye(len(scaled))
    solution = scaled.T @ scipy.linalg.solve(system, rest / tolerance, assume_a="pos")
    step = np.zeros_like(away)
    step[:components] = solution - away[:components]
    return step


def _smoothed(found: Readout, before: Readout, wanted: Wanted) -> Readout:
    """Return measurements whose derivatives, where they are missed, are means of two rounds."""
    missed = np.abs(found.values - wanted.values) > wanted.settled
    slopes = np.where(missed[:, None], 0.5 * (found.slopes + before.slopes), found.slopes)
    return Readout(found.values, slopes, found.reasons)


def _with_gaps(found: Readout, before: Readout, step: Array) -> Readout:
    """Return measurements with what could not be taken as it would follow from the body before."""
    lost = ~np.isfinite(found.values) & np.isfinite(before.values)
    if not lost.any():
        return found
    values, slopes = found.values.copy(), found.slopes.copy()
    values[lost] = before.values[lost] + before.slopes[lost] @ step
    slopes[lost] = before.slopes[lost]
    return Readout(values, slopes, found.reasons)
