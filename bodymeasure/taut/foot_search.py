"""Closest points of single patches, by Newton's method from starts nearby."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bodymeasure.taut.jets import jets

_Array = NDArray[np.float64]

# Newton's steps for a foot on one patch. From a sample beside it, four are enough.
MAX_STEPS = 20
# In (u, v): after a step of this size, what is left of Newton's error is its square.
STEP_TOLERANCE = 1e-6
# Longest step in (u, v): as far as a patch's second-order model can be trusted.
LONGEST_STEP = 0.25
# Of the metric's determinant: Hessians below count as singular, and Gauss-Newton's matrix serves.
SINGULAR = 1e-6
# Of the metric's trace: keeps that matrix regular where tangents are parallel.
DAMPING = 1e-9


def descend(coefficients: _Array, targets: _Array, start: _Array) -> tuple[_Array, _Array]:
    """Newton's method for the closest point in the box; parameters (k, 2), squared distances (k,).

    Notes
    -----
    As `bodymeasure.atlas.closest`, but from starts so near that steps need no halving: Newton's
    step where the Hessian is positive definite, else Gauss-Newton's.
    """
    x = start.copy()
    busy = np.arange(len(x))
    for _ in range(MAX_STEPS):
        step = _step(coefficients[busy], targets[busy], x[busy])
        longest = np.abs(step).max(axis=1, keepdims=True)
        step *= np.minimum(1.0, LONGEST_STEP / np.maximum(longest, LONGEST_STEP))
        new = np.clip(x[busy] + step, 0.0, 1.0)
        change = np.abs(new - x[busy]).max(axis=1)
        x[busy] = new
        busy = busy[change > STEP_TOLERANCE]
        if not len(busy):
            break
    return x, np.asarray(((jets(coefficients, x)[:, 0, 0] - targets) ** 2).sum(axis=1))


def _step(coefficients: _Array, targets: _Array, x: _Array) -> _Array:
    """Newton step of the coordinates that are free, shape (k, 2)."""
    s = jets(coefficients, x)
    offset = s[:, 0, 0] - targets
    su, sv = s[:, 1, 0], s[:, 0, 1]
    e, f, g = _dot(su, su), _dot(su, sv), _dot(sv, sv)
    a, b, c = (
        e + _dot(s[:, 2, 0], offset),
        f + _dot(s[:, 1, 1], offset),
        g + _dot(s[:, 0, 2], offset),
    )
    p, q = -_dot(su, offset), -_dot(sv, offset)
    convex = (a > 0.0) & (a * c - b * b > SINGULAR * e * g)
    damping = DAMPING * (e + g) + np.finfo(np.float64).tiny
    a, b, c = (
        np.where(convex, a, e + damping),
        np.where(convex, b, f),
        np.where(convex, c, g + damping),
    )
    held_u = ((x[:, 0] <= 0.0) & (p < 0.0)) | ((x[:, 0] >= 1.0) & (p > 0.0))
    held_v = ((x[:, 1] <= 0.0) & (q < 0.0)) | ((x[:, 1] >= 1.0) & (q > 0.0))
    b = np.where(held_u | held_v, 0.0, b)
    p, q = np.where(held_u, 0.0, p), np.where(held_v, 0.0, q)
    determinant = a * c - b * b
    return np.asarray(np.stack([c * p - b * q, a * q - b * p], axis=1) / determinant[:, None])


def _dot(a: _Array, b: _Array) -> _Array:
    return np.asarray(np.einsum("kc,kc->k", a, b))
