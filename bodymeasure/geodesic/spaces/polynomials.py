"""Polynomials on [0, 1], given by their values at Chebyshev-Lobatto points."""

from functools import lru_cache

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from bodymeasure.geodesic.spaces.piecewise import PiecewisePolynomials
from bodymeasure.geodesic.spaces.trial_space import TrialSpace

_PI = 4.0 * np.arctan(np.longdouble(1.0))


@lru_cache(maxsize=64)
def polynomial_space(degree: int) -> TrialSpace:
    """Return the space of polynomials up to a degree of at least 1, made in extended precision.

    The nodes are ``(1 - cos(pi j / n)) / 2``. Between them, a polynomial through given values is
    nearly as good as the best one: L. N. Trefethen, *Approximation Theory and Approximation
    Practice*, chapters 2 to 4 and 16.
    """
    j = np.arange(degree + 1)
    # The angles are reduced as whole numbers, so that cosines have only their own rounding errors.
    cosines = np.cos(_PI * (np.outer(j, degree - j) % (2 * degree)) / degree)
    halved = np.where((j == 0) | (j == degree), 0.5, 1.0)
    # The discrete cosine transform: Chebyshev coefficient k of the cardinal function of node j.
    transform = cosines * np.outer(halved, halved) * (2.0 / np.longdouble(degree))
    nodes = (0.5 + 0.5 * cosines[1]).astype(np.float64)
    nodes[0], nodes[-1] = 0.0, 1.0
    vandermonde = chebyshev.chebvander(2.0 * nodes - 1.0, degree)
    return TrialSpace(
        nodes=nodes,
        condition=float(np.linalg.cond(vandermonde, 1)),
        functions=PiecewisePolynomials(np.array([0.0, 1.0]), _with_derivatives(transform)),
        description=f"polynomials of degree {degree}",
    )


def _with_derivatives(coefficients: NDArray[np.longdouble]) -> NDArray[np.longdouble]:
    """The Chebyshev coefficients of functions and of their first two derivatives."""
    orders = [coefficients]
    for _ in range(2):
        slope = np.zeros_like(coefficients)
        lower = 2.0 * chebyshev.chebder(orders[-1], axis=0)
        slope[: len(lower)] = lower
        orders.append(slope)
    return np.stack(orders)[..., None]
