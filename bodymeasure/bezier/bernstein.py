"""The Bernstein basis and its derivatives."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray


def bernstein(degree: int, t: ArrayLike, order: int = 0) -> NDArray[np.float64]:
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
    # differences[k] maps coefficients of degree n to those of the k-th derivative, degree n - k.
    basis = np.ones((*t.shape, 1))
    bases = [basis]
    for _ in range(degree):
        raised = np.zeros((*t.shape, basis.shape[-1] + 1))
        raised[..., :-1] += (1.0 - t)[..., None] * basis
        raised[..., 1:] += t[..., None] * basis
        basis = raised
        bases.append(basis)
    difference = np.eye(degree + 1)
    for k in range(min(order, degree) + 1):
        result[..., k, :] = bases[degree - k] @ difference
        difference = (degree - k) * np.diff(difference, axis=0)
    return result
