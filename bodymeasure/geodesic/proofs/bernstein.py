"""Products of Bernstein polynomials of two variables, for many patches at once.

Arrays have the shape (m + 1, n + 1, patches). They hold either coefficients in the Bernstein basis
or, to be multiplied, the same times the two binomials: then a product is a convolution, which adds
positive multiples only and so keeps rounding errors relative to the factors' sizes.
"""

from functools import lru_cache
from math import comb

import numpy as np

from bodymeasure._typing import Array


@lru_cache(maxsize=64)
def binomials(degree_u: int, degree_v: int) -> Array:
    """Return the products of binomials, shape (degree_u + 1, degree_v + 1, 1)."""
    rows = ([float(comb(n, i)) for i in range(n + 1)] for n in (degree_u, degree_v))
    return np.asarray(np.multiply.outer(*map(np.array, rows)))[..., None]


def scaled(coefficients: Array) -> Array:
    """Return coefficients times their binomials."""
    return coefficients * _binomials_of(coefficients)


def unscaled(products: Array) -> Array:
    """Return coefficients in the Bernstein basis from those times their binomials."""
    return products / _binomials_of(products)


def _binomials_of(values: Array) -> Array:
    return binomials(values.shape[0] - 1, values.shape[1] - 1)


def multiplied(first: Array, second: Array) -> Array:
    """Return the product of polynomials, all of them times their binomials."""
    if first.shape[0] * first.shape[1] > second.shape[0] * second.shape[1]:
        first, second = second, first
    m, n = first.shape[:2]
    rows, columns = second.shape[:2]
    result = np.zeros((m + rows - 1, n + columns - 1, max(first.shape[2], second.shape[2])))
    for i in range(m):
        for j in range(n):
            result[i : i + rows, j : j + columns] += first[i, j] * second
    return result


def elevated(products: Array, degree_u: int, degree_v: int) -> Array:
    """Return polynomials, times their binomials, written with higher degrees."""
    more_u, more_v = degree_u + 1 - products.shape[0], degree_v + 1 - products.shape[1]
    return multiplied(multiplied(binomials(more_u, 0), products), binomials(0, more_v))
