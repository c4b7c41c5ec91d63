"""Matrices of decimals with many digits, for changes of basis that are ill-conditioned."""

from contextlib import AbstractContextManager
from decimal import Context, Decimal, localcontext
from typing import Any

import numpy as np
from numpy.typing import NDArray

# Smooth kernels on many centers give condition numbers far beyond 1e16, though the space they span
# is well behaved: only the basis is bad. So the change of basis, from coefficients to nodal values,
# is done once per space in this many digits, and every matrix that double precision then meets has
# entries of moderate size.
DIGITS = 60

Decimals = NDArray[Any]
"""An array of `Decimal`."""


def many_digits() -> AbstractContextManager[Context]:
    """Return a context manager in which decimals are calculated with `DIGITS` digits."""
    return localcontext(Context(prec=DIGITS))


def decimals(values: Any) -> Decimals:
    """Return numbers as an array of `Decimal`, exactly."""
    values = np.asarray(values, dtype=np.float64)
    flat = [Decimal(value) for value in values.ravel().tolist()]
    return np.array(flat, dtype=object).reshape(values.shape)


def longdoubles(values: Decimals) -> NDArray[np.longdouble]:
    """Return decimals in extended precision, by way of text: floats would cut them to double."""
    texts = [f"{value:.25e}" for value in values.ravel()]
    return np.array(texts, dtype=np.longdouble).reshape(values.shape)


def inverse(matrix: Decimals) -> tuple[Decimals | None, float]:
    """Return the Gauss-Jordan inverse with row pivoting, and the condition number in the 1-norm.

    The inverse of a singular matrix is None.
    """
    size = len(matrix)
    rows = np.hstack([matrix, decimals(np.eye(size))])
    for k in range(size):
        pivot = max(range(k, size), key=lambda i: abs(rows[i, k]))
        if rows[pivot, k] == 0:
            return None, float("inf")
        rows[[k, pivot]] = rows[[pivot, k]]
        rows[k] = rows[k] / rows[k, k]
        others = np.arange(size) != k
        rows[others] = rows[others] - rows[others, k : k + 1] * rows[k]
    inverted = rows[:, size:]
    norms = [max(abs(part).sum(axis=0)) for part in (matrix, inverted)]
    return inverted, float(norms[0] * norms[1])
