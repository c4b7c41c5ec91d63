"""The reference of the benchmarks: Chebyshev collocation in plain NumPy.

It uses nothing of bodymeasure's solver: nodes, equations, Newton's method, quadrature and the
assessment of the result are its own. A length counts only where two resolutions agree on it.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.bench.problems.patches import Problems
from bodymeasure.bezier import derivatives

Long = NDArray[np.longdouble]

PI = 4.0 * np.arctan(np.longdouble(1.0))

# Pairs of degrees, each of which is tried only where those before it fail.
DEGREES = ((32, 44), (72, 96))
# The same for few problems, or for paths that are nearly known, since the last pair is slow.
FINEST = (*DEGREES, (128, 160))
# Relative difference of the lengths in both degrees: some hundred rounding errors.
AGREEMENT = 1e-13
# Tangential acceleration between the nodes, relative; the length's error is about its square.
LARGEST_RESIDUAL = 1e-5
# A path on the edge of a patch lies outside by no more than rounding errors.
OUTSIDE = 1e-9
# The number of problems that are solved together, which bounds the memory.
CHUNK = 200
GAUSS, WEIGHTS = np.polynomial.legendre.leggauss(160)
GAUSS, WEIGHTS = 0.5 * (GAUSS + 1.0), 0.5 * WEIGHTS


@dataclass(frozen=True)
class Reference:
    """Lengths of geodesics, NaN where unknown, and which paths certainly leave their patch.

    ``paths`` are (u, v) at `GAUSS`, shape (problems, points, 2).
    """

    length: Array
    leaves: Bools
    paths: Array


def nodes(degree: int) -> Long:
    """Return the Chebyshev-Lobatto points of [0, 1]."""
    return np.asarray(0.5 - 0.5 * np.cos(PI * np.arange(degree + 1) / degree))


GUESS_DEGREE = 32
GUESS_TIMES = nodes(GUESS_DEGREE).astype(np.float64)


@lru_cache
def matrices(degree: int, at: int | None = None) -> Long:
    """Return the matrices from values at nodes to values and two derivatives, (3, k, degree + 1).

    Values are taken at the nodes of another degree, or at `GAUSS`. The matrices are made in
    extended precision; in double precision, two digits of the lengths would be lost.
    """
    t = GAUSS.astype(np.longdouble) if at is None else nodes(at)
    k = np.arange(degree + 1)
    halved = np.where((k == 0) | (k == degree), 0.5, 1.0)
    to_coefficients = np.cos(PI * (np.outer(k, degree - k) % (2 * degree)) / degree)
    to_coefficients *= 2.0 / degree * np.outer(halved, halved)
    result = [
        chebyshev.chebval(2.0 * t - 1.0, chebyshev.chebder(to_coefficients, m, scl=2)).T
        for m in range(3)
    ]
    return np.stack(result)


def _tangential(jet: Array, velocity: Array, bend: Array) -> tuple[Array, ...]:
    """Return tangents (..., 2, 3), second derivatives (..., 2, 2, 3), acceleration (..., 3)."""
    tangents = np.stack([jet[..., 1, 0, :], jet[..., 0, 1, :]], axis=-2)
    mixed = jet[..., 1, 1, :]
    second = np.stack([jet[..., 2, 0, :], mixed, mixed, jet[..., 0, 2, :]], axis=-2)
    second = second.reshape(*mixed.shape[:-1], 2, 2, 3)
    acceleration = np.einsum("...ijx,...i,...j->...x", second, velocity, velocity)
    acceleration += np.einsum("...ix,...i->...x", tangents, bend)
    return tangents, second, acceleration


def _system(nets: Array, paths: Array, operators: Array) -> tuple[Array, Array]:
    """Return the residual (p, m, 2) of the equations, and its derivative by the inner nodes."""
    velocity, bend = (operators[k] @ paths for k in (1, 2))
    jet = derivatives(nets, paths[:, 1:-1], order=3)
    tangents, second, acceleration = _tangential(jet, velocity, bend)
    third = np.stack([jet[..., 3, 0, :], jet[..., 2, 1, :], jet[..., 1, 2, :], jet[..., 0, 3, :]])
    i, j, k = np.indices((2, 2, 2))
    third = np.moveaxis(third[i + j + k], (0, 1, 2), (-4, -3, -2))

    by_place = np.einsum("...ijkx,...i,...j->...kx", third, velocity, velocity)
    by_place += np.einsum("...ikx,...i->...kx", second, bend)
    by_velocity = 2.0 * np.einsum("...kjx,...j->...kx", second, velocity)
    local = np.einsum("...akx,...x->...ak", second, acceleration)
    local += np.einsum("...ax,...kx->...ak", tangents, by_place)
    first = np.einsum("...ax,...kx->...ak", tangents, by_velocity)
    metric = np.einsum("...ax,...kx->...ak", tangents, tangents)
    jacobian = np.einsum("pmak,mn->pmank", first, operators[1, :, 1:-1])
    jacobian += np.einsum("pmak,mn->pmank", metric, operators[2, :, 1:-1])
    m = np.arange(paths.shape[1] - 2)
    jacobian[:, m, :, m, :] += local.swapaxes(0, 1)
    return np.einsum("...ax,...x->...a", tangents, acceleration), jacobian


def _newton(nets: Array, start: Array, degree: int) -> Array:
    """Return paths (p, degree + 1, 2) that solve the equations at the nodes; NaN for failures."""
    operators = matrices(degree, degree)[:, 1:-1].astype(np.float64)
    size = 2 * (degree - 1)
    result, found, active = start.copy(), np.zeros(len(start), bool), np.arange(len(start))
    best, step = np.full(len(start), np.inf), np.zeros(len(start))
    direction = np.zeros((len(start), degree - 1, 2))
    for _ in range(60):
        trial = result[active]
        trial[:, 1:-1] += step[active, None, None] * direction[active]
        residual, jacobian = _system(nets[active], trial, operators)
        norm = np.linalg.norm(residual.reshape(-1, size), axis=1)
        better = norm < best[active]
        step[active[~better]] *= 0.5
        rows = active[better]
        result[rows], best[rows] = trial[better], norm[better]
        system, right = jacobian[better].reshape(-1, size, size), -residual[better]
        # A little regularization keeps one singular system from stopping the whole batch.
        system += 1e-15 * np.abs(system).max(axis=(1, 2), initial=0.0)[:, None, None] * np.eye(size)
        direction[rows] = np.linalg.solve(system, right.reshape(-1, size, 1)).reshape(right.shape)
        longest = np.abs(direction[active]).max(axis=(1, 2))
        step[rows] = np.minimum(1.0, 0.3 / np.maximum(longest[better], 1e-300))
        found[active] = longest < 1e-9
        active = active[~found[active] & (step[active] > 1e-5)]
        if len(active) == 0:
            break
    result[:, 1:-1] += np.where(found[:, None, None], direction, np.nan)
    return result


def _measure(nets: Array, paths: Array, degree: int) -> tuple[Array, Array, Array]:
    """Return lengths, relative residuals between the nodes, and the paths at `GAUSS`."""
    places, velocity, bend = (matrices(degree)[:, None] @ paths).astype(np.float64)
    jet = derivatives(nets, np.nan_to_num(places), order=2)
    tangents, _, acceleration = _tangential(jet, velocity, bend)
    speed = np.linalg.norm(np.einsum("pmax,pma->pmx", tangents, velocity), axis=-1)
    length = speed @ WEIGHTS
    along = np.einsum("pmax,pmx->pma", tangents, acceleration)
    along /= np.linalg.norm(tangents, axis=-1) * length[:, None, None]
    return length, np.abs(along).max(axis=(1, 2)), places


def geodesics(
    problems: Problems,
    *,
    guess: Array | None = None,
    pairs: tuple[tuple[int, int], ...] = DEGREES,
) -> Reference:
    """Return reference lengths of geodesics.

    Parameters
    ----------
    problems : Problems
    guess : ndarray, shape (problems, k, 2), optional
        Paths at `GUESS_TIMES` to start from; by default straight lines in (u, v).
    pairs : tuple of tuple of int
        Pairs of polynomial degrees; each is tried where those before it failed.

    Returns
    -------
    Reference
    """
    nets, start, end = problems
    if guess is None:
        guess = start[:, None] + (end - start)[:, None] * GUESS_TIMES[:, None]
    guess = guess.copy()
    guess[:, 0], guess[:, -1] = start, end
    count = len(nets)
    paths = np.full((count, len(GAUSS), 2), np.nan)
    result = Reference(np.full(count, np.nan), np.zeros(count, bool), paths)
    for degrees in pairs:
        rest = np.flatnonzero(np.isnan(result.paths[:, 0, 0]))
        for rows in np.split(rest, range(CHUNK, len(rest), CHUNK)):
            _fill(result, nets[rows], guess[rows], degrees, rows)
    return result


def _fill(
    result: Reference, nets: Array, values: Array, degrees: tuple[int, int], rows: Ints
) -> None:
    """Solve some problems in both degrees, and enter the lengths on which they agree."""
    before, lengths, residuals = GUESS_DEGREE, [], []
    for degree in degrees:
        ends = values[:, [0, -1]]
        values = matrices(before, degree)[0].astype(np.float64) @ np.nan_to_num(values)
        values[:, [0, -1]] = ends
        values = _newton(nets, values, degree)
        length, residual, places = _measure(nets, values, degree)
        lengths.append(length)
        residuals.append(residual)
        before = degree
    with np.errstate(invalid="ignore"):
        good = np.abs(lengths[0] / lengths[1] - 1.0) < AGREEMENT
        good &= np.max(residuals, axis=0) < LARGEST_RESIDUAL
        outside = (np.abs(places - 0.5) > 0.5 + OUTSIDE).any(axis=(1, 2))
    result.length[rows[good & ~outside]] = length[good & ~outside]
    result.leaves[rows[good & outside]] = True
    result.paths[rows[good]] = places[good]
