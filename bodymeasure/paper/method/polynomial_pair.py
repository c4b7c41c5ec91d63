"""Pairs of polynomials in two variables, in batches."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Complex, Ints

# Coefficients below this, relative to the largest, are the rounding of those that cancel. They
# would have roots of their own, far away: those of a plane, whose equations are linear.
ROUNDING = 1e-14


class PairValues(NamedTuple):
    """Both polynomials of each pair at points (pairs, k), with first derivatives.

    Each is a pair of arrays of shape (pairs, k). Rounding errors are relative to `size`, which is
    the sum of the sizes of the terms.
    """

    value: tuple[Complex, Complex]
    by_x: tuple[Complex, Complex]
    by_y: tuple[Complex, Complex]
    size: tuple[Array, Array]


@dataclass(frozen=True, eq=False)
class PolynomialPair:
    """Two polynomials in (x, y) for each member of a batch.

    Parameters
    ----------
    first, second : ndarray, shape (pairs, degree in x + 1, degree in y + 1)
        ``[p, i, j]`` is the coefficient of ``x^i y^j``.
    """

    first: Array
    second: Array

    def take(self, rows: Ints) -> "PolynomialPair":
        """Return some of the batch."""
        return PolynomialPair(self.first[rows], self.second[rows])

    @property
    def without_rounding(self) -> "PolynomialPair":
        """The same pair without coefficients that are only the rounding of larger ones."""
        least = (ROUNDING * np.abs(c).max(axis=(1, 2), keepdims=True) for c in self.both)
        return PolynomialPair(
            *(np.where(np.abs(c) > low, c, 0.0) for c, low in zip(self.both, least, strict=True))
        )

    @property
    def both(self) -> tuple[Array, Array]:
        """Both polynomials, to loop over."""
        return self.first, self.second

    @property
    def turned(self) -> "PolynomialPair":
        """The same pair with x and y exchanged."""
        return PolynomialPair(*(c.swapaxes(1, 2) for c in self.both))

    def in_units(self, unit: float) -> "PolynomialPair":
        """Return the pair in x / unit and y / unit, whose largest coefficients are 1."""
        scaled = []
        for c in self.both:
            powers = [unit ** np.arange(n, dtype=np.float64) for n in c.shape[1:]]
            scaled.append(of_size_one(c * np.outer(*powers)))
        return PolynomialPair(*scaled)

    def at(self, points: Complex) -> PairValues:
        """Return the values at points (pairs, k, 2)."""
        exponents = np.arange(max(max(c.shape[1:]) for c in self.both))
        x, y = (points[..., i, None] ** exponents for i in range(2))
        slopes = [
            np.concatenate([np.zeros_like(p[..., :1]), p[..., :-1]], axis=-1) * exponents
            for p in (x, y)
        ]

        def sums(left: Complex, right: Complex) -> tuple[Complex, Complex]:
            first, second = (
                ((left[..., : c.shape[1]] @ c) * right[..., : c.shape[2]]).sum(axis=-1)
                for c in self.both
            )
            return first, second

        sizes = (
            ((np.abs(x[..., : c.shape[1]]) @ np.abs(c)) * np.abs(y[..., : c.shape[2]])).sum(axis=-1)
            for c in self.both
        )
        first, second = sizes
        return PairValues(sums(x, y), sums(slopes[0], y), sums(x, slopes[1]), (first, second))


def of_size_one(coefficients: Array) -> Array:
    """Return polynomials scaled to a largest coefficient of 1 in size; zero stays zero."""
    size = np.abs(coefficients).max(axis=(1, 2), keepdims=True)
    return np.asarray(coefficients / np.where(size > 0.0, size, 1.0))
