"""Nodes of a path that move straight in space rather than in (u, v).

A step (du, dv) of a node is a vector in the tangent plane. The node moves to where the surface lies
over its tip, as seen along the normal: a retraction of the second order (P.-A. Absil, R. Mahony, R.
Sepulchre, *Optimization Algorithms on Matrix Manifolds*, 2008, sections 4.1 and 5.5). By
coordinates of this kind, how a surface is parametrized does not matter: in a plane, however
unevenly parametrized, the energy of a path is a quadratic function of them.
"""

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.lengths.equations import dot
from bodymeasure.geodesic.surfaces.protocol import Surface

# The most steps of Newton's method to the place over the tip, and the last one's size in (u, v).
MOST_STEPS, LAST_STEP = 8, 1e-10
# The part of its mean that is added to the metric, which vanishes where the surface is singular.
REGULARIZATION = 1e-12


def moved_along(surface: Surface, unknowns: Array, step: Array) -> Array:
    """Return unknowns after a step, in [0, 1]; both in the order of `ElementPath.unknowns`.

    A coordinate that does not move, or that the step puts on a bound, stays there. Where there is
    no place over the tip nearby, as beside a fold, the step is a straight one in (u, v).
    """
    steps = step.reshape(-1, 2).T
    begin = unknowns.reshape(-1, 2).T
    straight = np.clip(begin + steps, 0.0, 1.0)
    fixed = (steps == 0.0) | (straight == 0.0) | (straight == 1.0)
    place, s_u, s_v = surface.jet(unknowns.reshape(1, -1, 2), 1)[:, :, 0]
    tip = place + s_u * steps[0] + s_v * steps[1]
    there = straight.copy()
    for _ in range(MOST_STEPS):
        jet = surface.jet(there.T[None], 1)[:, :, 0]
        move = _newton((s_u, s_v), jet, tip, fixed)
        there = np.clip(there + move, 0.0, 1.0)
        if np.abs(move).max() <= LAST_STEP:
            break
    off, size = there - begin - steps, np.abs(steps).max(axis=0)
    lost = ~(np.abs(off).max(axis=0) <= size) | ~(np.abs(move).max(axis=0) <= size)
    return np.where(lost, straight, there).T.ravel()


@np.errstate(divide="ignore", invalid="ignore", over="ignore")
def _newton(tangents: tuple[Array, Array], jet: Array, tip: Array, fixed: Bools) -> Array:
    """The step towards the place over the tip, of what is not fixed; zero where there is none."""
    (t_u, t_v), (place, s_u, s_v) = tangents, jet
    miss = place - tip
    a, b = dot(t_u, miss), dot(t_v, miss)
    uu, uv, vu, vv = dot(t_u, s_u), dot(t_u, s_v), dot(t_v, s_u), dot(t_v, s_v)
    both = np.stack([uv * b - vv * a, vu * a - uu * b]) / (uu * vv - uv * vu)
    move = np.where(fixed[::-1], np.stack([-a / uu, -b / vv]), both)
    return np.where(fixed | ~np.isfinite(move), 0.0, move)


def metric_at(surface: Surface, unknowns: Array) -> Array:
    """Return the metric S_u S_u, S_u S_v, S_v S_v at nodes, shape (3, nodes)."""
    _, s_u, s_v = surface.jet(unknowns.reshape(1, -1, 2), 1)[:, :, 0]
    metric = np.stack([dot(s_u, s_u), dot(s_u, s_v), dot(s_v, s_v)])
    metric[::2] += REGULARIZATION * float((metric[0] + metric[2]).mean())
    return metric


def bending(surface: Surface, unknowns: Array, gradient: Array, held: Bools) -> Array:
    """Return by how much the moves' bending in (u, v) changes second derivatives, (3, nodes).

    They are those by u twice, by u and v, and by v twice, of a function with the given gradient.
    Coordinates that are held do not move.
    """
    _, s_u, s_v, *second = surface.jet(unknowns.reshape(1, -1, 2), 2)[:, :, 0]
    uu, uv, vv = metric_at(surface, unknowns)
    (g_u, g_v), (held_u, held_v) = gradient.reshape(-1, 2).T, held.reshape(-1, 2).T
    determinant = np.where(held_u | held_v, 1.0, uu * vv - uv * uv)
    up = np.stack([vv * g_u - uv * g_v, uu * g_v - uv * g_u]) / determinant
    up = np.where([held_v, held_u], np.stack([g_u / uu, g_v / vv]), up)
    up = np.where([held_u, held_v], 0.0, up)
    vector = s_u * up[0] + s_v * up[1]
    return -np.stack([dot(vector, each) for each in second])
