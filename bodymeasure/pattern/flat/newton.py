"""Newton's method for the least energy under constraints."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.pattern.flat.constraints import Constraints
from bodymeasure.pattern.flat.energy import Energy

# Parts of a Newton step that are tried; less than the last one leads nowhere.
HALVINGS = 30
# The part of the promised descent of the merit that a step has to keep.
DESCENT = 1e-4
# The factor by which the merit's weight of constraints exceeds the largest multiplier.
HEAVIER = 1.5


class _Model(Enum):
    """The second derivatives of a step, from the quickest to the safest."""

    FULL = "all of the Lagrangian"
    GAUSS_NEWTON = "those of the constraints, and of the energy by Gauss and Newton"
    TENSION = "the same without the constraints under pressure, which buckle"


@dataclass(frozen=True, eq=False)
class Stationary:
    """Where Newton's method ended.

    Parameters
    ----------
    flat : ndarray, shape (n, 2)
    multipliers : ndarray, shape (m,)
    missed : float
        The most by which an equation is missed, a length.
    step : float
        The length of the last step.
    steps : int
    """

    flat: Array
    multipliers: Array
    missed: float
    step: float
    steps: int


@dataclass(frozen=True)
class Goal:
    """When Newton's method ends.

    Parameters
    ----------
    missed : float
        The most by which an equation may be missed, as a length.
    step : float
        The longest last step.
    steps : int
        The most steps.
    """

    missed: float
    step: float
    steps: int


def stationary(
    energy: Energy,
    constraints: Constraints,
    flat: Array,
    goal: Goal,
    multipliers: Array | None = None,
) -> Stationary:
    """Return the place of least energy near a layout without flipped triangles.

    Notes
    -----
    Each step solves the equations of the Lagrangian, with the energy's curvature by Gauss and
    Newton and the full curvature of the constraints. Where that step does not lead down, only
    constraints whose multipliers are positive keep their curvature: sides under tension, which
    resist, but not sides under pressure, which buckle.
    """
    known = multipliers is not None
    if multipliers is None:
        multipliers = np.zeros(constraints.count)
    weight, missed, length, steps = 0.0, np.inf, np.inf, 0
    for steps in range(1, goal.steps + 1):
        gradient, hessian = energy.model(flat)
        values, jacobian = constraints.values(flat), constraints.jacobian(flat)
        moved = None
        for model in _Model if known else (_Model.TENSION,):
            tension = model is _Model.TENSION
            used = np.maximum(multipliers, 0.0) if tension else multipliers
            curved = (hessian + constraints.curvature(used, flat)).tocsr()
            if model is _Model.FULL:
                curved = (curved + energy.bending(flat)).tocsr()
            solve = _solver(curved, jacobian)
            step, found = solve(-gradient, -values)
            weight = HEAVIER * float(np.abs(found).max(initial=0.0))
            slope = float(gradient @ step) - weight * float(np.abs(values).sum())
            bends = float(step @ (curved @ step))
            if slope < 0.0 and bends > 0.0:
                moved = _moved(
                    energy, constraints, flat, step.reshape(-1, 2), (weight, slope), solve
                )
            if moved is not None:
                break
        if moved is None:
            # Near the end rounding hides the descent; a whole step that flips nothing is right.
            whole = flat + step.reshape(-1, 2)
            if np.abs(step).max() > 1e3 * goal.step or not np.isfinite(energy.value(whole)):
                return Stationary(flat, multipliers, missed, length, steps)
            moved = whole
        length = float(np.abs(moved - flat).max())
        flat, multipliers, known = moved, found, True
        missed = float(np.abs(constraints.values(flat)).max(initial=0.0))
        if missed <= goal.missed and length <= goal.step:
            break
    return Stationary(flat, multipliers, missed, length, steps)


def _solver(
    hessian: scipy.sparse.csr_array, jacobian: scipy.sparse.csr_array
) -> Callable[[Array, Array], tuple[Array, Array]]:
    """Return what solves the equations of a step, for both of their right sides."""
    matrix = scipy.sparse.block_array([[hessian, jacobian.T], [jacobian, None]]).tocsc()
    factors = scipy.sparse.linalg.splu(matrix)

    def solve(upper: Array, lower: Array) -> tuple[Array, Array]:
        right = np.concatenate([upper, lower])
        found = factors.solve(right)
        # One round of refinement takes the rounding of the large matrix out of the lengths.
        found += factors.solve(right - matrix @ found)
        return found[: len(upper)], found[len(upper) :]

    return solve


def _moved(
    energy: Energy,
    constraints: Constraints,
    flat: Array,
    step: Array,
    merit: tuple[float, float],
    solve: Callable[[Array, Array], tuple[Array, Array]],
) -> Array | None:
    """Return a layout along a step in which the merit has fallen enough; None if there is none."""
    weight, slope = merit

    def value(layout: Array) -> float:
        return energy.value(layout) + weight * float(np.abs(constraints.values(layout)).sum())

    before, part = value(flat), 1.0
    for _ in range(HALVINGS):
        tried = flat + part * step
        if value(tried) <= before + DESCENT * part * slope:
            return tried
        if part == 1.0:
            # A long step misses the lengths by its square; the same equations take that back.
            missed = constraints.values(tried)
            mended = tried + solve(np.zeros(flat.size), -missed)[0].reshape(-1, 2)
            if value(mended) <= before + DESCENT * slope:
                return mended
        part *= 0.5
    return None
