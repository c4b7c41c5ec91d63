"""Newton's method with Levenberg-Marquardt damping for the minima of many problems at once."""

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.lengths.functionals import Functional, SecondOrder
from bodymeasure.geodesic.numerics.damped_newton import LAST_STEP, LONGEST_STEP
from bodymeasure.geodesic.solving.newton import NewtonResult
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

# Levenberg-Marquardt damping is relative to the trace of the metric. Its first value shortens a
# step that failed to about half of itself; it is multiplied by the second after each failure,
# divided by the third after each success, and zero below the last.
FIRST_DAMPING = 0.1
MORE_DAMPING = 4.0
LESS_DAMPING = 10.0
LEAST_DAMPING = 1e-4
# With more damping than this a step moves nothing, and the minimum cannot be found.
MOST_DAMPING = 1e6
# A step is accepted if it lowers the functional by this part of what was predicted.
SUFFICIENT_DECREASE = 1e-3
# Steps below this, in u and v, are rounding errors, however close the ends are.
SMALL_STEP = 1e-15
# The part of its value by which a functional may rise through rounding.
ROUNDING = 1e-14


def minimize(
    functional: Functional,
    surface: Surface,
    space: TrialSpace,
    start: Array,
    *,
    max_iterations: int,
) -> NewtonResult:
    """Minimize a functional of many paths by Newton's method with Levenberg-Marquardt damping.

    Parameters
    ----------
    functional : Functional
        `functionals.energy` or `functionals.length_over_v`.
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
    result = NewtonResult.unsolved(start)
    active = np.arange(count)
    span = np.abs(start[:, :, -1] - start[:, :, 0]).max(axis=1)
    base, best = start, functional(surface, space, start)
    # A functional of one unknown function is one of v.
    unknowns = best.gradient.shape[1] // (space.size - 1)
    coordinates = (0, 1)[-unknowns:]
    metric = _slope_products(space, unknowns)
    damping = np.zeros(count)
    for _ in range(max_iterations):
        step, solvable = _damped_step(best, metric, damping)
        direction = np.zeros_like(base)
        direction[:, coordinates, 1:-1] = step.reshape(len(step), unknowns, base.shape[2] - 2)
        size = np.abs(step).max(axis=1, initial=0.0)
        slope = np.einsum("pi,pi->p", best.gradient, step)
        predicted = slope + 0.5 * np.einsum("pi,pij,pj->p", step, best.hessian, step)
        result.iterations[active] += 1
        good = solvable & (size <= LONGEST_STEP)
        moved = np.where(good[:, None, None], base + direction, base)
        there = functional(surface, space, moved)
        allowed = best.value + SUFFICIENT_DECREASE * predicted + ROUNDING * best.value
        accepted = good & (predicted <= 0.0) & (there.value <= allowed)
        last = np.maximum(LAST_STEP * span[active], SMALL_STEP)
        converged = accepted & (damping == 0.0) & (size < last)
        base = np.where(accepted[:, None, None], moved, base)
        best = _chosen(accepted, there, best)
        damping = np.where(
            accepted, damping / LESS_DAMPING, np.maximum(FIRST_DAMPING, damping * MORE_DAMPING)
        )
        damping[damping < LEAST_DAMPING] = 0.0
        done = converged | (damping > MOST_DAMPING) | ~np.isfinite(best.value)
        result.values[active] = base
        result.converged[active] = converged
        result.singular[active] = done & ~solvable
        keep = np.flatnonzero(~done)
        if len(keep) == 0:
            break
        if done.any():
            active, base, damping = active[keep], base[keep], damping[keep]
            best = SecondOrder(best.value[keep], best.gradient[keep], best.hessian[keep])
            surface = surface.take(keep)
    return result


def _slope_products(space: TrialSpace, unknowns: int) -> Array:
    """The scalar products of the slopes of the cardinal functions, which damping adds."""
    slopes = space.at_quadrature[1][:, 1:-1]
    products = (slopes.T * space.quadrature.weights) @ slopes
    result: Array = np.kron(np.eye(unknowns), products)
    return result


def _damped_step(here: SecondOrder, metric: Array, damping: Array) -> tuple[Array, Bools]:
    """The steps, and which of them could be computed."""
    finite = np.asarray(
        np.isfinite(here.gradient).all(axis=1) & np.isfinite(here.hessian).all(axis=(1, 2))
    )
    # In proportion to the Hessian, so that the unit of length does not matter.
    trace = np.abs(np.trace(here.hessian, axis1=1, axis2=2)) / np.trace(metric)
    matrix = here.hessian + (damping * trace)[:, None, None] * metric
    matrix = np.where(finite[:, None, None], matrix, np.eye(len(metric)))
    gradient = np.where(finite[:, None], here.gradient, 0.0)[..., None]
    try:
        step = np.linalg.solve(matrix, -gradient)[..., 0]
    except np.linalg.LinAlgError:
        # A system of the batch is exactly singular; this gives the shortest of its solutions.
        step = (np.linalg.pinv(matrix, hermitian=True) @ -gradient)[..., 0]
    return np.where(finite[:, None], step, 0.0), finite


def _chosen(accepted: Bools, there: SecondOrder, here: SecondOrder) -> SecondOrder:
    return SecondOrder(
        np.where(accepted, there.value, here.value),
        np.where(accepted[:, None], there.gradient, here.gradient),
        np.where(accepted[:, None, None], there.hessian, here.hessian),
    )
