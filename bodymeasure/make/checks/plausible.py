"""How well measurements go together, by the bodies of the space."""

from dataclasses import dataclass

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.make.body.measuring import Readout
from bodymeasure.make.body.prior import Prior

# In meters and degrees: how far a tape in the hand is off, and, as a part of a length, how far the
# linear rule from the mean body is. ISO 20685-1 has 4 to 9 mm for girths between two measurers.
HAND, HAND_DEGREES, LINEAR = 0.005, 2.0, 0.01
# Sets are refused where fewer than this part of all bodies are as far out, and the reader's
# attention is called where fewer than that part are.
REFUSED, DOUBTED = 1e-5, 1e-2
# The tails of bodies are heavier than those of a normal distribution: they are as those of Student
# with so many degrees of freedom. One in a hundred bodies of the space that were held out has a sum
# of squares of 120 coefficients over 246, which so is 253, and 159 if they were normal.
TAILS = 30.0
# In standard deviations: the same for one measurement beside all the others.
STANDS_OUT, ODD = 5.0, 3.5
# In standard deviations: what is called plausible for a single measurement.
PLAUSIBLE = 2.0


@dataclass(frozen=True, eq=False)
class Judgment:
    """How well a set of measurements goes together.

    Parameters
    ----------
    chi_square : float
        The squared distance of the set from the mean body's, in standard deviations of bodies and
        of tapes.
    probability : float
        The part of bodies whose sets are as far out.
    expected, spread : ndarray, shape (k,)
        The mean and the standard deviation of each measurement by itself.
    from_others, beside : ndarray, shape (k,)
        The same, where all the others are known.
    gain : ndarray, shape (k,)
        By how much the chi-square falls without each measurement.
    """

    chi_square: float
    probability: float
    expected: Array
    spread: Array
    from_others: Array
    beside: Array
    gain: Array

    def apart(self, values: Array) -> Array:
        """Return how far each value is from what the others say, in standard deviations."""
        return np.asarray((values - self.from_others) / self.beside)

    def range_of(self, row: int) -> tuple[float, float]:
        """Return between which values a measurement would be plausible beside the others."""
        half = PLAUSIBLE * float(self.beside[row])
        return float(self.from_others[row]) - half, float(self.from_others[row]) + half

    @property
    def worst(self) -> int:
        """The measurement without which the others go together best."""
        return int(self.gain.argmax())


def noise_of(values: Array, degrees: Array) -> Array:
    """Return how far each value may be off because a hand took it, as a standard deviation."""
    return np.where(degrees, HAND_DEGREES, HAND + LINEAR * np.abs(values))


def judged(mean: Readout, values: Array, degrees: Array) -> Judgment:
    """Judge a set of measurements by those of the mean body and their derivatives there.

    Parameters
    ----------
    mean : Readout
        Of the prior's mean body.
    values : ndarray, shape (k,)
        In meters and degrees.
    degrees : ndarray of bool, shape (k,)

    Notes
    -----
    The set's chi-square is ``r' (J J' + N)^-1 r`` with ``r`` the difference from the mean body and
    ``N`` what hands do. With Q the inverse, the others say of measurement i that it is
    ``t_i - (Q r)_i / Q_ii`` with variance ``1 / Q_ii``, and without it the chi-square falls by
    ``(Q r)_i^2 / Q_ii``.
    """
    rest = values - mean.values
    noise = noise_of(mean.values, degrees)
    covariance = mean.slopes @ mean.slopes.T + np.diag(noise**2)
    inverse = np.linalg.inv(covariance)
    pulled, own = inverse @ rest, np.diag(inverse)
    chi_square = float(rest @ pulled)
    return Judgment(
        chi_square=chi_square,
        probability=float(scipy.special.fdtrc(len(values), TAILS, chi_square / len(values))),
        expected=mean.values,
        spread=np.sqrt(np.diag(covariance)),
        from_others=values - pulled / own,
        beside=1.0 / np.sqrt(own),
        gain=pulled**2 / own,
    )


def plausibility_of(coefficients: Array, prior: Prior) -> tuple[float, float]:
    """Return the largest coefficient of a body, and the square root of their mean square."""
    away = coefficients - prior.mean
    return float(np.abs(away).max()), float(np.sqrt((away**2).mean()))
