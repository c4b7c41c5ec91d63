"""Correlations of measurements, over the bodies that have both."""

import numpy as np

from bodymeasure._typing import Array

# A sum of squares below this part of the squares themselves is the rounding of one value.
CONSTANT = 1e-24


def correlations(values: Array) -> Array:
    """Return the coefficients of correlation (Pearson's).

    Parameters
    ----------
    values : ndarray, shape (bodies, k)
        NaN where there is none.

    Returns
    -------
    ndarray, shape (k, k)
        Each over the bodies that have both values; NaN if these are fewer than two, or a value is
        the same on all.
    """
    there = np.isfinite(values)
    middle = np.nanmean(np.where(there.any(axis=0), values, 0.0), axis=0)
    x, known = np.where(there, values - middle, 0.0), there.astype(np.float64)
    # Sums over pairs: of the first, of its squares, and of the products.
    count, sums, squares, products = known.T @ known, x.T @ known, (x * x).T @ known, x.T @ x
    with np.errstate(invalid="ignore", divide="ignore"):
        spread = squares - sums**2 / count
        both = products - sums * sums.T / count
        spread[spread <= CONSTANT * (squares + middle[:, None] ** 2 * count)] = np.nan
        found = both / np.sqrt(spread * spread.T)
    found[count < 2] = np.nan
    return np.clip(found, -1.0, 1.0)
