"""Newton's method for many collocation systems at once."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.lengths.equations import residual_and_jacobian
from bodymeasure.geodesic.numerics.damped_newton import LAST_STEP, LONGEST_STEP, SMALLEST_STEP
from bodymeasure.geodesic.numerics.linear_systems import solved
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.bezier import compiled_patches
from bodymeasure.geodesic.surfaces.protocol import Surface
from bodymeasure.native import CollocationSettings, collocated

# A step is accepted if it lowers the norm of the residual by this part of what was predicted.
SUFFICIENT_DECREASE = 1e-3
MAX_ITERATIONS = 25
_SETTINGS = CollocationSettings(SUFFICIENT_DECREASE, LAST_STEP, LONGEST_STEP, SMALLEST_STEP)


@dataclass
class NewtonResult:
    """The values at which Newton's method ended for each problem.

    Parameters
    ----------
    values : ndarray, shape (problems, 2, n + 1)
        u and v at the nodes.
    converged : ndarray of bool, shape (problems,)
    singular : ndarray of bool, shape (problems,)
        Whether the linear system could not be solved, or the residual is not finite at the start.
    iterations : ndarray of int, shape (problems,)
    """

    values: Array
    converged: Bools
    singular: Bools
    iterations: Ints

    @classmethod
    def unsolved(cls, start: Array) -> "NewtonResult":
        """Return the state before the first step, for a guess of shape (problems, 2, n + 1)."""
        none = np.zeros(len(start), bool)
        return cls(start.copy(), none, none.copy(), np.zeros(len(start), np.int64))


def newton(
    surface: Surface,
    space: TrialSpace,
    start: Array,
    *,
    max_iterations: int = MAX_ITERATIONS,
) -> NewtonResult:
    """Solve the collocation equations of many problems by damped Newton steps.

    Parameters
    ----------
    surface : Surface
    space : TrialSpace
        With n + 1 nodes.
    start : ndarray, shape (problems, 2, n + 1)
        First guess of u and v at the nodes; the end nodes stay as they are.
    max_iterations : int

    Returns
    -------
    NewtonResult
        Problems that are done, either way, drop out of the work.
    """
    count = len(start)
    span = np.abs(start[:, :, -1] - start[:, :, 0]).max(axis=1)
    patches = compiled_patches(surface)
    if patches is not None:
        maps, stay = (space.differentiation, space.at_ends[1]), np.full((count, 2), -1)
        return NewtonResult(
            *collocated(patches, maps, (start, stay, span), max_iterations, _SETTINGS)
        )
    result = NewtonResult.unsolved(start)
    active = np.arange(count)
    base = start
    direction = np.zeros_like(start)
    step = np.zeros(count)
    base_norm = np.full(count, np.inf)
    for _ in range(max_iterations):
        if len(active) == 0:
            break
        trial = base + step[:, None, None] * direction
        residual, jacobian = residual_and_jacobian(surface, space, trial)
        result.iterations[active] += 1
        norm = np.sqrt(np.einsum("pij,pij->p", residual, residual))
        accepted = norm <= (1.0 - SUFFICIENT_DECREASE * step) * base_norm
        if accepted.all():
            base, base_norm = trial, norm
            direction, solvable = _direction(jacobian, residual, direction)
            step = _first_step(direction)
        else:
            moved = np.flatnonzero(accepted)
            solvable = np.ones(len(active), bool)
            base = np.where(accepted[:, None, None], trial, base)
            base_norm = np.where(accepted, norm, base_norm)
            direction = direction.copy()
            step = step * 0.5
            direction[moved], solvable[moved] = _direction(
                jacobian[moved], residual[moved], direction[moved]
            )
            step[moved] = _first_step(direction[moved])
        size = np.abs(direction).max(axis=(1, 2))
        converged = solvable & (size < LAST_STEP * span[active])
        done = converged | ~solvable | (step < SMALLEST_STEP) | ~np.isfinite(base_norm)
        if not done.any():
            continue
        ended = active[done]
        # The last step is known already; taking it squares the error once more.
        full = converged[done, None, None] * direction[done]
        result.values[ended] = base[done] + full
        result.converged[ended] = converged[done]
        # A first residual that is not finite is as bad as a system that cannot be solved.
        result.singular[ended] = ~solvable[done] | ~np.isfinite(base_norm[done])
        keep = np.flatnonzero(~done)
        active, base, base_norm = active[keep], base[keep], base_norm[keep]
        direction, step = direction[keep], step[keep]
        surface = surface.take(keep)
    else:
        result.values[active] = base
    return result


def _first_step(direction: Array) -> Array:
    size = np.abs(direction).max(axis=(1, 2))
    return np.asarray(np.minimum(1.0, LONGEST_STEP / np.maximum(size, LONGEST_STEP)))


def _direction(jacobian: Array, residual: Array, like: Array) -> tuple[Array, Bools]:
    """The Newton directions, zero at the end nodes, and which systems could be solved."""
    problems, _, points = residual.shape
    matrix = jacobian.reshape(problems, 2 * points, 2 * points)
    right = -residual.reshape(problems, 2 * points)
    solvable = np.asarray(np.isfinite(right).all(axis=1))
    if not solvable.all():
        matrix = np.where(solvable[:, None, None], matrix, np.eye(2 * points))
        right = np.where(solvable[:, None], right, 0.0)
    solution = solved(matrix, right)
    solvable &= np.isfinite(solution).all(axis=1)
    direction = np.zeros_like(like)
    direction[:, :, 1:-1] = np.where(solvable[:, None], solution, 0.0).reshape(problems, 2, points)
    return direction, solvable
