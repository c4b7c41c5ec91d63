"""Roots of the paper's two-function system by Newton's method from thousands of starts.

Nothing here is shared with `bodymeasure.paper.method.roots`: the equations are taken from the
surface's derivatives and from the kernel, not from polynomials.
"""

from fractions import Fraction
from typing import Any

import numpy as np
from numpy.polynomial import Polynomial

from bodymeasure._typing import Array
from bodymeasure.geodesic import WU_C2
from bodymeasure.geodesic.lengths.equations import linearization
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces

STEPS = 30
LAST_STEP = 1e-10
SAME = 1e-6
# For Newton's method in fractions: the most steps, the distance over which derivatives are taken,
# the number of parts of 1 to which points are rounded, and the step that is small enough.
REFINEMENTS = 20
TINY = Fraction(1, 2**100)
BITS = 2**200
LAST_EXACT_STEP = 1e-20
# The paper's section 7.
CENTERS, RADIUS = (1.0, 1.5), 2.0


def starts(rng: np.random.Generator, grid: int = 41, scattered: int = 900) -> Array:
    """A grid over [-1, 2] x [-1, 2] and points scattered around it, some far away."""
    side = np.linspace(-1.0, 2.0, grid) + 1e-3
    square = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2)
    return np.concatenate([square, 0.5 + 2.0 * rng.standard_cauchy((scattered, 2)).clip(-99, 99)])


def expansion(t: float) -> Array:
    """Value, slope and bend at t of the function that is 0, 1, 0 and of that 0, 0, 1 at 0, t, 1."""
    kernel = Polynomial(WU_C2.coefficients)

    def row(at: float, order: int) -> list[float]:
        parts = [1.0 if order == 0 else 0.0]
        for center in CENTERS:
            distance = (center - at) / RADIUS
            parts.append(kernel.deriv(order)(distance) * (-1.0 / RADIUS) ** order)
        return parts

    cardinal = np.linalg.inv([row(0.0, 0), row(t, 0), row(1.0, 0)])[:, 1:]
    return np.asarray(np.array([row(t, order) for order in range(3)]) @ cardinal)


def multistart_roots(net: Array, motion: Array, guesses: Array) -> Array:
    """The distinct roots (x, y) at which Newton's method ends, shape (roots, 2).

    `motion` is the slope and the bend at t that `expansion` gives, shape (2, 2).
    """
    surface = BezierSurfaces(net[None])
    slope, bend = motion
    points, last = guesses.copy(), np.full(len(guesses), np.inf)
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            jet = surface.jet(points[None], 3)[:, :, 0]
            velocity = slope[0] * points.T + slope[1]
            second = bend[0] * points.T + bend[1]
            here = linearization(jet, velocity, second)
            # At the node itself, the values and both derivatives all move with the unknown.
            by = [
                [
                    here.by_value[i][j]
                    + slope[0] * here.by_velocity[i][j]
                    + bend[0] * here.by_second[i][j]
                    for j in range(2)
                ]
                for i in range(2)
            ]
            determinant = by[0][0] * by[1][1] - by[0][1] * by[1][0]
            first, other = here.residual
            step = np.stack(
                [first * by[1][1] - other * by[0][1], other * by[0][0] - first * by[1][0]], axis=1
            )
            step /= determinant[:, None]
            points = points - step
            last = np.abs(step).max(axis=1) / np.maximum(1.0, np.abs(points).max(axis=1))
    points = points[last < LAST_STEP]
    return distinct(points)


def distinct(points: Array) -> Array:
    roots: list[Array] = []
    for point in points[np.lexsort(points.T)]:
        if all(np.abs(point - root).max() > SAME * max(1.0, np.abs(point).max()) for root in roots):
            roots.append(point)
    return np.array(roots).reshape(-1, 2)


def missed(found: Array, expected: Array) -> list[Array]:
    """The expected roots that were not found."""
    return [
        root
        for root in expected
        if np.abs(found - root).max(axis=1, initial=0.0).min(initial=np.inf)
        > SAME * max(1.0, np.abs(root).max())
    ]


def sharpened(net: Array, motion: Array, points: Array) -> Array:
    """Roots by Newton's method in fractions, NaN where it does not converge.

    Far from the patch the two equations say nearly the same, and in double precision many points
    there pass for roots.
    """
    exact = np.vectorize(Fraction, otypes=[object])
    points_of, motion_of = exact(net), exact(motion)
    result = np.full_like(points, np.nan)
    for number, start in enumerate(points):
        point = exact(start)
        for _ in range(REFINEMENTS):
            residual = _exact_residual(points_of, motion_of, point)
            moved = [point + np.array(h) for h in ((TINY, 0), (0, TINY))]
            ahead = [_exact_residual(points_of, motion_of, place) for place in moved]
            (a, c), (b, d) = [(there - residual) / TINY for there in ahead]
            determinant = a * d - b * c
            if determinant == 0:
                break
            first, second = residual
            step = np.array(
                [(first * d - second * b) / determinant, (second * a - first * c) / determinant]
            )
            point = np.array(
                [Fraction(round((x - s) * BITS), BITS) for x, s in zip(point, step, strict=True)]
            )
            if max(abs(s) for s in step) < LAST_EXACT_STEP:
                result[number] = point.astype(np.float64)
                break
    return result


def _exact_residual(net: Any, motion: Any, point: Any) -> Any:
    (slope, bend) = motion
    velocity, second = slope[0] * point + slope[1], bend[0] * point + bend[1]

    def rows(t: Fraction) -> list[Any]:
        s = 1 - t
        return [
            np.array([s**3, 3 * s * s * t, 3 * s * t * t, t**3]),
            3 * np.array([-s * s, s * s - 2 * s * t, 2 * s * t - t * t, t * t]),
            6 * np.array([s, t - 2 * s, s - 2 * t, t]),
        ]

    in_u, in_v = rows(point[0]), rows(point[1])

    def derivative(i: int, j: int) -> Any:
        return np.tensordot(in_v[j], np.tensordot(in_u[i], net, 1), 1)

    s_u, s_v = derivative(1, 0), derivative(0, 1)
    a = derivative(2, 0) * velocity[0] ** 2 + derivative(0, 2) * velocity[1] ** 2
    a = a + 2 * derivative(1, 1) * velocity[0] * velocity[1] + s_u * second[0] + s_v * second[1]
    return np.array([s_u @ a, s_v @ a])
