"""Geodesics by another method than the library's, against which its lengths are checked.

The energy of a polynomial path is made stationary. There is no geodesic equation, no collocation,
no radial function and no correction of the length; the only function of the library that is used
is `bezier.derivatives`.
"""

import numpy as np
from numpy.polynomial import chebyshev, legendre
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.bezier import derivatives

# The degrees of two paths, and the relative agreement of their lengths below which none is given.
DEGREES = (28, 40)
AGREEMENT = 1e-11
STEPS = 30
# The size in (u, v) of a Newton step that is the last.
SMALL_STEP = 1e-11
HALVINGS = 12


def reference_lengths(
    control_points: ArrayLike,
    start: ArrayLike,
    end: ArrayLike,
    guess: Array | None = None,
    *,
    degrees: tuple[int, int] = DEGREES,
) -> Array:
    """Lengths of geodesics, shape (problems,); NaN where the path is not resolved.

    Parameters
    ----------
    control_points : array_like, shape (problems, m + 1, n + 1, 3)
    start, end : array_like, shape (2,) or (problems, 2)
    guess : ndarray, shape (problems, k, 2), optional
        The start of the iteration, a path at `chebyshev_times(k)`; by default the straight line
        in (u, v).
    degrees : tuple of int
        The degrees of the two paths whose lengths must agree.
    """
    nets = np.asarray(control_points, dtype=np.float64)
    problems = len(nets)
    start, end = (np.broadcast_to(np.asarray(p, float), (problems, 2)) for p in (start, end))
    if guess is None:
        guess = np.stack([start, end], axis=1)
    lengths = []
    for degree in degrees:
        path = _interpolation(guess.shape[1], chebyshev_times(degree + 1))[0] @ guess
        path[:, 0], path[:, -1] = start, end
        guess = np.stack([_stationary(net, values) for net, values in zip(nets, path, strict=True)])
        lengths.append([_length(net, values) for net, values in zip(nets, guess, strict=True)])
    coarse, fine = np.array(lengths)
    with np.errstate(invalid="ignore"):
        agree = np.abs(fine - coarse) <= AGREEMENT * fine
    return np.where(agree, fine, np.nan)


def chebyshev_times(count: int) -> Array:
    """Chebyshev points of the second kind on [0, 1], increasing."""
    return np.asarray(0.5 - 0.5 * np.cos(np.pi * np.arange(count) / (count - 1)))


def _interpolation(count: int, t: Array) -> Array:
    """Matrices from values at `chebyshev_times(count)` to values and slopes at t.

    Their shape is (2, times, count).
    """
    inverse = np.linalg.inv(chebyshev.chebvander(2.0 * chebyshev_times(count) - 1.0, count - 1))
    coefficients = np.eye(count)
    slopes = chebyshev.chebder(coefficients, axis=0) if count > 1 else 0.0 * coefficients
    x = 2.0 * t - 1.0
    values = chebyshev.chebvander(x, count - 1) @ inverse
    return np.stack([values, 2.0 * chebyshev.chebvander(x, count - 2) @ slopes @ inverse])


def _gauss(count: int) -> tuple[Array, Array]:
    nodes, weights = legendre.leggauss(count)
    return (nodes + 1.0) / 2.0, weights / 2.0


def _motion(net: Array, values: Array, rows: Array, order: int) -> tuple[Array, Array, Array]:
    """Derivatives of the patch along the path, (u', v') and x'."""
    d = derivatives(net, rows[0] @ values, order)
    slope = rows[1] @ (values - values[0])
    return d, slope, d[:, 1, 0] * slope[:, :1] + d[:, 0, 1] * slope[:, 1:]


def _length(net: Array, values: Array) -> float:
    if not np.isfinite(values).all():
        return np.nan
    t, weights = _gauss(3 * len(values))
    return float(
        weights @ np.linalg.norm(_motion(net, values, _interpolation(len(values), t), 1)[2], axis=1)
    )


def _energy(net: Array, values: Array, rows: Array, weights: Array) -> float:
    return float(weights @ (_motion(net, values, rows, 1)[2] ** 2).sum(axis=1))


def _stationary(net: Array, values: Array) -> Array:
    """Newton's method on the energy, in the inner nodal values; NaN where it does not converge."""
    t, weights = _gauss(2 * len(values))
    rows = _interpolation(len(values), t)
    inner = rows[:, :, 1:-1]
    for _ in range(STEPS):
        gradient, hessian = _derivatives_of_energy(net, values, rows, inner, weights)
        try:
            step = -np.linalg.solve(hessian, gradient)
        except np.linalg.LinAlgError:
            break
        step = step.reshape(2, -1).T
        size = np.abs(step).max()
        if not np.isfinite(size):
            break
        length = min(1.0, 0.3 / max(size, 0.3))
        if gradient @ step.T.ravel() < 0.0 and size > 1e-5:
            before = _energy(net, values, rows, weights)
            for _ in range(HALVINGS):
                trial = values.copy()
                trial[1:-1] += length * step
                if _energy(net, trial, rows, weights) < before:
                    break
                length /= 2.0
        values = values.copy()
        values[1:-1] += length * step
        if size < SMALL_STEP:
            return values
    return np.full_like(values, np.nan)


def _derivatives_of_energy(
    net: Array, values: Array, rows: Array, inner: Array, weights: Array
) -> tuple[Array, Array]:
    """Half the energy's gradient and Hessian in all inner u, then all inner v."""
    d, slope, x = _motion(net, values, rows, 3)
    du, dv = slope[:, :1], slope[:, 1:]
    first = (d[:, 1, 0], d[:, 0, 1])
    second = ((d[:, 2, 0], d[:, 1, 1]), (d[:, 1, 1], d[:, 0, 2]))
    third = (
        (d[:, 3, 0] * du + d[:, 2, 1] * dv, d[:, 2, 1] * du + d[:, 1, 2] * dv),
        (d[:, 2, 1] * du + d[:, 1, 2] * dv, d[:, 1, 2] * du + d[:, 0, 3] * dv),
    )
    # x' changes by x_by[a] when coordinate a does, and by first[a] when its slope does.
    x_by = tuple(second[a][0] * du + second[a][1] * dv for a in range(2))
    n, m = inner

    def dot(a: Array, b: Array) -> Array:
        return np.asarray(weights * (a * b).sum(axis=1))

    gradient = np.concatenate([n.T @ dot(x, x_by[a]) + m.T @ dot(x, first[a]) for a in range(2)])
    blocks = []
    for a in range(2):
        for b in range(2):
            bend = dot(x, second[a][b])
            blocks.append(
                (n.T * (dot(x_by[a], x_by[b]) + dot(x, third[a][b]))) @ n
                + (n.T * (dot(x_by[a], first[b]) + bend)) @ m
                + (m.T * (dot(first[a], x_by[b]) + bend)) @ n
                + (m.T * dot(first[a], first[b])) @ m
            )
    return gradient, np.block([blocks[:2], blocks[2:]])
