"""Positions and derivatives of patches at one point each, for many small batches.

The numbers are those of `bodymeasure.bezier.derivatives`, found three times as fast for some
hundred points: there, more time goes into preparing the Bernstein basis than into arithmetic.
"""

from math import factorial

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier import bernstein, divide
from bodymeasure.native import MOST_DEGREE, is_compiled, power_jets


def power_coefficients(nets: Array) -> Array:
    """Return the coefficients of u^i v^j of patches (patches, m + 1, m + 1, 3 or 4)."""
    degree = nets.shape[-2] - 1
    # Row k holds the k-th derivative at 0 over k!.
    factorials = np.array([factorial(k) for k in range(degree + 1)], dtype=np.float64)
    to_powers = bernstein(degree, 0.0, order=degree) / factorials[:, None]
    return np.asarray(np.einsum("ai,bj,pijc->pabc", to_powers, to_powers, nets))


def jets(coefficients: Array, x: Array) -> Array:
    """Return derivatives up to the second of patches (k, m + 1, m + 1, 3 or 4) at x (k, 2).

    Returns
    -------
    ndarray, shape (k, 3, 3, 3)
        ``[:, i, j]`` is the derivative taken i times by u and j times by v.
    """
    count, side, _, coordinates = coefficients.shape
    if is_compiled() and side <= MOST_DEGREE + 1:
        found = power_jets(coefficients, x)
        return divide(found) if coordinates == 4 else found
    exponents = np.arange(side, dtype=np.float64)
    powers = np.zeros((count, 2, 3, side))
    values = powers[:, :, 0]
    values[..., 0] = 1.0
    for k in range(1, side):
        np.multiply(values[..., k - 1], x, out=values[..., k])
    powers[:, :, 1, 1:] = exponents[1:] * values[..., :-1]
    powers[:, :, 2, 2:] = (exponents * (exponents - 1.0))[2:] * values[..., :-2]
    along_u = powers[:, 0] @ coefficients.reshape(count, side, side * coordinates)
    result = powers[:, 1, None] @ along_u.reshape(count, 3, side, coordinates)
    return divide(result) if coordinates == 4 else result
