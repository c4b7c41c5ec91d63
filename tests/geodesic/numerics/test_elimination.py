import numpy as np
import pytest

from bodymeasure._typing import Array
from bodymeasure.geodesic.numerics.elimination import FEW, LARGE, solve_batch, solve_symmetric


def systems(rng: np.random.Generator, size: int) -> tuple[Array, Array]:
    """Well-conditioned systems that need no pivoting, batch first."""
    matrices = rng.normal(size=(7, size, size))
    matrices += 3.0 * size * np.eye(size)
    return matrices, rng.normal(size=(7, size))


def test_many_systems_at_once(rng: np.random.Generator) -> None:
    for size in (1, 2, 5, 9):
        matrix, right = systems(rng, size)
        expected = np.linalg.solve(matrix, right[..., None])[..., 0]
        found = solve_batch(np.moveaxis(matrix, 0, -1), right.T, np)
        np.testing.assert_allclose(found.T, expected, rtol=1e-12)


def lower_triangle(matrix: Array) -> Array:
    """The systems column by column, with the batch axis last."""
    return np.concatenate([matrix[:, j:, j] for j in range(matrix.shape[1])], axis=1).T


# Few and many systems are eliminated in different ways.
@pytest.mark.parametrize("count", [7, FEW + 1])
def test_symmetric_systems_and_the_signs_of_their_eigenvalues(
    rng: np.random.Generator, count: int
) -> None:
    for size in (1, 2, 6, 16):
        root = rng.normal(size=(count, size, size))
        signs = rng.choice([-1.0, 1.0], size=(count, 1, size))
        matrix = (root * signs) @ root.transpose(0, 2, 1)
        right = rng.normal(size=(count, size))
        found = solve_symmetric(lower_triangle(matrix), right.T, np)
        residual = np.einsum("pij,jp->pi", matrix, found.solution) - right
        scale = np.abs(matrix).max(axis=(1, 2)) * np.abs(found.solution).max(axis=0)
        assert (np.abs(residual).max(axis=1) < 1e-10 * scale).all()
        negative = (np.linalg.eigvalsh(matrix) < 0.0).sum(axis=1)
        np.testing.assert_array_equal((found.pivots < 0.0).sum(axis=0), negative)


def test_large_systems_one_by_one(rng: np.random.Generator) -> None:
    # Definite systems are solved in another way, and no system affects its neighbors.
    size = LARGE + 5
    root = rng.normal(size=(4, size, size)) / np.sqrt(size)
    matrix = root @ root.transpose(0, 2, 1) + np.eye(size)
    matrix[1] -= 2.0 * np.eye(size)
    right = rng.normal(size=(4, size))
    matrix[3, 2, 2] = np.nan
    with np.errstate(invalid="ignore"):
        found = solve_symmetric(lower_triangle(matrix), right.T, np)
    residual = np.einsum("pij,jp->pi", matrix[:3], found.solution[:, :3]) - right[:3]
    assert np.abs(residual).max() < 1e-9
    negative = (np.linalg.eigvalsh(matrix[:3]) < 0.0).sum(axis=1)
    assert negative[1] > 0
    np.testing.assert_array_equal((found.pivots[:, :3] < 0.0).sum(axis=0), negative)
    np.testing.assert_allclose(
        np.log(np.abs(found.pivots[:, :3])).sum(axis=0), np.linalg.slogdet(matrix[:3])[1], rtol=1e-9
    )
    assert not np.isfinite(found.solution[:, 3]).all()


def test_a_singular_system_shows_and_leaves_the_others_alone() -> None:
    matrix = np.stack([np.zeros((2, 2)), 2.0 * np.eye(2)])
    right = np.ones((2, 2))
    with np.errstate(divide="ignore", invalid="ignore"):
        general = solve_batch(np.moveaxis(matrix, 0, -1), right.T, np)
        symmetric = solve_symmetric(lower_triangle(matrix), right.T, np).solution
    for solution in (general, symmetric):
        assert not np.isfinite(solution[:, 0]).all()
        np.testing.assert_array_equal(solution[:, 1], 0.5)
