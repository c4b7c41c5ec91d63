"""The feet of perpendiculars from given positions to single patches, by Newton's method."""

from collections.abc import Callable

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.topology.joins import entered, on_sides
from bodymeasure.bezier.power_form import jets
from bodymeasure.native import (
    MOST_DEGREE,
    ClosestSettings,
    PatchSeams,
    closest_in_powers,
    is_compiled,
)

# Newton's steps for one position, halvings included. From a sample beside the closest point four
# are enough; the slow searches are those where the distance is nearly stationary along a whole
# curve, as from the center of a sphere.
MAX_STEPS = 100
# The most seams that a search for one foot may cross: all round a corner of five patches, and back.
MAX_SEAMS = 6
# The longest step in (u, v): a patch's second-order model can be trusted as far as that.
LONGEST_STEP = 0.25
# Part of the metric's determinant: Hessians whose determinant is smaller count as singular, and the
# matrix of Gauss and Newton takes their place.
SINGULAR = 1e-6
# Part of the metric's trace, which keeps that matrix regular where tangents are parallel.
DAMPING = 1e-9
# Part of a squared distance by which a step may seem to lead away near the end, from rounding.
ROUNDING = 1e-12


def descend(
    jets: Callable[[Ints, Array], Array], targets: Array, start: Array, last_step: float
) -> tuple[Array, Array]:
    """Return the closest points of patches, one problem a row, each from a start nearby.

    Parameters
    ----------
    jets : callable
        Takes rows (m,) and their parameters (m, 2), and returns the derivatives up to the second
        there, shape (m, 3, 3, 3) as `bodymeasure.bezier.derivatives`.
    targets : ndarray, shape (k, 3)
    start : ndarray, shape (k, 2)
    last_step : float
        A search ends after a step in (u, v) of this size; the square of it is what Newton's error
        is then.

    Returns
    -------
    x : ndarray, shape (k, 2)
        Parameters in [0, 1].
    squared : ndarray, shape (k,)
        Squared distances.

    Notes
    -----
    Projected Newton after D. Bertsekas, SIAM J. Control Optim. 20 (1982) 221-246: a coordinate on
    its bound which the gradient presses outwards is held; the others take a Newton step (a
    Gauss-Newton step where the Hessian is not positive definite), which is projected. A step is
    evaluated where the next one needs it anyway, and halved if it led away.
    """
    x, trial = start.copy(), start.copy()
    value = np.full(len(x), np.inf)
    step = np.zeros_like(x)
    busy = np.arange(len(x))
    for _ in range(MAX_STEPS):
        s = jets(busy, trial[busy])
        offset = s[:, 0, 0] - targets[busy]
        new = _dot(offset, offset)
        good = new <= value[busy] * (1.0 + ROUNDING)
        here = busy[good]
        x[here], value[here] = trial[here], new[good]
        step[here] = _step(s[good], offset[good], x[here])
        step[busy[~good]] *= 0.5
        trial[busy] = np.clip(x[busy] + step[busy], 0.0, 1.0)
        change = np.abs(trial[busy] - x[busy]).max(axis=1)
        busy = busy[change > last_step]
        if not len(busy):
            break
    # The last steps are too small to lead away.
    offset = jets(np.arange(len(x)), trial)[:, 0, 0] - targets
    return trial, _dot(offset, offset)


def feet_over_seams(
    coefficients: Array,
    seams: PatchSeams,
    targets: Array,
    start: tuple[Ints, Array],
    *,
    last_step: float,
    tied: float,
    most_seams: int = MAX_SEAMS,
) -> tuple[Ints, Array, Array]:
    """Return the closest points of patches as coefficients of powers, and beyond their seams.

    Parameters
    ----------
    coefficients : ndarray, shape (patches, m + 1, m + 1, 3 or 4)
        From `bodymeasure.bezier.power_form`.
    seams : PatchSeams
        A search that ends on a seam goes on beyond it, where that leads closer.
    targets : ndarray, shape (k, 3)
    start : tuple of ndarray, of shapes (k,) and (k, 2)
        The patches, and a place nearby on each.
    last_step : float
        As in `descend`.
    tied : float
        Two squared distances that differ by less are those of one point on a seam.
    most_seams : int
        The most seams that a search may cross.

    Returns
    -------
    patch : ndarray of int, shape (k,)
    x : ndarray, shape (k, 2)
    squared : ndarray, shape (k,)
    """
    side, coordinates = coefficients.shape[2:]
    if is_compiled() and coordinates == 3 and side <= MOST_DEGREE + 1:
        limits = LONGEST_STEP, SINGULAR, DAMPING, ROUNDING
        settings = ClosestSettings(MAX_STEPS, most_seams, last_step, *limits, tied)
        return closest_in_powers(coefficients, seams, targets, start, settings)

    def descended(patch: Ints, targets: Array, x: Array) -> tuple[Array, Array]:
        return descend(lambda rows, at: jets(coefficients[patch[rows]], at), targets, x, last_step)

    patch = start[0].copy()
    x, squared = descended(patch, targets, start[1])
    pending = np.arange(len(patch))
    for _ in range(most_seams):
        row, side = on_sides(x[pending])
        row = pending[row]
        joined = seams.to_patch[patch[row], side] >= 0
        row, side = row[joined], side[joined]
        if not len(row):
            break
        at = patch[row], side
        to_patch, flipped = seams.to_patch[at], seams.flipped[at]
        begin = entered(x[row], side, seams.to_side[at], flipped)
        there, closer = descended(to_patch, targets[row], begin)
        # At a corner two sides lead on; the closer one is written last, and stays.
        order = np.argsort(-closer)
        better = order[closer[order] < squared[row[order]] - tied]
        found = row[better]
        patch[found], x[found], squared[found] = to_patch[better], there[better], closer[better]
        pending = np.unique(found)
    return patch, x, squared


def _step(s: Array, offset: Array, x: Array) -> Array:
    """Newton's step of the coordinates that are free, shape (k, 2), capped.

    Where the Hessian is not positive definite, it is the step of Gauss and Newton.
    """
    su, sv = s[:, 1, 0], s[:, 0, 1]
    e, f, g = _dot(su, su), _dot(su, sv), _dot(sv, sv)
    a, c = e + _dot(s[:, 2, 0], offset), g + _dot(s[:, 0, 2], offset)
    b = f + _dot(s[:, 1, 1], offset)
    convex = (a > 0.0) & (a * c - b * b > SINGULAR * e * g)
    damping = DAMPING * (e + g) + np.finfo(np.float64).tiny
    a, c = np.where(convex, a, e + damping), np.where(convex, c, g + damping)
    b = np.where(convex, b, f)

    down = -np.stack([_dot(su, offset), _dot(sv, offset)], axis=1)
    held = ((x <= 0.0) & (down < 0.0)) | ((x >= 1.0) & (down > 0.0))
    b = np.where(held.any(axis=1), 0.0, b)
    p, q = np.where(held, 0.0, down).T
    determinant = a * c - b * b
    step = np.stack([c * p - b * q, a * q - b * p], axis=1) / determinant[:, None]
    longest = np.abs(step).max(axis=1, keepdims=True)
    return np.asarray(step * np.minimum(1.0, LONGEST_STEP / np.maximum(longest, LONGEST_STEP)))


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("kc,kc->k", a, b))
