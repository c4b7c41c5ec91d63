"""Shortest spline paths in patches, found by minimizing their energy without the library's solver.

A path is a quadratic spline in (u, v). With its coefficients in [0, 1] it lies in the patch, and
so its length is never less than that of the shortest path. Newton's
method with damping minimizes the energy, some coefficients held by their bounds (two-metric
projection: D. Bertsekas, SIAM J. Control Optim. 20 (1982) 221-246), on dense matrices.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from scipy.interpolate import BSpline

from bodymeasure._typing import Array
from bodymeasure.bezier import derivatives

DEGREE = 2
# Gauss points in each span for the energy, and for the lengths that are reported.
ENERGY_POINTS, LENGTH_POINTS = 3, 8
STEPS = 80
# This part of the path's own speed is added to the metric, which vanishes on a collapsed edge.
SMALL = 1e-9
# Damping, as a part of the metric: its first value, the factors after a good and a bad step, and
# the value at which a path is given up.
FIRST_DAMPING, LESS, MORE, MOST = 1e-2, 0.1, 6.0, 1e9


class SplineSpace(NamedTuple):
    """Splines with n coefficients at g Gauss points of [0, 1]; `values`, `slopes` are (g, n)."""

    points: Array
    weights: Array
    values: Array
    slopes: Array


@lru_cache
def spline_space(spans: int, points: int = ENERGY_POINTS) -> SplineSpace:
    nodes, weights = np.polynomial.legendre.leggauss(points)
    edges = np.linspace(0.0, 1.0, spans + 1)
    times = (edges[:-1, None] + (nodes + 1.0) / (2.0 * spans)).ravel()
    splines = BSpline(_knots(spans), np.eye(spans + DEGREE), DEGREE)
    return SplineSpace(
        times, np.tile(weights / (2.0 * spans), spans), splines(times), splines(times, 1)
    )


def _knots(spans: int) -> Array:
    edges = np.linspace(0.0, 1.0, spans + 1)
    return np.concatenate([DEGREE * [0.0], edges, DEGREE * [1.0]])


def greville(spans: int) -> Array:
    """The Greville abscissas, where a smooth path's values are close to a spline's coefficients."""
    knots = _knots(spans)
    return np.asarray((knots[1:-2] + knots[2:-1]) / 2.0)


def places(coefficients: Array, times: Array) -> Array:
    """The (u, v) at some times on splines with coefficients (paths, n, 2), shape (paths, k, 2)."""
    spans = coefficients.shape[1] - DEGREE
    return np.asarray(BSpline(_knots(spans), np.eye(spans + DEGREE), DEGREE)(times) @ coefficients)


def refined(coefficients: Array, spans: int) -> Array:
    """Nearly the same paths with more spans."""
    return np.clip(places(coefficients, greville(spans)), 0.0, 1.0)


def lengths(nets: Array, coefficients: Array) -> Array:
    """The lengths of spline paths, shape (paths,)."""
    space = spline_space(coefficients.shape[1] - DEGREE, LENGTH_POINTS)
    velocity = _motion(nets, coefficients, space, 1)[2]
    return np.asarray(np.linalg.norm(velocity, axis=-1) @ space.weights)


def descend(nets: Array, coefficients: Array, rest: float) -> Array:
    """Descend to paths of least energy within the patches.

    Parameters
    ----------
    nets : ndarray, shape (paths, 4, 4, 3)
    coefficients : ndarray, shape (paths, n, 2)
    rest : float
        A path is at rest when a step would lower its energy by less than this part.
    """
    space = spline_space(coefficients.shape[1] - DEGREE)
    result = np.clip(coefficients, 0.0, 1.0)
    active, damping = np.arange(len(result)), np.full(len(result), FIRST_DAMPING)
    for _ in range(STEPS):
        here = result[active]
        energy, gradient, hessian, metric = _expansion(nets[active], here, space)
        inner = here[:, 1:-1].swapaxes(1, 2).reshape(len(here), -1)
        free = ~((inner <= 0.0) & (gradient > 0.0) | (inner >= 1.0) & (gradient < 0.0))
        matrix = hessian + damping[active, None, None] * metric
        matrix *= free[:, None] & free[:, :, None]
        diagonal = np.arange(inner.shape[1])
        matrix[:, diagonal, diagonal] += ~free * np.abs(matrix).max(axis=(1, 2))[:, None]
        step = -np.linalg.solve(matrix, (free * gradient)[..., None])[..., 0]
        foretold = -(gradient * step).sum(axis=1)
        trial = here.copy()
        moved = np.clip(inner + step, 0.0, 1.0).reshape(len(here), 2, -1)
        trial[:, 1:-1] = moved.swapaxes(1, 2)
        there = _energy(nets[active], trial, space)
        better = there < energy
        result[active[better]] = trial[better]
        small = np.abs(foretold) < rest * energy
        damping[active] *= np.where(better, LESS, MORE)
        active = active[~small & (damping[active] < MOST)]
        if len(active) == 0:
            break
    return result


def _motion(
    nets: Array, coefficients: Array, space: SplineSpace, order: int
) -> tuple[Array, Array, Array]:
    """The derivatives of the patches along paths, (u', v') and x'."""
    jet = derivatives(nets, space.values @ coefficients, order)
    slope = space.slopes @ coefficients
    return jet, slope, jet[..., 1, 0, :] * slope[..., :1] + jet[..., 0, 1, :] * slope[..., 1:]


