"""Shortest piecewise paths inside the patch, by energy descent within the box [0, 1]^2."""

from __future__ import annotations

import numpy as np
import scipy
from numpy.typing import NDArray

from bodymeasure.geodesic.surface import Surface

_Array = NDArray[np.float64]

# Newton steps at most. Nearly all paths take 6 to 15; each change of the active bounds costs one.
MAX_STEPS = 60
# A path is at rest when a step would lower its energy by less than this part.
REST = 1e-11
# Damping, as a part of the metric: first value, factors after a good and a bad step, and the
# value past which no step helps.
FIRST_DAMPING, LESS, MORE, MOST = 1e-3, 0.2, 8.0, 1e8
# Part of its mean that is added to the metric, which vanishes on a collapsed edge.
REGULARIZATION = 1e-10
# Bands on and below the diagonal of a Hessian: a point's two coordinates, and its neighbor's.
BANDS = 4
# Stiffness, relative to the metric, that stands in for a coordinate that its bound holds.
STIFF = 1e3


def descend(surface: Surface, start: _Array) -> tuple[_Array, _Array]:
    """Minimize the energy of polygons on patches, their ends fixed, every point in the patch.

    The energy of a polygon of m edges is m times the sum of their squares; its minimum has edges of
    equal length and the least length. Newton steps with the exact Hessian, damped as by Levenberg
    and Marquardt, in the variables that no active bound holds (projected active set: D. Bertsekas,
    SIAM J. Control Optim. 20 (1982) 221-246).

    Parameters
    ----------
    surface : Surface
    start : ndarray, shape (problems, m + 1, 2)
        Put into [0, 1] if they are not.

    Returns
    -------
    points : ndarray, shape (problems, m + 1, 2)
        (u, v), all in [0, 1], and exactly 0 or 1 where an edge of the patch holds them.
    length : ndarray, shape (problems,)
        Sum of the straight distances between neighboring points: an inscribed polygon's, so a
        little less than the path's on the surface.
    """
    points = np.clip(start, 0.0, 1.0)
    problems, count = points.shape[0], points.shape[1] - 2
    damping = np.full(problems, FIRST_DAMPING)
    energy = _energy(surface, points)
    active = np.arange(problems)
    for _ in range(MAX_STEPS):
        if len(active) == 0:
            break
        here, part = points[active], surface.take(active)
        gradient, hessian, metric = _derivatives(part, here)
        free = ~_held(here[:, 1:-1], gradient)
        damped = hessian + damping[active, None, None] * metric
        step, foretold = _steps(gradient, damped, free)
        trial = here.copy()
        trial[:, 1:-1] = np.clip(here[:, 1:-1] + step.reshape(-1, count, 2), 0.0, 1.0)
        new = _energy(part, trial)
        better = new < energy[active]
        points[active[better]] = trial[better]
        energy[active[better]] = new[better]
        damping[active] *= np.where(better, LESS, MORE)
        rest = (foretold < REST * energy[active]) | (damping[active] > MOST)
        active = active[~rest]
    return points, _length(surface, points)


def ways_off(surface: Surface, points: _Array) -> tuple[_Array, _Array]:
    """Where polygons at rest can still slide down: the lowest mode of their energy's Hessian.

    Parameters
    ----------
    points : ndarray, shape (problems, m + 1, 2)
        As `descend` returns them.

    Returns
    -------
    curvature : ndarray, shape (problems,)
        Lowest eigenvalue in the coordinates that are free to move, relative to the metric: negative
        at a saddle.
    direction : ndarray, shape (problems, m + 1, 2)
        Its eigenvector, of size 1 where it is largest.
    """
    gradient, hessian, metric = _derivatives(surface, points)
    free = ~_held(points[:, 1:-1], gradient).reshape(len(points), -1)
    # Relative to the metric's diagonal, which is enough to compare with zero.
    scale = 1.0 / np.sqrt(metric[:, 0])
    direction = np.zeros_like(points)
    curvature = np.zeros(len(points))
    for i in range(len(points)):
        scaled = _restricted(hessian[i], free[i], STIFF / scale[i] ** 2)
        for offset in range(BANDS):
            size = scaled.shape[1] - offset
            scaled[offset, :size] *= scale[i, :size] * scale[i, offset:]
        value, vector = scipy.linalg.eig_banded(scaled, lower=True, select="i", select_range=(0, 0))
        curvature[i] = value[0]
        direction[i, 1:-1] = (vector[:, 0] * scale[i]).reshape(-1, 2)
    return curvature, direction / np.abs(direction).max(axis=(1, 2), keepdims=True)


