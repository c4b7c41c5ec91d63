"""Composite Gauss-Legendre quadrature that judges itself."""

from functools import cached_property
from typing import Any

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from bodymeasure.geodesic.numerics.array_libraries import constant

# Quarters of the degrees from the middle of the last one to degree 2m and a little less, since
# coefficients fall more slowly further on.
FALLS = 4.5
# Coefficients that are this part of the values, times the number of points, are rounding errors.
ROUNDING = 2e-16


class Quadrature:
    """Gauss-Legendre quadrature on pieces of [0, 1].

    Parameters
    ----------
    edges : ndarray, shape (pieces + 1,)
        Increasing, from 0 to 1.
    count : int
        Points on each piece.
    """

    def __init__(self, edges: NDArray[np.float64], count: int) -> None:
        self.count = count
        self.widths = np.diff(edges)
        nodes, weights = legendre.leggauss(count)
        self.points = (edges[:-1, None] + self.widths[:, None] * (nodes + 1.0) / 2.0).ravel()
        self.weights = (self.widths[:, None] * weights / 2.0).ravel()

    @cached_property
    def _coefficients(self) -> NDArray[np.float64]:
        """From values on one piece to its Legendre coefficients, those below `_edges` left out."""
        nodes, weights = legendre.leggauss(self.count)
        transform = legendre.legvander(nodes, self.count - 1) * weights[:, None]
        transform *= np.arange(self.count) + 0.5
        return np.ascontiguousarray(transform[:, self._edges[0] :].T)

    @property
    def _edges(self) -> tuple[int, int, int]:
        """Where the second, third and last quarter of the degrees begin."""
        return self.count // 4, self.count // 2, 3 * self.count // 4

    @cached_property
    def antiderivative(self) -> NDArray[np.float64]:
        """From values at the points to integrals from 0 to them, shape (points, points)."""
        nodes, weights = legendre.leggauss(self.count)
        transform = legendre.legvander(nodes, self.count - 1) * weights[:, None]
        transform *= np.arange(self.count) + 0.5
        own = legendre.legval(nodes, legendre.legint(transform.T, lbnd=-1.0)).T
        before = np.tril(np.ones((len(self.widths),) * 2), -1)
        result = np.asarray(np.kron(np.diag(self.widths / 2.0), own), dtype=np.float64)
        result += np.kron(before, np.ones((self.count, self.count))) * self.weights
        return result

    def integrate(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Integral over [0, 1] of functions given at the points, shape (points, ...)."""
        return np.asarray(np.tensordot(self.weights, values, 1))

    def error_estimate(self, values: Any, xp: Any = np) -> Any:
        """Size of the quadrature's error, for at least 4 points a piece.

        An m-point rule is exact up to degree 2m - 1, so that its error is of the size of the
        Legendre coefficients from there on. That is foretold from those that the points can tell,
        by their largest in the second, the third and the last quarter of the degrees: up to 2m they
        are taken to fall in each quarter as they did in the last, or in the last two on the
        average, whichever is slower.

        Parameters
        ----------
        values : array, shape (points, functions)
        xp : namespace of the array

        Returns
        -------
        array, shape (functions,)
        """
        pieces = xp.reshape(values, (len(self.widths), self.count, -1))
        sizes = xp.abs(constant(self._coefficients, values, xp) @ pieces)
        second, third, last = (part - self._edges[0] for part in self._edges)
        before = xp.max(sizes[:, second:third, :], axis=1)
        middle = xp.max(sizes[:, third:last, :], axis=1)
        final = xp.max(sizes[:, last:, :], axis=1)
        fall, average = final / middle, xp.sqrt(final / before)
        slower = xp.where(fall > average, fall, average)
        slower = xp.where(slower > 1.0, 1.0, slower)
        noise = ROUNDING * self.count * xp.max(xp.abs(pieces), axis=1)
        excess = xp.where(final <= noise, 0.0, final * slower**FALLS)
        return constant(self.widths, values, xp) @ excess
