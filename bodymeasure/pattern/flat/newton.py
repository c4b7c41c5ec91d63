"""Newton's method for the least energy under constraints."""

from dataclasses import dataclass

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.pattern.flat.constraints import Constraints
from bodymeasure.pattern.flat.energy import Energy
from bodymeasure.pattern.flat.equations import StepEquations

# Parts of a Newton step that are tried; less than the last one leads nowhere.
HALVINGS = 30
# The part of the promised descent of the merit that a step has to keep.
DESCENT = 1e-4
# The factor by which the merit's weight of constraints exceeds the largest multiplier.
HEAVIER = 1.5
# A step of which less than this part leads down is sought anew, with a shift.
SHORT = 0.2
# The least shift of the curvature, whose own eigenvalues are about 1; by what a shift grows while
# it does not serve, and what is left of it for the next step. It ends with `MOST_SHIFT`.
LEAST_SHIFT, MORE, LESS, MOST_SHIFT = 1e-3, 8.0, 0.25, 1e6
# A step at the end, as a part of the goal's, at which rounding hides whether it leads down.
HIDDEN = 1e3


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


@dataclass(frozen=True, eq=False)
class _Step:
    """A step that was taken, and the multipliers and the shift with which it was found."""

    flat: Array
    multipliers: Array
    shift: float


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
    Each step solves the equations of the Lagrangian. Sides under pressure buckle, so that on the
    way the piece passes saddles, from which Newton's method would not lead away. There the
    curvature is shifted by as little as makes it positive along the constraints, and also where
    only a short part of a step leads down.
    """
    known = multipliers is not None
    if multipliers is None:
        multipliers = np.zeros(constraints.count)
    missed, length, shift, steps = np.inf, np.inf, 0.0, 0
    for steps in range(1, goal.steps + 1):
        curved = energy.curvature(flat, full=known)
        if known:
            curved = curved + constraints.curvature(multipliers, flat)
        taken = _taken(energy, constraints, (flat, curved.tocsr()), shift, goal)
        if taken is None:
            return Stationary(flat, multipliers, missed, length, steps)
        length = float(np.abs(taken.flat - flat).max())
        flat, multipliers, known = taken.flat, taken.multipliers, True
        shift = LESS * taken.shift if LESS * taken.shift >= LEAST_SHIFT else 0.0
        missed = float(np.abs(constraints.values(flat)).max(initial=0.0))
        if missed <= goal.missed and length <= goal.step:
            break
    return Stationary(flat, multipliers, missed, length, steps)


def _taken(
    energy: Energy,
    constraints: Constraints,
    model: tuple[Array, scipy.sparse.csr_array],
    shift: float,
    goal: Goal,
) -> _Step | None:
    """Return a step from a layout with its curvature, shifted as it has to be; None if none is."""
    flat, curved = model
    gradient = energy.gradient(flat)
    values, jacobian = constraints.values(flat), constraints.jacobian(flat)
    unit = scipy.sparse.eye_array(flat.size).tocsr()
    best: _Step | None = None
    while shift <= MOST_SHIFT:
        equations = StepEquations(curved + shift * unit if shift else curved, jacobian)
        if equations.lead_down:
            step, multipliers = equations.solved(-gradient, -values)
            weight = HEAVIER * float(np.abs(multipliers).max(initial=0.0))
            slope = float(gradient @ step) - weight * float(np.abs(values).sum())
            way = step.reshape(-1, 2)
            moved, part = _moved(energy, constraints, flat, way, (weight, slope), equations)
            if part >= SHORT:
                return _Step(moved, multipliers, shift)
            if np.abs(step).max() <= HIDDEN * goal.step:
                # Near the end rounding hides the descent; a whole step that flips nothing is right.
                whole = flat + way
                if np.isfinite(energy.value(whole)):
                    return _Step(whole, multipliers, shift)
            if part > 0.0 and best is None:
                best = _Step(moved, multipliers, shift)
        shift = max(MORE * shift, LEAST_SHIFT)
    return best


def _moved(
    energy: Energy,
    constraints: Constraints,
    flat: Array,
    step: Array,
    merit: tuple[float, float],
    equations: StepEquations,
) -> tuple[Array, float]:
    """Return a layout along a step in which the merit has fallen enough, and the part of it."""
    weight, slope = merit

    def value(layout: Array) -> float:
        return energy.value(layout) + weight * float(np.abs(constraints.values(layout)).sum())

    before, part = value(flat), 1.0
    for _ in range(HALVINGS):
        tried = flat + part * step
        if value(tried) <= before + DESCENT * part * slope:
            return tried, part
        if part == 1.0:
            # A long step misses the lengths by its square; the same equations take that back.
            missed = constraints.values(tried)
            mended = tried + equations.solved(np.zeros(flat.size), -missed)[0].reshape(-1, 2)
            if value(mended) <= before + DESCENT * slope:
                return mended, part
        part *= 0.5
    return flat, 0.0
