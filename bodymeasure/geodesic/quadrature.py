"""Composite Gauss-Legendre quadrature that judges itself."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray


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
    def _last_coefficients(self) -> NDArray[np.float64]:
        """From values on one piece to its mean and its last two Legendre coefficients."""
        nodes, weights = legendre.leggauss(self.count)
        transform = legendre.legvander(nodes, self.count - 1) * weights[:, None]
        transform *= np.arange(self.count) + 0.5
        return np.asarray(transform[:, [0, -2, -1]])

    def integrate(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Integral over [0, 1] of functions given at the points, shape (..., points)."""
        return np.asarray(values @ self.weights)

    def error_estimate(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Size of the quadrature's error for positive functions, same shape as the integral.

        An m-point rule is exact up to degree 2m - 1. Where the last Legendre coefficients that the
        points can tell are a part eps of the mean, those of twice the degree, which the rule gets
        wrong, are about eps squared.
        """
        pieces = values.reshape(*values.shape[:-1], len(self.widths), self.count)
        mean, *last = np.moveaxis(np.abs(pieces @ self._last_coefficients), -1, 0)
        with np.errstate(divide="ignore", invalid="ignore"):
            excess = np.maximum(*last) ** 2 / mean
        return np.asarray(excess @ self.widths)
