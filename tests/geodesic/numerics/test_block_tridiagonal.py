"""Odd-even reduction, compared with dense linear algebra."""

import numpy as np
import pytest

from bodymeasure._typing import Array
from bodymeasure.geodesic.numerics.block_tridiagonal import apply, factorize, solve

SYSTEMS = 20


def dense(diagonal: Array, lower: Array) -> Array:
    """The same matrices as dense ones, shape (systems, 2 k, 2 k)."""
    rows, systems = diagonal.shape[2:]
    result = np.zeros((systems, rows, 2, rows, 2))
    i = np.arange(rows)
    result[:, i, :, i] = diagonal.transpose(2, 3, 0, 1)
    result[:, i[1:], :, i[:-1]] = lower.transpose(2, 3, 0, 1)
    result[:, i[:-1], :, i[1:]] = lower.transpose(2, 3, 1, 0)
    return result.reshape(systems, 2 * rows, 2 * rows)


@pytest.mark.parametrize("rows", [1, 2, 3, 4, 6, 31, 32])
@pytest.mark.parametrize("shift", [0.0, 6.0])
def test_solutions_and_inertia(rng: np.random.Generator, rows: int, shift: float) -> None:
    diagonal = rng.standard_normal((2, 2, rows, SYSTEMS))
    diagonal += diagonal.swapaxes(0, 1) + shift * np.eye(2)[:, :, None, None]
    lower = rng.standard_normal((2, 2, rows - 1, SYSTEMS))
    right = rng.standard_normal((2, rows, SYSTEMS))
    matrix = dense(diagonal, lower)
    factors = factorize(diagonal, lower)
    eigenvalues = np.linalg.eigvalsh(matrix)
    assert (factors.negative == (eigenvalues < 0.0).sum(axis=1)).all()
    flat = right.transpose(2, 1, 0).reshape(SYSTEMS, -1, 1)
    expected = np.linalg.solve(matrix, flat)[..., 0]
    solution = solve(factors, right).transpose(2, 1, 0).reshape(SYSTEMS, -1)
    # Without pivoting, the loss of digits depends on the pivots of the indefinite systems.
    condition = np.abs(eigenvalues).max(axis=1) / np.abs(eigenvalues).min(axis=1)
    error = np.abs(solution - expected).max(axis=1) / np.abs(expected).max(axis=1)
    definite = eigenvalues[:, 0] > 0.0
    assert (error[definite] <= 1e-14 * condition[definite]).all()
    assert np.median(error) < 1e-11


def test_a_singular_matrix_is_not_positive_definite() -> None:
    diagonal = np.zeros((2, 2, 3, 3))
    diagonal[0, 0] = diagonal[1, 1] = 1.0
    diagonal[:, :, 1, 1] = 0.0
    diagonal[:, :, 1, 2] = np.nan
    negative = factorize(diagonal, np.zeros((2, 2, 2, 3))).negative
    assert negative[0] == 0
    assert (negative[1:] > 0).all()


def test_products_of_blocks(rng: np.random.Generator) -> None:
    blocks = rng.standard_normal((2, 2, 4, SYSTEMS))
    vectors = rng.standard_normal((2, 4, SYSTEMS))
    expected = np.einsum("abks,bks->aks", blocks, vectors)
    assert apply(blocks, vectors) == pytest.approx(expected, abs=1e-14)
