"""Gaussian elimination of many small systems at once: the batch runs along the last axis.

Every step is one operation on arrays as long as the batch, and none writes in place, so that
arrays of any library serve (the Python array API standard).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from scipy.linalg import cho_solve

# Up to so many systems, calls cost more than arithmetic.
FEW = 64
# Of systems as large as this, few are solved one by one.
LARGE = 48


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
    solution: list[Any] = []
    for inverse, row, value in reversed(rows):
        for factor, known in zip(range(row.shape[0]), solution, strict=True):
            value = value - row[factor, :] * known
        solution.insert(0, value * inverse)
    return xp.stack(solution)


class SymmetricSolution(NamedTuple):
    """Solutions of symmetric systems, and what elimination tells of the matrices.

    Parameters
    ----------
    solution : array, shape (n, problems)
    pivots : array, shape (n, problems)
        As many are negative as eigenvalues are: Sylvester's law of inertia.
    """

    solution: Any
    pivots: Any


def solve_symmetric(columns: list[Any], right: Any, xp: Any) -> SymmetricSolution:
    """Solve symmetric systems without pivoting.

    Parameters
    ----------
    columns : list of array, n of them
        Column j of the lower triangle, from the diagonal down, shape (n - j, problems).
    right : array, shape (n, problems)
    xp : namespace of the arrays
    """
    if len(columns) >= LARGE and right.shape[1] <= FEW and isinstance(right, np.ndarray):
        return _one_by_one(columns, right, xp)
    return _eliminated(columns, right, xp)


def _one_by_one(columns: list[Any], right: Any, xp: Any) -> SymmetricSolution:
    """By Cholesky factorization; systems that are not positive definite by elimination."""
    solution, pivots = np.empty_like(right), np.empty_like(right)
    matrix = np.zeros((right.shape[1], len(right), len(right)))
    for j, column in enumerate(columns):
        matrix[:, j:, j] = column.T
    indefinite = []
    for number, lower in enumerate(matrix):
        try:
            factor = np.linalg.cholesky(lower)
        except np.linalg.LinAlgError:
            indefinite.append(number)
            continue
        solution[:, number] = cho_solve((factor, True), right[:, number], check_finite=False)
        pivots[:, number] = np.diagonal(factor) ** 2
    if indefinite:
        some = [column[:, indefinite] for column in columns]
        solution[:, indefinite], pivots[:, indefinite] = _eliminated(some, right[:, indefinite], xp)
    return SymmetricSolution(solution, pivots)


def _eliminated(columns: list[Any], right: Any, xp: Any) -> SymmetricSolution:
    # The right side stands below each column as one more row of the matrix.
    columns = [xp.concat([column, right[j : j + 1, :]]) for j, column in enumerate(columns)]
    steps = _by_column(columns) if right.shape[1] > FEW else _at_once(columns, xp)
    pivots, factors = zip(*steps, strict=True)
    solution: list[Any] = []
    for factor in reversed(factors):
        value = factor[-1, :]
        for k, known in enumerate(solution):
            value = value - factor[k, :] * known
        solution.insert(0, value)
    return SymmetricSolution(xp.stack(solution), xp.stack(pivots))


def _by_column(columns: list[Any]) -> Iterator[tuple[Any, Any]]:
    """Pivots, and what stands below them divided by them: half the arithmetic, more calls."""
    for i in range(len(columns)):
        column = columns[i]
        factor = column[1:, :] / column[0, :]
        yield column[0, :], factor
        for j in range(i + 1, len(columns)):
            columns[j] = columns[j] - factor[j - i - 1 :, :] * column[j - i, :]


def _at_once(columns: list[Any], xp: Any) -> Iterator[tuple[Any, Any]]:
    """The same by one operation a pivot on all that is left of the matrix."""
    matrix = xp.stack(
        [xp.concat([xp.zeros_like(columns[0][:j, :]), column]) for j, column in enumerate(columns)],
        axis=1,
    )
    for _ in range(len(columns)):
        column = matrix[:, 0, :]
        factor = column[1:, :] / column[0, :]
        yield column[0, :], factor
        matrix = matrix[1:, 1:, :] - factor[:, None, :] * column[None, 1:-1, :]
