"""Intra-class correlation: how much of the spread of values is that of the subjects."""

from typing import NamedTuple

import numpy as np
from scipy.special import fdtri

from bodymeasure._typing import Array

CONFIDENCE = 0.95
# Subjects fewer than these have no spread that could be told from that of the methods.
FEWEST = 3
# A variance below this part of the values squared is their rounding.
ROUNDING = 1e-28


class Intraclass(NamedTuple):
    """Coefficients of intra-class correlation of single values.

    Parameters
    ----------
    agreement : float
        ICC(A,1), for which a constant difference of the methods counts; 1 if they agree.
    low, high : float or None
        The ends of its 95 % confidence interval; None where the methods agree exactly.
    consistency : float
        ICC(C,1), for which it does not count.
    """

    agreement: float
    low: float | None
    high: float | None
    consistency: float


def intraclass(values: Array) -> Intraclass | None:
    """Return the intra-class correlation of methods over subjects.

    Parameters
    ----------
    values : ndarray, shape (subjects, methods)

    Returns
    -------
    Intraclass or None
        None for fewer than three subjects, or where all of them have the same values.

    Notes
    -----
    Both coefficients are those of two-way models (K. O. McGraw and S. P. Wong, *Forming inferences
    about some intraclass correlation coefficients*, 1996, tables 4 and 7), which P. E. Shrout and
    J. L. Fleiss (1979) call ICC(2,1) and ICC(3,1).
    """
    n, k = values.shape
    if n < FEWEST:
        return None
    mean = values.mean()
    rows, columns = values.mean(axis=1), values.mean(axis=0)
    rest = values - rows[:, None] - columns + mean
    # Mean squares: of subjects, of methods, and of what is left.
    of_rows = k * float(((rows - mean) ** 2).sum()) / (n - 1)
    of_columns = n * float(((columns - mean) ** 2).sum()) / (k - 1)
    error = float((rest**2).sum()) / ((n - 1) * (k - 1))
    tiny = ROUNDING * float(np.square(values).max())
    if max(of_rows, error) <= tiny:
        return None
    consistency = (of_rows - error) / (of_rows + (k - 1) * error)
    agreement = (of_rows - error) / (of_rows + (k - 1) * error + k * (of_columns - error) / n)
    if max(error, of_columns) <= tiny:
        return Intraclass(1.0, None, None, 1.0)
    a = k * agreement / (n * (1.0 - agreement))
    b = 1.0 + k * agreement * (n - 1) / (n * (1.0 - agreement))
    free = (a * of_columns + b * error) ** 2 / (
        (a * of_columns) ** 2 / (k - 1) + (b * error) ** 2 / ((n - 1) * (k - 1))
    )
    part = 0.5 + 0.5 * CONFIDENCE
    lower, upper = float(fdtri(n - 1, free, part)), float(fdtri(free, n - 1, part))
    others = k * of_columns + (k * n - k - n) * error
    return Intraclass(
        agreement,
        n * (of_rows - lower * error) / (lower * others + n * of_rows),
        n * (upper * of_rows - error) / (others + n * upper * of_rows),
        consistency,
    )
