"""A polynomial path on a patch, exactly, and its length and curvature in balls.

The path is ``(u(s), v(s))`` with s in [-1, 1] and exact rational coefficients, so that the path in
space, its derivatives, the numerator of its geodesic curvature and the squares of its speed and of
``S_u x S_v`` are exact polynomials in s. They are moved to short cells, where the sum of the sizes
of the coefficients bounds them closely. On formulas evaluated with balls for s and for the control
points, the curvature would be overestimated more than a hundredfold.
"""

from math import comb
from typing import Any, NamedTuple

import numpy as np
from flint import arb, arb_poly, arb_series, ctx, fmpq, fmpq_poly

# The coefficients of powers of s grow with the degree, and cancel where the polynomial is small.
BITS = 200
BITS_A_DEGREE = 2
CELLS = 24
# Where a cell is too long for its bounds, it is halved, down to this half length.
SHORTEST = fmpq(1, 1000)
# On a disc of this many times the radius of a cell, the square of the speed must have no zero ...
DISC = 8
# ... and then this many terms of the series of the speed leave less than 1e-25 of it.
TERMS = 30


class PathForms(NamedTuple):
    """Exact polynomials in s, which belong to a path: fmpq_poly each.

    Parameters
    ----------
    speed_squared : fmpq_poly
    normal_squared : fmpq_poly
        The square of ``S_u x S_v`` along the path.
    bend : fmpq_poly
        ``(x' x x'') . (S_u x S_v)``, the numerator of the geodesic curvature.
    """

    speed_squared: Any
    normal_squared: Any
    bend: Any


class BallPath(NamedTuple):
    """A path's length and its largest geodesic curvature, as balls; the curvature from above."""

    length: Any
    curvature: Any


def path_forms(points: Any, u: Any, v: Any) -> PathForms:
    """Return the polynomials of a path on a patch.

    Parameters
    ----------
    points : ndarray of fmpz or fmpq, shape (m + 1, n + 1, 3)
        Control points.
    u, v : fmpq_poly
    """
    powers = _in_powers(points)
    by_u, by_v = _powers_of(u, powers.shape[0]), _powers_of(v, powers.shape[1])
    s_u = [_composed(powers[1:, :, c], by_u, by_v, along=0) for c in range(3)]
    s_v = [_composed(powers[:, 1:, c], by_u, by_v, along=1) for c in range(3)]
    du, dv = u.derivative(), v.derivative()
    first = [a * du + b * dv for a, b in zip(s_u, s_v, strict=True)]
    second = [each.derivative() for each in first]
    normal = _cross(s_u, s_v)
    bend = _dot(_cross(first, second), normal)
    return PathForms(_dot(first, first), _dot(normal, normal), bend)


def enclose_path(forms: PathForms) -> BallPath | None:
    """Return the length and a bound of the geodesic curvature.

    It is None if even the shortest cells are too long.
    """
    before, ctx.prec = ctx.prec, BITS + BITS_A_DEGREE * max(form.degree() for form in forms)
    try:
        length, curvature = arb(0), arb(0)
        polynomials = [arb_poly(form) for form in forms]
        cells = [(fmpq(2 * cell + 1 - CELLS, CELLS), fmpq(1, CELLS)) for cell in range(CELLS)]
        while cells:
            middle, half = cells.pop()
            here = arb_poly([arb(middle), arb(half)])
            speed, normal, bend = (polynomial(here) for polynomial in polynomials)
            part = _integral_of_root(speed)
            slowest, least = _least(speed), _least(normal)
            if part is not None and slowest > 0 and least > 0:
                length += part * half
                found = _sizes(bend, 1, 0) / (slowest * slowest.sqrt() * least.sqrt())
                curvature = curvature.max(found)
            elif half < SHORTEST:
                return None
            else:
                cells += [(middle - half / 2, half / 2), (middle + half / 2, half / 2)]
        return BallPath(length, curvature)
    finally:
        ctx.prec = before


def is_inside(polynomial: Any) -> bool:
    """Return whether a polynomial in s stays in [0, 1], by exact Bernstein coefficients."""
    for cell in range(CELLS):
        here = fmpq_poly([fmpq(2 * cell - CELLS, CELLS), fmpq(2, CELLS)])
        coefficients = _bernstein(polynomial(here))
        if min(coefficients) < 0 or max(coefficients) > 1:
            return False
    return True


def _bernstein(polynomial: Any) -> list[Any]:
    """The exact Bernstein coefficients on [0, 1]."""
    n = max(polynomial.degree(), 0)
    return [
        sum((fmpq(comb(i, k), comb(n, k)) * polynomial[k] for k in range(i + 1)), fmpq(0))
        for i in range(n + 1)
    ]


def _integral_of_root(square: Any) -> Any:
    """The integral of the root of a polynomial over [-1, 1], with what the series leaves out."""
    around = _sizes(square, DISC, 1)
    if not square[0] > around:
        return None
    before = ctx.cap
    try:
        ctx.cap = TERMS
        series = arb_series([square[k] for k in range(TERMS)], prec=TERMS).sqrt()
    finally:
        ctx.cap = before
    total = sum((2 * series[k] / (k + 1) for k in range(0, TERMS, 2)), arb(0))
    # By Cauchy's estimate, coefficient k is at most the largest root on the disc over DISC^k.
    rest = 2 * (square[0] + around).sqrt() * arb(DISC) ** -TERMS / (1 - arb(1) / DISC)
    return total + arb(0, rest.upper())


def _sizes(polynomial: Any, radius: int, first: int) -> Any:
    """The largest size on a disc, at most, of a polynomial without its first coefficients."""
    sizes = arb(0)
    for k in reversed(range(first, polynomial.degree() + 1)):
        sizes = sizes * radius + abs(polynomial[k])
    return sizes * arb(radius) ** first


def _least(polynomial: Any) -> Any:
    """The least value on [-1, 1], at least."""
    return polynomial[0] - _sizes(polynomial, 1, 1)


def _in_powers(points: Any) -> Any:
    """Control points in powers of u and v, exactly."""
    result = points
    for axis in (0, 1):
        rows = np.moveaxis(result, axis, 0)
        n = len(rows) - 1
        result = np.moveaxis(
            np.stack([comb(n, k) * np.diff(rows, n=k, axis=0)[0] for k in range(n + 1)]), 0, axis
        )
    return result


def _powers_of(polynomial: Any, count: int) -> list[Any]:
    powers = [fmpq_poly([1])]
    for _ in range(count - 1):
        powers.append(powers[-1] * polynomial)
    return powers


def _composed(coefficients: Any, by_u: list[Any], by_v: list[Any], *, along: int) -> Any:
    """A derivative by u (0) or by v (1) of a coordinate, along the path.

    The coefficients are those of the powers from 1 on along that axis.
    """
    total = fmpq_poly([0])
    for i, j in np.ndindex(coefficients.shape):
        total += by_u[i] * by_v[j] * (coefficients[i, j] * ((i, j)[along] + 1))
    return total


def _dot(a: list[Any], b: list[Any]) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: list[Any], b: list[Any]) -> list[Any]:
    return [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]
