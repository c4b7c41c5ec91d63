"""Bicubic patches with a known length of a geodesic; tests of methods run over all of them.

Each shortest path stays inside its patch. `tests/test_samples.py` checks every length by shooting
along the geodesic equation.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from scipy.integrate import quad

from bodymeasure._typing import Array

Polynomial = Mapping[tuple[int, int], int | Fraction]
"""Coefficients by the powers of u and v."""


@dataclass(frozen=True)
class Surface:
    """A patch, two points (u, v) on it, and the length of the shortest path between them."""

    name: str
    control_points: Array
    start: tuple[float, float]
    end: tuple[float, float]
    length: float


def bicubic(*coordinates: Polynomial) -> Array:
    """Control points (4, 4, 3) of a polynomial surface, computed in fractions and rounded once."""
    net = np.empty((4, 4, 3))
    for axis, polynomial in enumerate(coordinates):
        for i in range(4):
            for j in range(4):
                net[i, j, axis] = sum(
                    coefficient
                    * Fraction(math.comb(i, k) * math.comb(j, m), math.comb(3, k) * math.comb(3, m))
                    for (k, m), coefficient in polynomial.items()
                )
    net.flags.writeable = False
    return net


_U = {(1, 0): 1}
_V = {(0, 1): 1}

ENNEPER = bicubic(
    {(1, 0): 1, (3, 0): Fraction(-1, 3), (1, 2): 1},
    {(0, 1): 1, (0, 3): Fraction(-1, 3), (2, 1): 1},
    {(2, 0): 1, (0, 2): -1},
)
PARABOLOID = bicubic(_U, _V, {(2, 0): 1, (0, 2): 1})
HYPERBOLIC_PARABOLOID = bicubic(_U, _V, {(1, 1): 1})
PH_CYLINDER = bicubic({(1, 0): 3, (3, 0): -1}, {(2, 0): 3}, {(0, 1): 3})
# c + (v + 1/2) c' with c = (3u, 3u^2, 2u^3)
TANGENT_DEVELOPABLE = bicubic(
    {(0, 0): Fraction(3, 2), (1, 0): 3, (0, 1): 3},
    {(1, 0): 3, (2, 0): 3, (1, 1): 6},
    {(2, 0): 3, (3, 0): 2, (2, 1): 6},
)
# z = (x + 2y) / 2, on unevenly spaced parameters
PLANE = bicubic(
    {(1, 0): 2, (2, 1): 1},
    {(0, 1): 2, (1, 2): Fraction(1, 2), (0, 3): Fraction(1, 2)},
    {
        (1, 0): 1,
        (2, 1): Fraction(1, 2),
        (0, 1): 2,
        (1, 2): Fraction(1, 2),
        (0, 3): Fraction(1, 2),
    },
)


def plane_length(start: tuple[float, float], end: tuple[float, float]) -> float:
    """The chord of `PLANE`."""

    def position(u: float, v: float) -> tuple[float, float]:
        return 2 * u + u**2 * v, 2 * v + (u * v**2 + v**3) / 2

    (x0, y0), (x1, y1) = position(*start), position(*end)
    return math.hypot(x1 - x0, y1 - y0, (x1 - x0 + 2 * (y1 - y0)) / 2)


def ph_cylinder_length(start: tuple[float, float], end: tuple[float, float]) -> float:
    """The hypotenuse of the unrolled cylinder, whose profile has the arc length 3u + u^3."""
    return math.hypot(
        3 * (end[0] - start[0]) + end[0] ** 3 - start[0] ** 3, 3 * (end[1] - start[1])
    )


def tangent_developable_length(start: tuple[float, float], end: tuple[float, float]) -> float:
    """The chord after unrolling, which keeps the edge of regression's arc length and curvature.

    |c'| = 3 (1 + 2u^2) and the curvature is (2/3) / (1 + 2u^2)^2, so that the unrolled tangent has
    turned by sqrt(2) atan(sqrt(2) u).
    """

    def angle(u: float) -> float:
        return math.sqrt(2) * math.atan(math.sqrt(2) * u)

    def unrolled(u: float, v: float) -> complex:
        speed = 3 * (1 + 2 * u**2)
        x = quad(lambda w: 3 * (1 + 2 * w**2) * math.cos(angle(w)), 0, u, epsabs=1e-14)[0]
        y = quad(lambda w: 3 * (1 + 2 * w**2) * math.sin(angle(w)), 0, u, epsabs=1e-14)[0]
        along = (v + 0.5) * speed
        return complex(x + along * math.cos(angle(u)), y + along * math.sin(angle(u)))

    return abs(unrolled(*end) - unrolled(*start))


_FULL = ((0.0, 0.0), (1.0, 1.0))
_PH_OBLIQUE = ((0.2, 0.9), (0.9, 0.3))
_DEVELOPABLE = ((0.0, 1.0), (1.0, 0.3))
_PLANE_OBLIQUE = ((0.1, 0.8), (1.0, 0.2))

SURFACES = [
    Surface("enneper", ENNEPER, *_FULL, 5 * math.sqrt(2) / 3),
    # u = v = t: the integral of sqrt(2 + 16 t^2)
    Surface(
        "paraboloid",
        PARABOLOID,
        *_FULL,
        3 / math.sqrt(2) + math.asinh(2 * math.sqrt(2)) / 4,
    ),
    # u = v = t: the integral of sqrt(2 + 4 t^2)
    Surface(
        "hyperbolic_paraboloid",
        HYPERBOLIC_PARABOLOID,
        *_FULL,
        math.sqrt(6) / 2 + math.asinh(math.sqrt(2)) / 2,
    ),
    Surface("ph_cylinder", PH_CYLINDER, *_FULL, ph_cylinder_length(*_FULL)),
    Surface("ph_cylinder, oblique", PH_CYLINDER, *_PH_OBLIQUE, ph_cylinder_length(*_PH_OBLIQUE)),
    Surface(
        "tangent_developable",
        TANGENT_DEVELOPABLE,
        *_DEVELOPABLE,
        tangent_developable_length(*_DEVELOPABLE),
    ),
    Surface("plane", PLANE, *_FULL, plane_length(*_FULL)),
    Surface("plane, oblique", PLANE, *_PLANE_OBLIQUE, plane_length(*_PLANE_OBLIQUE)),
]
