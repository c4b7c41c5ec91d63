r"""Orders of convergence of the paper's functions, on a linear model of the geodesic equation.

Near a geodesic, the distance :math:`\psi` of its neighbors obeys the Jacobi equation. Its model
:math:`-\psi'' - 2 \psi = f` on [0, 1], with zero ends, has a known solution here, and is solved in
the span of radial functions, by Galerkin's method, which is the weak form, and by collocation at
the inner centers. The centers are even, in [0, 1]. Sixty digits keep rounding out of the orders.
"""

from decimal import Decimal
from functools import lru_cache
from typing import Any, Literal, NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic import Kernel
from bodymeasure.geodesic.spaces.decimals import Decimals, decimals, inverse, many_digits
from bodymeasure.geodesic.spaces.rbf import basis

Form = Literal["weak", "collocation"]

# The K of the model; below pi^2, so that the form is definite.
CURVATURE = 2.0
RADIUS = 2.0
# Gauss points between neighboring centers; polynomials of degree 21 are resolved to rounding.
POINTS = 12


class ModelError(NamedTuple):
    """The norms of an error: in L2, and of its derivative in L2."""

    l2: float
    h1: float


def solution(t: Array) -> tuple[Array, Array, Array]:
    """Return the model's solution, its derivative, and the right-hand side f."""
    wave, slope, growth = np.sin(np.pi * t), np.pi * np.cos(np.pi * t), np.exp(t)
    second = growth * ((1.0 - np.pi**2) * wave + 2.0 * slope)
    return growth * wave, growth * (wave + slope), -second - CURVATURE * growth * wave


@lru_cache(maxsize=256)
def model_error(kernel: Kernel, functions: int, form: Form) -> ModelError:
    """Return the error of the model's solution in the span of so many functions.

    Parameters
    ----------
    kernel : Kernel
    functions : int
        At least 3.
    form : {"weak", "collocation"}
    """
    centers = np.linspace(0.0, 1.0, functions)
    nodes, weights = np.polynomial.legendre.leggauss(POINTS)
    half = 0.5 / (functions - 1)
    times = (centers[:-1, None] + half * (1.0 + nodes)).ravel()
    weight = np.tile(half * weights, functions - 1)
    with many_digits():
        place, slope, _ = _basis(kernel, centers, times)
        ends = _basis(kernel, centers, np.array([0.0, 1.0]))[0]
        make = _weak if form == "weak" else _collocated
        coefficients = make(kernel, centers, (times, weight), (place, slope), ends)
        found = np.asarray(np.stack([place @ coefficients, slope @ coefficients]), np.float64)
    value, derivative, _ = solution(times)
    squares = (found - np.stack([value, derivative])) ** 2 @ weight
    return ModelError(*np.sqrt(squares).tolist())


def fitted_order(counts: Any, errors: Any) -> float:
    """Return the order p of errors that fall as ``count^-p``, by least squares of logarithms."""
    return -float(np.polyfit(np.log(np.asarray(counts, float)), np.log(errors), 1)[0])


def _basis(kernel: Kernel, centers: Array, t: Array) -> list[Decimals]:
    return basis(kernel, tuple(centers.tolist()), t, RADIUS)


def _weak(
    _kernel: Kernel,
    _centers: Array,
    rule: tuple[Array, Array],
    functions: tuple[Decimals, Decimals],
    ends: Decimals,
) -> Decimals:
    """The coefficients of Galerkin's solution, with the ends held by multipliers."""
    (times, weight), (place, slope) = rule, functions
    weights = decimals(weight)[:, None]
    form = slope.T @ (weights * slope) - Decimal(CURVATURE) * (place.T @ (weights * place))
    load = place.T @ (decimals(weight) * decimals(solution(times)[2]))
    corner = decimals(np.zeros((2, 2)))
    system = np.block([[form, ends.T], [ends, corner]])
    return _solved(system, np.concatenate([load, corner[0]]))[: len(load)]


def _collocated(
    kernel: Kernel,
    centers: Array,
    _rule: tuple[Array, Array],
    _functions: tuple[Decimals, Decimals],
    ends: Decimals,
) -> Decimals:
    """The coefficients of the solution that meets the equation at even points."""
    # Without the constant there are as many unknowns as centers.
    points = centers[1:-1]
    place, _, second = _basis(kernel, centers, points)
    system = np.concatenate([-second - Decimal(CURVATURE) * place, ends])[:, 1:]
    right = np.concatenate([decimals(solution(points)[2]), decimals(np.zeros(2))])
    return np.concatenate([decimals(np.zeros(1)), _solved(system, right)])


def _solved(system: Decimals, right: Decimals) -> Decimals:
    inverted, _ = inverse(system)
    if inverted is None:
        return np.array([Decimal("nan")] * len(right), dtype=object)
    result: Decimals = inverted @ right
    return result
