"""Composite Gauss-Legendre quadrature that estimates its own error."""

from functools import cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import legendre

from bodymeasure._typing import Array
from bodymeasure.geodesic.numerics.array_libraries import constant

# How many quarters of the degrees lie between the middle of the last one and degree 2m, less a
# little, since coefficients fall more slowly further on.
FALLS = 4.5
# Coefficients below this part of the values, times the number of points, are rounding errors.
ROUNDING = 2e-16


class GaussRule(NamedTuple):
    """Gauss-Legendre quadrature on [-1, 1]: arrays that many share, and none changes.

    Parameters
    ----------
    points, weights : ndarray, shape (count,)
    analysis : ndarray, shape (count, count)
        The map from values at the points, on its left, to Legendre coefficients.
    """

    points: Array
    weights: Array
    analysis: Array


@lru_cache(maxsize=64)
def gauss_rule(count: int) -> GaussRule:
    """Return the rule of so many points."""
    points, weights = legendre.leggauss(count)
    analysis = legendre.legvander(points, count - 1) * weights[:, None]
    return GaussRule(points, weights, analysis * (np.arange(count) + 0.5))


class Quadrature:
    """Gauss-Legendre quadrature on pieces of [0, 1].

    Parameters
    ----------
    edges : ndarray, shape (pieces + 1,)
        Increasing, from 0 to 1.
    count : int
        The number of points on each piece.
    """

    def __init__(self, edges: Array, count: int) -> None:
        self.count = count
        self.widths = np.diff(edges)
        self.rule = gauss_rule(count)
        x = self.rule.points
        self.points = (edges[:-1, None] + self.widths[:, None] * (x + 1.0) / 2.0).ravel()
        self.weights = (self.widths[:, None] * self.rule.weights / 2.0).ravel()

    @cached_property
    def coefficients(self) -> Array:
        """The map from values on a piece to its Legendre coefficients beyond the first quarter."""
        return np.ascontiguousarray(self.rule.analysis[:, self.quarters[0] :].T)

    @property
    def quarters(self) -> tuple[int, int, int]:
        """The degrees at which their second, third and last quarters begin."""
        return self.count // 4, self.count // 2, 3 * self.count // 4

    @cached_property
    def antiderivative(self) -> Array:
        """The map from values at the points to the integrals from 0 to them."""
        integrals = legendre.legint(self.rule.analysis.T, lbnd=-1.0)
        own = legendre.legval(self.rule.points, integrals).T
        before = np.tril(np.ones((len(self.widths),) * 2), -1)
        result = np.asarray(np.kron(np.diag(self.widths / 2.0), own), dtype=np.float64)
        result += np.kron(before, np.ones((self.count, self.count))) * self.weights
        return result

    def integrate(self, values: Array) -> Array:
        """Return integrals over [0, 1] of functions given at the points, shape (points, ...)."""
        return np.asarray(np.tensordot(self.weights, values, 1))

    def error_estimate(self, values: Any, xp: Any = np) -> Any:
        """Return the size of the quadrature's error, for at least 4 points a piece.

        An m-point rule is exact up to degree 2m - 1, so that its error is of the size of the
        Legendre coefficients from there on. That size is extrapolated from the coefficients that
        the points determine, by the largest in the second, the third and the last quarter of the
        degrees: up to 2m they are taken to fall in each quarter as they did in the last, or in the
        last two on average, whichever is slower.

        Parameters
        ----------
        values : array, shape (points, functions)
        xp : namespace of the array library

        Returns
        -------
        array, shape (functions,)
        """
        pieces = xp.reshape(values, (len(self.widths), self.count, -1))
        sizes = xp.abs(constant(self.coefficients, values, xp) @ pieces)
        second, third, last = (part - self.quarters[0] for part in self.quarters)
        before = xp.max(sizes[:, second:third, :], axis=1)
        middle = xp.max(sizes[:, third:last, :], axis=1)
        final = xp.max(sizes[:, last:, :], axis=1)
        fall, average = final / middle, xp.sqrt(final / before)
        slower = xp.where(fall > average, fall, average)
        slower = xp.where(slower > 1.0, 1.0, slower)
        noise = ROUNDING * self.count * xp.max(xp.abs(pieces), axis=1)
        excess = xp.where(final <= noise, 0.0, final * slower**FALLS)
        return constant(self.widths, values, xp) @ excess
