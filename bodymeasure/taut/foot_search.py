"""Closest points of single patches, by Newton's method from starts nearby."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier.power_form import jets

# Newton's steps for a foot on one patch, halvings included. From a sample beside it, four serve.
MAX_STEPS = 40
# In (u, v): after a step of this size, what is left of Newton's error is its square.
STEP_TOLERANCE = 1e-6
# Longest step in (u, v): as far as a patch's second-order model can be trusted.
LONGEST_STEP = 0.25
# Of the metric's determinant: Hessians below count as singular, and Gauss-Newton's matrix serves.
SINGULAR = 1e-6
# Of the metric's trace: keeps that matrix regular where tangents are parallel.
DAMPING = 1e-9
# Of a squared distance: near the end, steps may seem to lead away by so much.
ROUNDING = 1e-12


def descend(coefficients: Array, targets: Array, start: Array) -> tuple[Array, Array]:
    """The closest points of patches, each from a start nearby.

    Parameters
    ----------
    coefficients : ndarray, shape (k, m + 1, m + 1, 3 or 4)
        See `bodymeasure.bezier.power_form`.
    targets : ndarray, shape (k, 3)
    start : ndarray, shape (k, 2)

    Returns
    -------
    x : ndarray, shape (k, 2)
        In [0, 1].
    squared : ndarray, shape (k,)
        Squared distances.

    Notes ----- Newton's method in the box as in `bodymeasure.atlas.queries.closest`, tuned for
    starts that need no care: a step is evaluated where the next one needs it anyway, and halved if
    it led away.
    """
    x, trial = start.copy(), start.copy()
    value = np.full(len(x), np.inf)
    step = np.zeros_like(x)
    busy = np.arange(len(x))
    for _ in range(MAX_STEPS):
        s = jets(coefficients[busy], trial[busy])
        offset = s[:, 0, 0] - targets[busy]
        new = _dot(offset, offset)
        good = new <= value[busy] * (1.0 + ROUNDING)
        here = busy[good]
        x[here], value[here] = trial[here], new[good]
        step[here] = _step(s[good], offset[good], x[here])
        step[busy[~good]] *= 0.5
        trial[busy] = np.clip(x[busy] + step[busy], 0.0, 1.0)
        change = np.abs(trial[busy] - x[busy]).max(axis=1)
        busy = busy[change > STEP_TOLERANCE]
        if not len(busy):
            break
    # The last steps are too small to lead away.
    offset = jets(coefficients, trial)[:, 0, 0] - targets
    return trial, _dot(offset, offset)


def _step(s: Array, offset: Array, x: Array) -> Array:
    """Newton's step of the coordinates that are free, shape (k, 2), capped.

    Gauss-Newton's where the Hessian is not positive definite.
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
