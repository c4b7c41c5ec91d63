"""Symmetric block tridiagonal systems of 2 x 2 blocks, many at once.

Odd-even reduction: every other block row is eliminated, then every other one of those that are
left, and so on (G. Golub and C. Van Loan, *Matrix Computations*, 4th ed., section 4.5.4). A system
of k rows takes log2(k) sweeps, each over all rows and all systems at once. Each sweep is a
congruence, so the pivots have the signs of the eigenvalues (Sylvester's law of inertia).
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints


class _Sweep(NamedTuple):
    """The rows 0, 2, 4, ... that one sweep eliminated.

    It holds their inverse pivots, and these times the couplings to the kept rows before and after.
    """

    inverse: Array
    before: Array
    after: Array


@dataclass(frozen=True)
class Factors:
    """A factorized batch of matrices.

    Parameters
    ----------
    sweeps : list of _Sweep
    negative : ndarray of int, shape (systems,)
        The number of eigenvalues below zero; at least 1 where a matrix is singular or not finite.
    """

    sweeps: list[_Sweep]
    negative: Ints


# A pivot of zero leaves numbers that are not finite, and counts as negative.
@np.errstate(over="ignore", divide="ignore", invalid="ignore")
def factorize(diagonal: Array, lower: Array) -> Factors:
    """Eliminate all rows of a batch of matrices.

    Parameters
    ----------
    diagonal : ndarray, shape (2, 2, k, systems)
        The blocks on the diagonal, symmetric.
    lower : ndarray, shape (2, 2, k - 1, systems)
        The blocks below it: block i is in block row i + 1.
    """
    sweeps: list[_Sweep] = []
    negative = np.zeros(diagonal.shape[-1], np.int64)
    while diagonal.shape[2]:
        inverse, signs = _inverses(diagonal[:, :, ::2])
        negative += signs.sum(axis=0)
        # All eliminated rows but the first have a row before them; some have one after them.
        to_before, to_after = lower[:, :, 1::2], _transposed(lower[:, :, ::2])
        before = _product(inverse[:, :, 1:], to_before)
        after = _product(inverse[:, :, : to_after.shape[2]], to_after)
        sweeps.append(_Sweep(inverse, before, after))
        diagonal = diagonal[:, :, 1::2] - _product(_transposed(to_after), after)
        diagonal[:, :, : before.shape[2]] -= _product(_transposed(to_before), before)
        shared = max(diagonal.shape[2] - 1, 0)
        lower = -_product(_transposed(to_after)[:, :, 1:], before[:, :, :shared])
    return Factors(sweeps, negative)


@np.errstate(over="ignore", invalid="ignore")
def solve(factors: Factors, right: Array) -> Array:
    """Return the solutions for right-hand sides of shape (2, k, systems)."""
    rights = [right]
    for _, before, after in factors.sweeps:
        eliminated, kept = rights[-1][:, ::2], rights[-1][:, 1::2].copy()
        kept -= apply(_transposed(after), eliminated[:, : after.shape[2]])
        kept[:, : before.shape[2]] -= apply(_transposed(before), eliminated[:, 1:])
        rights.append(kept)
    solution = rights.pop()
    for inverse, before, after in reversed(factors.sweeps):
        right = rights.pop()
        eliminated = apply(inverse, right[:, ::2])
        eliminated[:, : after.shape[2]] -= apply(after, solution)
        eliminated[:, 1:] -= apply(before, solution[:, : before.shape[2]])
        whole = np.empty_like(right)
        whole[:, ::2], whole[:, 1::2] = eliminated, solution
        solution = whole
    return solution


def _inverses(blocks: Array) -> tuple[Array, Ints]:
    """The inverses of symmetric blocks, and how many of their eigenvalues are not positive."""
    (a, b), (_, c) = blocks
    determinant = a * c - b * b
    inverse: Array = np.stack([c, -b, -b, a]).reshape(blocks.shape) / determinant
    return inverse, np.where(determinant > 0.0, np.where(a > 0.0, 0, 2), 1)


def _transposed(blocks: Array) -> Array:
    return blocks.swapaxes(0, 1)


def _product(a: Array, b: Array) -> Array:
    result: Array = a[:, :1] * b[0]
    result += a[:, 1:] * b[1]
    return result


def apply(blocks: Array, vectors: Array) -> Array:
    """Return products of blocks, (2, 2, k, systems), with vectors of shape (2, k, systems)."""
    result: Array = blocks[:, 0] * vectors[0]
    result += blocks[:, 1] * vectors[1]
    return result
