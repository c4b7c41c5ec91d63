"""The Bernstein basis and its derivatives."""

from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array


def bernstein(degree: int, t: ArrayLike, order: int = 0) -> Array:
    """Bernstein polynomials and their derivatives.

    Parameters
    ----------
    degree : int
        Degree n of the basis, at least 0.
    t : array_like, shape (...)
        Parameters; any real number, [0, 1] is the patch.
    order : int
        Highest derivative wanted.

    Returns
    -------
    ndarray, shape (..., order + 1, degree + 1)
        ``[..., k, i]`` is the k-th derivative of ``B_i^n`` at t; zero where k > n.

    Notes
    -----
    G. Farin, *Curves and Surfaces for CAGD*, 5th ed., equations (5.1), (5.2) and (5.24):
    values by the recursion over degrees, derivatives as differences of a lower-degree basis.
    """
    t = np.asarray(t, dtype=np.float64)
    result = np.zeros((*t.shape, order + 1, degree + 1))
    for i, value in enumerate(bernstein_values(degree, t)):
        result[..., 0, i] = value
    for k in range(1, min(order, degree) + 1):
        values = np.empty((*t.shape, degree - k + 1))
        for i, value in enumerate(bernstein_values(degree - k, t)):
            values[..., i] = value
        result[..., k, :] = values @ _differences(degree, k)
    return result


@lru_cache(maxsize=256)
def _differences(degree: int, k: int) -> Array:
    """The map from coefficients to those of the k-th derivative, of degree n - k."""
    difference = np.eye(degree + 1)
    for lower in range(k):
        difference = (degree - lower) * np.diff(difference, axis=0)
    return difference


def bernstein_values(degree: int, t: Array) -> list[Array]:
    """The degree + 1 Bernstein polynomials at t, each of the shape of t.

    One array a polynomial: the layout that is fastest where many patches are evaluated at once.
    """
    s = 1.0 - t
    if degree == 0:
        return [np.ones_like(t)]
    values = [s, t]
    for _ in range(degree - 1):
        lower = [s * value for value in values]
        upper = [t * value for value in values]
        inner = [a + b for a, b in zip(lower[1:], upper[:-1], strict=True)]
        values = [lower[0], *inner, upper[-1]]
    return values
