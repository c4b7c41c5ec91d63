"""The path of least energy, made of elements, in the box [0, 1]^2.

Newton's method in u and v comes to rest within some ten steps on most patches. On a strip a
thousand times as long as it is wide, or where lines of control points crowd, the energy has a
valley that is narrow and bent, and it creeps. Then nodes move along the surface (`retraction`), the
damping is that of the surface's metric, and where the energy is not convex the part of its Hessian
is taken that always is (Gauss-Newton).
"""

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.elements.energy import PathEnergy
from bodymeasure.geodesic.elements.path import ElementPath
from bodymeasure.geodesic.elements.retraction import bending, metric_at, moved_along
from bodymeasure.geodesic.lengths.functionals import energy_of_a_flat_surface
from bodymeasure.geodesic.numerics.banded import BoxModels
from bodymeasure.geodesic.numerics.box_newton import (
    FIRST,
    LEAST,
    MOST,
    REST,
    REST_DAMPING,
    ROUNDING,
    BoxMinimum,
    SecondOrder,
    minimize_in_box,
)
from bodymeasure.geodesic.surfaces.protocol import Surface

# The most steps in u and v; most paths need fewer.
STRAIGHT_STEPS = 15
# Damping is multiplied by at least this after a good step, and by this after the first of some bad
# ones; by the double after each more (H. Nielsen, report IMM-REP-1999-05, Technical University of
# Denmark).
LESS, MORE = 0.1, 4.0


def least_energy(
    surface: Surface, path: ElementPath, idle: Bools, most_steps: int
) -> tuple[ElementPath, BoxMinimum]:
    """Return the path of least energy near a path.

    Parameters
    ----------
    surface : Surface
        The surface of one problem.
    path : ElementPath
    idle : ndarray of bool, shape (unknowns,)
        Unknowns that stay what they are.
    most_steps : int
        The most steps of Newton's method.
    """
    whole = PathEnergy(surface, path)
    straight = min(STRAIGHT_STEPS, most_steps)
    minimum = minimize_in_box(whole.expanded, path.unknowns, idle, straight)
    if not minimum.converged and np.isfinite(minimum.value):
        minimum = _minimize_along(whole, minimum, idle, most_steps)
    return path.moved(minimum.unknowns), minimum


def _minimize_along(
    whole: PathEnergy, start: BoxMinimum, idle: Bools, most_steps: int
) -> BoxMinimum:
    """Find a minimum by nodes that move along the surface, as `minimize_in_box` does."""
    place, iterations = start.unknowns, start.iterations
    here, damping, more, converged = whole.expanded(place), FIRST, MORE, False
    model = _model(whole, here, place, idle)
    while iterations < most_steps and not converged and damping <= MOST:
        iterations += 1
        damped = _damped(whole, model, damping)
        (step,), (definite,) = damped.steps()
        newton = bool(definite)
        if not newton:
            flat = whole.expanded(place, energy_of_a_flat_surface)
            damped = _damped(whole, model._replace(bands=flat.bands[None]), max(damping, LEAST))
            (step,), (definite,) = damped.steps()
        decrease = float(damped.decrease(step[None])[0]) if definite else np.inf
        trial = moved_along(whole.surface, place, step) if definite else place
        there = whole.expanded(trial) if definite else here
        small = decrease <= REST * here.value
        if there.value < here.value or (small and there.value <= here.value * (1.0 + ROUNDING)):
            converged = bool(small and newton and damping <= REST_DAMPING)
            gain = (here.value - there.value) / max(decrease, ROUNDING * here.value)
            damping *= LESS if gain >= 1.0 else max(LESS, 1.0 - (2.0 * gain - 1.0) ** 3)
            damping, more = 0.0 if damping < LEAST else damping, MORE
            place, here = trial, there
            model = _model(whole, here, place, idle)
        else:
            damping, more = max(damping * more, FIRST), 2.0 * more
    return BoxMinimum.at(place, here, idle, converged=converged, iterations=iterations)


def _model(whole: PathEnergy, here: SecondOrder, place: Array, idle: Bools) -> BoxModels:
    """The quadratic model of the energy by moves along the surface."""
    model = BoxModels(here.bands[None], here.gradient[None], place[None], idle[None])
    change = bending(whole.surface, place, here.gradient, model.pressed()[0] | idle)
    bands = here.bands.copy()
    bands[0, ::2] += change[0]
    bands[1, ::2] += change[1]
    bands[0, 1::2] += change[2]
    return model._replace(bands=bands[None])


def _damped(whole: PathEnergy, model: BoxModels, damping: float) -> BoxModels:
    """The model with a multiple of the metric, and of its own diagonal if damping is strong.

    The metric alone does not damp what moves a node along a collapsed edge, or across a fold.
    """
    metric = metric_at(whole.surface, model.place[0]) * whole.stiffness
    bands = model.bands.copy()
    bands[0, 0] += damping * min(damping, 1.0) * np.abs(bands[0, 0])
    bands[0, 0, ::2] += damping * metric[0]
    bands[0, 1, ::2] += damping * metric[1]
    bands[0, 0, 1::2] += damping * metric[2]
    return model._replace(bands=bands)