def _positions(surface: Surface, points: _Array) -> _Array:
    return np.moveaxis(surface.jet(points, 0)[0], 0, -1)


def _energy(surface: Surface, points: _Array) -> _Array:
    edges = np.diff(_positions(surface, points), axis=1)
    result: _Array = edges.shape[1] * np.einsum("pkc,pkc->p", edges, edges)
    return result


def _length(surface: Surface, points: _Array) -> _Array:
    edges = np.diff(_positions(surface, points), axis=1)
    result: _Array = np.linalg.norm(edges, axis=-1).sum(axis=1)
    return result


def _derivatives(surface: Surface, points: _Array) -> tuple[_Array, _Array, _Array]:
    """Gradient (problems, k, 2), Hessian and metric as bands (problems, BANDS, 2 k).

    Band o holds the matrix's entries (i + o, i): the lower form of `scipy.linalg.solveh_banded`.
    """
    problems, count = points.shape[0], points.shape[1] - 2
    jet = np.moveaxis(surface.jet(points, 2), 1, -1)
    position, inner = jet[0], jet[:, :, 1:-1]
    bend = 2.0 * position[:, 1:-1] - position[:, :-2] - position[:, 2:]
    tangents = np.stack([inner[1], inner[2]], axis=-2)
    second = np.stack([inner[3], inner[4], inner[4], inner[5]], axis=-2)
    factor = 2.0 * (count + 1)
    gradient = factor * np.einsum("pkac,pkc->pka", tangents, bend)
    own = np.einsum("pkac,pkbc->pkab", tangents, tangents)
    curving = np.einsum("pkac,pkc->pka", second, bend).reshape(problems, count, 2, 2)
    next_one = -factor * np.einsum("pkac,pkbc->pkab", tangents[:, 1:], tangents[:, :-1])
    mean = np.einsum("pkaa->p", own) / (2 * count)
    regular = own + (REGULARIZATION * mean)[:, None, None, None] * np.eye(2)
    no_next = np.zeros_like(next_one)
    return (
        gradient,
        _bands(factor * (2.0 * own + curving), next_one),
        _bands(2.0 * factor * regular, no_next),
    )


def _bands(own: _Array, next_one: _Array) -> _Array:
    """Bands of a block tridiagonal matrix, of its blocks on and below the diagonal."""
    problems, count = own.shape[:2]
    bands = np.zeros((problems, BANDS, count, 2))
    bands[:, 0, :, 0], bands[:, 0, :, 1] = own[..., 0, 0], own[..., 1, 1]
    bands[:, 1, :, 0] = own[..., 1, 0]
    bands[:, 1, :-1, 1] = next_one[..., 0, 1]
    bands[:, 2, :-1, 0], bands[:, 2, :-1, 1] = next_one[..., 0, 0], next_one[..., 1, 1]
    bands[:, 3, :-1, 0] = next_one[..., 1, 0]
    return bands.reshape(problems, BANDS, 2 * count)


def _held(inner: _Array, gradient: _Array) -> NDArray[np.bool_]:
    """Which coordinates their bound holds: on it, and pulled outwards."""
    result: NDArray[np.bool_] = ((inner <= 0.0) & (gradient > 0.0)) | (
        (inner >= 1.0) & (gradient < 0.0)
    )
    return result


def _restricted(bands: _Array, free: NDArray[np.bool_], diagonal: _Array | float) -> _Array:
    """A banded matrix in which the coordinates that are not free stand alone."""
    result = bands.copy()
    result[0] = np.where(free, bands[0], diagonal)
    for offset in range(1, BANDS):
        size = len(free) - offset
        result[offset, :size] *= free[:size] & free[offset:]
    return result


def _steps(gradient: _Array, matrix: _Array, free: NDArray[np.bool_]) -> tuple[_Array, _Array]:
    """Newton steps of the free coordinates, and the decreases that the model foretells.

    Where a matrix is not positive definite the step is zero, and more damping is called for.
    """
    problems = len(gradient)
    free = free.reshape(problems, -1)
    right = np.where(free, -gradient.reshape(problems, -1), 0.0)
    step, foretold = np.zeros_like(right), np.full(problems, np.inf)
    for i in range(problems):
        try:
            step[i] = scipy.linalg.solveh_banded(
                _restricted(matrix[i], free[i], 1.0), right[i], lower=True
            )
        except (np.linalg.LinAlgError, ValueError):
            continue
        foretold[i] = right[i] @ step[i]
    return step, foretold
