"""Piecewise polynomials on [0, 1] in Chebyshev form."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from bodymeasure._typing import Array, Ints


@dataclass(frozen=True, eq=False)
class PiecewisePolynomials:
    """Functions that are polynomials on each piece of [0, 1], with their first two derivatives.

    The derivatives have coefficients of their own, and all coefficients are in extended precision
    where the machine has it: the derivatives of cardinal functions are large and cancel, and a
    length can be no more exact than they are.

    Parameters
    ----------
    edges : ndarray, shape (pieces + 1,)
        Increasing, from 0 to 1.
    coefficients : ndarray of longdouble, shape (3, degree + 1, functions, pieces)
        The Chebyshev coefficients, on each piece, of the functions and their two derivatives.
    """

    edges: Array
    coefficients: NDArray[np.longdouble]

    def __call__(self, t: Array) -> Array:
        """Return values and two derivatives at t of shape (k,), in shape (3, k, functions)."""
        functions = self.coefficients.shape[2]
        result = np.empty((3, len(t), functions))
        for number, here, x in self._by_piece(t.astype(np.longdouble)):
            vandermonde = chebyshev.chebvander(x, self.coefficients.shape[1] - 1)
            # Sums over neighbors in memory are three times as fast in extended precision.
            for order, sums in enumerate(self.coefficients[..., number]):
                result[order, here] = np.inner(vandermonde, np.ascontiguousarray(sums.T))
        return result

    def values(self, t: Array) -> Array:
        """Return values alone, in double precision throughout, in shape (k, functions)."""
        result = np.empty((len(t), self.coefficients.shape[2]))
        for number, here, x in self._by_piece(t):
            vandermonde = chebyshev.chebvander(x, self.coefficients.shape[1] - 1)
            result[here] = vandermonde @ self.coefficients[0, :, :, number].astype(np.float64)
        return result

    def _by_piece(self, t: NDArray[Any]) -> Iterator[tuple[int, Ints, NDArray[Any]]]:
        """The number of each piece, which t lie on it, and these scaled to [-1, 1]."""
        piece = np.clip(np.searchsorted(self.edges, t, side="right") - 1, 0, len(self.edges) - 2)
        for number in np.unique(piece):
            here = np.flatnonzero(piece == number)
            left, right = self.edges[number : number + 2]
            yield int(number), here, ((t[here] - left) - (right - t[here])) / (right - left)

    def combined(self, values: Array, t: Array) -> Array:
        """Return sums of the functions, those of each problem at its own parameters.

        Parameters
        ----------
        values : ndarray, shape (problems, 2, functions)
            The factors of the functions.
        t : ndarray, shape (problems, k)

        Returns
        -------
        ndarray, shape (problems, k, 2)
        """
        piece = np.clip(np.searchsorted(self.edges, t, side="right") - 1, 0, len(self.edges) - 2)
        result = np.empty((*t.shape, 2))
        for number in range(len(self.edges) - 1):
            left, right = self.edges[number : number + 2]
            sums = self.coefficients[0, :, :, number].astype(np.float64) @ values.transpose(
                2, 0, 1
            ).reshape(values.shape[2], -1)
            sums = sums.reshape(-1, *values.shape[:2])
            x = ((t - left) - (right - t)) / (right - left)
            for axis in (0, 1):
                there = chebyshev.chebval(x, sums[:, :, axis, None], tensor=False)
                result[..., axis] = np.where(piece == number, there, result[..., axis])
        return result


def sample_points(edges: Array, degree: int) -> Array:
    """Return points that determine polynomials on each piece, shape (pieces, degree + 1)."""
    x = (chebyshev.chebpts1(degree + 1) + 1.0) / 2.0
    return np.asarray(edges[:-1, None] + np.diff(edges)[:, None] * x)
