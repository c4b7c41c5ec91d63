"""Rigorous bounds of the length of one shortest path; see `proofs.bounds` for the theorem."""

from typing import Any

import numpy as np
from flint import arb, ctx, fmpq, fmpq_poly, fmpz

from bodymeasure._typing import Array
from bodymeasure.geodesic.rigorous.curvature import exact_bounds
from bodymeasure.geodesic.rigorous.path import BallPath, enclose_path, is_inside, path_forms

# The precision of the formulas at the end, in bits.
BITS = 200
# As in `proofs.shortest` and `proofs.bounds`.
NEAR = 0.8
FLATTEST = 1e-6


def enclose_shortest(net: Array, places: Array) -> tuple[float, float]:
    """Return bounds of the shortest path on a patch between the ends of a path.

    Parameters
    ----------
    net : ndarray, shape (m + 1, n + 1, 3)
        Control points, taken as exact.
    places : ndarray, shape (2, k + 1)
        u and v of a path at Chebyshev-Lobatto points, ends included; the path of degree k through
        them is the one whose length and curvature are enclosed.

    Returns
    -------
    tuple of float
        The upper bound is infinite if the path is not shown to run on the patch.
    """
    points, scale = integers(net)
    u, v = (exact_polynomial(values) for values in places)
    before, ctx.prec = ctx.prec, BITS
    try:
        unit = arb(2) ** -scale
        distance = _distance(points, places) * unit
        path = None
        if is_inside(u) and is_inside(v):
            path = enclose_path(path_forms(points, u, v))
        if path is None:
            return _lower(distance), float("inf")
        path = BallPath(path.length * unit, path.curvature / unit)
        longest = arb(path.length.upper())
        largest = (arb.pi() / longest) ** 2
        curvature = exact_bounds(points, scale, largest * NEAR, largest)
        least = distance
        if curvature is not None and curvature.positive < 2 * arb.pi():
            flattest = (arb(FLATTEST) / longest) ** 2
            k = arb(arb(curvature.curvature.upper()).max(flattest).upper())
            least = least.max(_distance_at_least(path, k))
        return _lower(least), _upper(longest)
    finally:
        ctx.prec = before


def integers(net: Array) -> tuple[Any, int]:
    """Return control points times a power of 2 that makes them integers, and its exponent."""
    _, exponents = np.frexp(net)
    scale = int(max(0, 53 - exponents[net != 0.0].min()))
    exact = [fmpz(int(numerator)) for numerator in _times_power_of_2(net.ravel(), scale)]
    return np.array(exact, dtype=object).reshape(net.shape), scale


def _times_power_of_2(values: Array, scale: int) -> list[int]:
    fractions = [float(value).as_integer_ratio() for value in values]
    return [numerator * 2**scale // denominator for numerator, denominator in fractions]


def exact_polynomial(values: Array) -> Any:
    """Return a polynomial in s that is near the one through values, and exact at both ends.

    It is ``line + (1 - s^2) q``, whose coefficients are the exact values of doubles.
    """
    degree = len(values) - 1
    s = -np.cos(np.pi * np.arange(degree + 1) / degree)
    line = 0.5 * (values[0] * (1.0 - s) + values[-1] * (1.0 + s))
    bubble = ((values - line) / np.maximum(1.0 - s * s, 1e-300))[1:-1]
    fitted = np.polynomial.chebyshev.chebfit(s[1:-1], bubble, degree - 2)
    powers = np.polynomial.chebyshev.cheb2poly(fitted)
    first, last = (fmpq(*float(value).as_integer_ratio()) for value in values[[0, -1]])
    ends = fmpq_poly([(first + last) / 2, (last - first) / 2])
    inner = fmpq_poly([fmpq(*float(value).as_integer_ratio()) for value in powers])
    return ends + fmpq_poly([1, 0, -1]) * inner


def _distance_at_least(path: BallPath, k: Any) -> Any:
    """The distance of the ends in a CAT(k) space, at least, by the theorem; 0 if it is silent."""
    # A longer path of larger curvature is no problem: the bound falls with the curvature, and the
    # length enters as the ball that it is.
    c = arb(path.curvature.upper())
    a, b = (path.length * root / 2 for root in (k.sqrt(), (k + c * c).sqrt()))
    if not b < arb.pi() / 2:
        return arb(0)
    sine = a * b.sin() / b
    return 2 * sine.asin() / k.sqrt()


def _distance(points: Any, places: Array) -> Any:
    """The distance in space of a path's ends, in units of the integers."""
    first, last = (_point(points, *places[:, end]) for end in (0, -1))
    squares = sum(((a - b) ** 2 for a, b in zip(first, last, strict=True)), fmpq(0))
    return arb(squares).sqrt()


def _point(points: Any, u: float, v: float) -> list[Any]:
    """A point of the patch, exactly, by de Casteljau's scheme."""
    rows = points
    for value in (u, v):
        t = fmpq(*float(value).as_integer_ratio())
        while len(rows) > 1:
            rows = (1 - t) * rows[:-1] + t * rows[1:]
        rows = rows[0]
    return list(rows)


def _lower(ball: Any) -> float:
    return float(np.nextafter(float(ball.lower()), -np.inf))


def _upper(ball: Any) -> float:
    return float(np.nextafter(float(ball.upper()), np.inf))
