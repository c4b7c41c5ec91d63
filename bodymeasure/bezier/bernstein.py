"""The Bernstein basis and its derivatives."""

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
    # The k-th derivative has `difference @ coefficients` as its coefficients, of degree n - k.
    difference = np.eye(degree + 1)
    for k in range(min(order, degree) + 1):
        result[..., k, :] = np.stack(bernstein_values(degree - k, t), axis=-1) @ difference
        difference = (degree - k) * np.diff(difference, axis=0)
    return result


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
