"""Gaussian elimination of many small systems at once: the batch runs along the last axis.

Every step is one operation on arrays as long as the batch. No step assigns to a part of an array,
so that arrays of any library serve (the Python array API standard); ``-=`` works in place where the
library does, and makes a new array elsewhere.
"""

from collections.abc import Iterator
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.numerics.array_libraries import constant

# For up to so many systems, calls cost more than arithmetic.
FEW = 64
# If systems are as large as this, a few of them are solved one by one.
LARGE = 48
# From here on, a second factorization takes longer than SciPy's import.
LARGEST = 256


def solve_batch(matrix: Any, right: Any, xp: Any) -> Any:
    """Solve systems without pivoting.

    A system that would need it ends in numbers that are huge or not finite, for the caller to see.

    Parameters
    ----------
    matrix : array, shape (n, n, problems)
    right : array, shape (n, problems)
    xp : namespace of the arrays

    Returns
    -------
    array, shape (n, problems)
    """
    rows = []
    size = matrix.shape[0]
    for _ in range(size):
        inverse = 1.0 / matrix[0, 0, :]
        rows.append((inverse, matrix[0, 1:, :], right[0, :]))
        factors = matrix[1:, 0, :] * inverse
        right = right[1:, :] - factors * rows[-1][2]
        matrix = matrix[1:, 1:, :] - factors[:, None, :] * rows[-1][1][None, :, :]
    solution = right
    for inverse, row, value in reversed(rows):
        value = (value - xp.sum(row * solution, axis=0)) * inverse
        solution = xp.concat([value[None, :], solution])
    return solution


class SymmetricSolution(NamedTuple):
    """The solutions of symmetric systems, and the pivots of the matrices.

    Parameters
    ----------
    solution : array, shape (n, problems)
    pivots : array, shape (n, problems)
        As many of them are negative as eigenvalues are (Sylvester's law of inertia).
    """

    solution: Any
    pivots: Any


def solve_symmetric(triangle: Any, right: Any, xp: Any) -> SymmetricSolution:
    """Solve symmetric systems without pivoting.

    Parameters
    ----------
    triangle : array, shape (n * (n + 1) / 2, problems)
        The lower triangle, column by column, each from the diagonal down.
    right : array, shape (n, problems)
    xp : namespace of the arrays
    """
    if right.shape[0] >= LARGE and right.shape[1] <= FEW and isinstance(right, np.ndarray):
        return _one_by_one(triangle, right, xp)
    if right.shape[1] <= FEW and isinstance(right, np.ndarray):
        return _at_a_time(triangle, right) or _eliminated(triangle, right, xp)
    return _eliminated(triangle, right, xp)


def _at_a_time(triangle: Array, right: Array) -> SymmetricSolution | None:
    """Solve by LAPACK's loops over the batch; None if a matrix is not positive definite."""
    size = len(right)
    matrix = triangle[_places(size)].reshape(size, size, -1).transpose(2, 0, 1)
    try:
        factor = np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        return None
    solution = np.linalg.solve(matrix, right.T[..., None])[..., 0].T
    return SymmetricSolution(solution, np.diagonal(factor, axis1=1, axis2=2).T ** 2)


def _one_by_one(triangle: Any, right: Any, xp: Any) -> SymmetricSolution:
    """Solve by Cholesky factorization, or by elimination what is not positive definite."""
    solution, pivots = np.empty_like(right), np.empty_like(right)
    size, count = right.shape
    columns, rows = np.triu_indices(size)
    lower = np.zeros((size, size))
    indefinite = []
    for number in range(count):
        lower[rows, columns] = triangle[:, number]
        try:
            factor = np.linalg.cholesky(lower)
        except np.linalg.LinAlgError:
            indefinite.append(number)
            continue
        solution[:, number] = _by_factor(factor, right[:, number])
        pivots[:, number] = np.diagonal(factor) ** 2
    if indefinite:
        left = _eliminated(triangle[:, indefinite], right[:, indefinite], xp)
        solution[:, indefinite], pivots[:, indefinite] = left
    return SymmetricSolution(solution, pivots)


def _by_factor(factor: Any, right: Any) -> Any:
    """Solve a system by its Cholesky factor."""
    if len(factor) < LARGEST:
        return np.linalg.solve(factor.T, np.linalg.solve(factor, right))
    return scipy.linalg.cho_solve((factor, True), right, check_finite=False)


def _eliminated(triangle: Any, right: Any, xp: Any) -> SymmetricSolution:
    eliminate = _by_column if right.shape[1] > FEW else _at_once
    pivots, factors = zip(*eliminate(triangle, right, xp), strict=True)
    solution = right[:0, :]
    for factor in reversed(factors):
        value = factor[-1, :] - xp.sum(factor[:-1, :] * solution, axis=0)
        solution = xp.concat([value[None, :], solution])
    return SymmetricSolution(solution, xp.stack(pivots))


def _by_column(triangle: Any, right: Any, xp: Any) -> Iterator[tuple[Any, Any]]:
    """Yield pivots and the entries below them divided by them: half the arithmetic, more calls."""
    # The right side stands below each column as one more row of the matrix.
    columns, first = [], 0
    for j, size in enumerate(range(right.shape[0], 0, -1)):
        columns.append(xp.concat([triangle[first : first + size, :], right[j : j + 1, :]]))
        first += size
    for i, column in enumerate(columns):
        factor = column[1:, :] / column[0, :]
        yield column[0, :], factor
        for j in range(i + 1, len(columns)):
            columns[j] -= factor[j - i - 1 :, :] * column[j - i, :]


def _at_once(triangle: Any, right: Any, xp: Any) -> Iterator[tuple[Any, Any]]:
    """Yield the same by one operation for each pivot on all that is left of the matrix."""
    size = right.shape[0]
    square = xp.take(triangle, constant(_places(size), triangle, xp), axis=0)
    matrix = xp.concat([xp.reshape(square, (size, size, -1)), right[None, :, :]])
    for _ in range(size):
        column = matrix[:, 0, :]
        factor = column[1:, :] / column[0, :]
        yield column[0, :], factor
        matrix = matrix[1:, 1:, :]
        matrix -= factor[:, None, :] * column[None, 1:-1, :]


@lru_cache
def _places(size: int) -> Ints:
    """The place of each entry of a symmetric matrix in its packed triangle, flattened."""
    places = np.zeros((size, size), np.int64)
    columns, rows = np.triu_indices(size)
    places[rows, columns] = places[columns, rows] = np.arange(len(rows))
    return places.ravel()
