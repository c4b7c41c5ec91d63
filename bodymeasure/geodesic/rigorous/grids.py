"""Exact polynomials of two variables in Bernstein form, times their binomials, as integers.

A polynomial is one of a single variable x with u = x and v = x^stride (Kronecker's substitution),
so that FLINT multiplies it. Coefficients are integers; a common factor is kept by the caller.
"""

from math import comb
from typing import Any, NamedTuple

import numpy as np
from flint import fmpz, fmpz_poly

# More than the degree by u of any product that is made of patches up to degree 10, which is 76.
STRIDE = 80


class Grid(NamedTuple):
    """Coefficients times binomials: of u^i v^j at the power ``i + STRIDE j``.

    Parameters
    ----------
    poly : fmpz_poly
    degrees : tuple of int
        By u and by v.
    """

    poly: Any
    degrees: tuple[int, int]

    @classmethod
    def of(cls, values: Any) -> "Grid":
        """Return the grid of integer Bernstein coefficients, an object array (m + 1, n + 1)."""
        m, n = (size - 1 for size in values.shape)
        coefficients = [fmpz(0)] * (STRIDE * n + m + 1)
        for i, j in np.ndindex(values.shape):
            coefficients[i + STRIDE * j] = values[i, j] * comb(m, i) * comb(n, j)
        return cls(fmpz_poly(coefficients), (m, n))

    def __mul__(self, other: Any) -> "Grid":
        degrees = (self.degrees[0] + other.degrees[0], self.degrees[1] + other.degrees[1])
        return Grid(self.poly * other.poly, degrees)

    def __add__(self, other: Any) -> "Grid":
        a, b = self._as_high_as(other), other._as_high_as(self)
        return Grid(a.poly + b.poly, a.degrees)

    def __sub__(self, other: Any) -> "Grid":
        a, b = self._as_high_as(other), other._as_high_as(self)
        return Grid(a.poly - b.poly, a.degrees)

    def _as_high_as(self, other: "Grid") -> "Grid":
        return self.elevated(*(max(pair) for pair in zip(self.degrees, other.degrees, strict=True)))

    def elevated(self, degree_u: int, degree_v: int) -> "Grid":
        """Return the same polynomial with higher degrees."""
        ones = Grid(
            fmpz_poly([1, 1]) ** (degree_u - self.degrees[0])
            * fmpz_poly([1] + [0] * (STRIDE - 1) + [1]) ** (degree_v - self.degrees[1]),
            (0, 0),
        )
        return Grid(self.poly * ones.poly, (degree_u, degree_v))

    @property
    def values(self) -> list[Any]:
        """The coefficients times binomials, u first."""
        m, n = self.degrees
        return [self.poly[i + STRIDE * j] for j in range(n + 1) for i in range(m + 1)]


def dot(a: list[Grid], b: list[Grid]) -> Grid:
    """Return the scalar product of vectors of polynomials."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: list[Grid], b: list[Grid]) -> list[Grid]:
    """Return the vector product of vectors of polynomials."""
    return [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]
