"""Composite Gauss-Legendre quadrature that judges itself."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from bodymeasure.geodesic.arrays import constant


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
        """From values on one piece to its mean and its last two Legendre coefficients."""
        nodes, weights = legendre.leggauss(self.count)
        transform = legendre.legvander(nodes, self.count - 1) * weights[:, None]
        transform *= np.arange(self.count) + 0.5
        return np.ascontiguousarray(transform[:, [0, -2, -1]].T)

    def integrate(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Integral over [0, 1] of functions given at the points, shape (points, ...)."""
        return np.asarray(np.tensordot(self.weights, values, 1))

    def error_estimate(self, values: Any, xp: Any = np) -> Any:
        """Size of the quadrature's error for positive functions.

        An m-point rule is exact up to degree 2m - 1. Where the last Legendre coefficients that the
        points can tell are a part eps of the mean, those of twice the degree, which the rule gets
        wrong, are about eps squared.

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
        last = xp.max(sizes[:, 1:, :], axis=1)
        widths = constant(self.widths, values, xp)
        return widths @ (last * last / sizes[:, 0, :])
