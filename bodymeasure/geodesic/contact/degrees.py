"""Degrees of the polynomials that make a path exact, and which of them to try next."""

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.spaces.trial_space import TrialSpace

# The degrees that are tried in turn. Strongly bent paths take the highest; at higher ones, rounding
# errors outweigh the gain.
DEGREES = (12, 20, 32, 48, 72, 108, 160)
# Those that are tried on one patch, where elements (`geodesic.elements`) serve the others better.
LOWER_DEGREES = DEGREES[:4]
# Errors fall about geometrically with the degree. This part of the degree so predicted is taken,
# since they fall faster at the end than at the beginning.
CAUTION = 0.75
# A path may leave the box by this much, in u or v, without better ones leaving it.
OVERSHOOT = 1e-9
# A path is off by about the square root of the excess of its length. If it leaves the box by more
# than so many times that, better paths would leave it, too.
OFF = 10.0


def degrees_wanted(degree: int, length: Length, tolerance: float) -> Array:
    """Return the degrees that paths seem to need, by their errors on one; shape (problems,).

    Parameters
    ----------
    degree : int
        The degree of the paths.
    length : Length
        Their lengths, none of which is known to the tolerance.
    tolerance : float
        The relative error asked for.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        known = np.log(np.clip(length.error / length.raw, tolerance, 0.5))
        predicted = CAUTION * degree * np.log(tolerance) / known
    # If nothing is known, the next degree is tried.
    return np.where(np.isfinite(predicted), predicted, degree + 1.0)


def leave_for_certain(space: TrialSpace, values: Array, length: Length) -> Bools:
    """Return which paths leave their patch by so much that no higher degree brings them back.

    Parameters
    ----------
    space : TrialSpace
    values : ndarray, shape (problems, 2, n + 1)
    length : Length
        Their lengths, known to the tolerance that is asked for.
    """
    paths = values @ space.between_nodes.T
    outside = np.abs(paths - 0.5).max(axis=(1, 2)) - 0.5
    off = np.sqrt(np.abs(length.correction) * length.raw)
    result: Bools = outside > OVERSHOOT + OFF * off
    return result
