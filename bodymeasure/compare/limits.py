"""Limits of agreement of two methods, after Bland and Altman."""

import math
from collections.abc import Sequence
from statistics import fmean, stdev
from typing import NamedTuple

from scipy.special import ndtri, stdtrit

CONFIDENCE = 0.95


class Limits(NamedTuple):
    """The range that holds most differences of two methods, and how sure its ends are.

    Parameters
    ----------
    lower, upper : float
        The limits of agreement, which hold 95 % of differences that are normal.
    half_width : float
        Half of the width of the 95 % confidence interval of each limit.
    """

    lower: float
    upper: float
    half_width: float


def limits_of_agreement(differences: Sequence[float]) -> Limits | None:
    """Return the limits of agreement; None for fewer than two differences.

    Parameters
    ----------
    differences : sequence of float
        One for each subject.

    Notes
    -----
    With the mean m and the standard deviation s of n differences, the limits are m - z s and
    m + z s with z = 1.96, and the variance of each is s^2 (1/n + z^2 / (2 (n - 1))) (J. M. Bland
    and D. G. Altman, *Measuring agreement in method comparison studies*, 1999, section 2.1).
    """
    count = len(differences)
    if count < 2:
        return None
    mean, deviation = fmean(differences), stdev(differences)
    z = float(ndtri(0.5 + 0.5 * CONFIDENCE))
    error = deviation * math.sqrt(1.0 / count + z**2 / (2.0 * (count - 1)))
    t = float(stdtrit(count - 1, 0.5 + 0.5 * CONFIDENCE))
    return Limits(mean - z * deviation, mean + z * deviation, t * error)