def _energy(nets: Array, coefficients: Array, space: SplineSpace) -> Array:
    velocity = _motion(nets, coefficients, space, 1)[2]
    return np.asarray((velocity**2).sum(axis=-1) @ space.weights / 2.0)


def _expansion(
    nets: Array, coefficients: Array, space: SplineSpace
) -> tuple[Array, Array, Array, Array]:
    """Half the energy, its gradient and Hessian in all inner u, then all inner v, and a metric."""
    d, slope, x = _motion(nets, coefficients, space, 3)
    du, dv = slope[..., :1], slope[..., 1:]
    first = (d[..., 1, 0, :], d[..., 0, 1, :])
    second = ((d[..., 2, 0, :], d[..., 1, 1, :]), (d[..., 1, 1, :], d[..., 0, 2, :]))
    mixed = d[..., 2, 1, :] * du + d[..., 1, 2, :] * dv
    third = (
        (d[..., 3, 0, :] * du + d[..., 2, 1, :] * dv, mixed),
        (mixed, d[..., 1, 2, :] * du + d[..., 0, 3, :] * dv),
    )
    # x' changes by x_by[a] when coordinate a does, and by first[a] when its slope does.
    x_by = tuple(second[a][0] * du + second[a][1] * dv for a in range(2))
    n, m = space.values[:, 1:-1], space.slopes[:, 1:-1]

    def dot(a: Array, b: Array) -> Array:
        return np.asarray(space.weights * (a * b).sum(axis=-1))

    def rows(weights: Array, functions: Array) -> Array:
        return np.asarray(functions.T * weights[:, None])

    gradient = np.concatenate([dot(x, x_by[a]) @ n + dot(x, first[a]) @ m for a in range(2)], 1)
    size = n.shape[1]
    hessian = np.empty((len(x), 2 * size, 2 * size))
    metric = np.zeros_like(hessian)
    for a in range(2):
        for b in range(2):
            bend = dot(x, second[a][b])
            by_place = rows(dot(x_by[a], x_by[b]) + dot(x, third[a][b]), n)
            by_place += rows(dot(first[a], x_by[b]) + bend, m)
            by_slope = rows(dot(x_by[a], first[b]) + bend, n)
            by_slope += rows(dot(first[a], first[b]), m)
            block = np.s_[:, a * size : (a + 1) * size, b * size : (b + 1) * size]
            hessian[block] = by_place @ n + by_slope @ m
        own = np.s_[:, a * size : (a + 1) * size, a * size : (a + 1) * size]
        scale = dot(first[a], first[a]).sum(axis=1) + SMALL * dot(x, x).sum(axis=1)
        metric[own] = scale[:, None, None] * (rows(space.weights[None], m) @ m)
    energy = dot(x, x).sum(axis=1) / 2.0
    return energy, gradient, hessian, metric
