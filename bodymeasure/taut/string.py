"""A string drawn taut over the skin: nodes, springs between them, and which nodes touch."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from bodymeasure.taut.skin import Feet, Skin

_Array = NDArray[np.float64]
_Flags = NDArray[np.bool_]

# Rounds of feet and springs. Newton-like ones take 4 to 8; strings that slide sideways take more.
MAX_ROUNDS = 40
# Changes of the set of touching nodes in one round: they settle in 2 to 10.
MAX_EXCHANGES = 25
# Of the length: after a last step so small, what is left, and the length's error, are its square.
STEP_TOLERANCE = 1e-6
# Of the length: once it changes by less for two rounds, what still moves costs nothing.
LENGTH_TOLERANCE = 1e-11
# Of the length: farther inside the skin, or off it for one that touches, a node is not at rest.
DEPTH_TOLERANCE = 1e-10
# Of the length: the farthest that a node may go in one round: it must not jump through a limb.
LONGEST_STEP = 0.06
# Of the length, and of a node's last step: how far from its foot the seam of a valley may be to be
# the node's second wall. It shrinks with the steps, since far from the seam the wall is only rough.
FIRST_REACH, LEAST_REACH, REACH_STEPS = 0.02, 1e-8, 2.0
# Sine of the angle between walls that count as one.
PARALLEL = 1e-6


class String(NamedTuple):
    """A string at rest, or as near to it as the rounds led.

    Parameters
    ----------
    nodes : ndarray, shape (n + 1, 3)
        Its ends are fixed.
    weights : ndarray, shape (n,)
        Rest lengths of the springs, up to a factor: at rest, segments are proportional to them.
    feet : Feet
        Of the n - 1 inner nodes.
    touching : ndarray of bool, shape (n - 1,)
        Which inner nodes press on the skin.
    pressure : ndarray, shape (n - 1,)
        With what force; 0 where they don't.
    settled : bool
    """

    nodes: _Array
    weights: _Array
    feet: Feet
    touching: _Flags
    pressure: _Array
    settled: bool


def polygon_length(nodes: _Array) -> float:
    """Sum of the lengths of the segments."""
    return float(np.linalg.norm(np.diff(nodes, axis=0), axis=1).sum())


class _Walls(NamedTuple):
    """Half-spaces that each inner node is kept in: one at its foot, a second one in valleys.

    Normals (k, 2, 3), gaps (k, 2), their second derivatives (k, 2, 3, 3), and which are there.
    """

    normal: _Array
    gap: _Array
    bend: _Array
    there: _Flags


def relax(skin: Skin, nodes: _Array, weights: _Array, pressure: _Array | None = None) -> String:
    """Let a string slide to rest outside the skin.

    Parameters
    ----------
    skin : Skin
    nodes : ndarray, shape (n + 1, 3)
    weights : ndarray, shape (n,)
    pressure : ndarray, shape (n - 1,), optional
        A guess of the forces on the inner nodes that touch; 0 for the others. Without one, those
        that start on the skin are taken to touch.

    Notes
    -----
    Minimizes half the sum of squared segments over weights, each inner node kept on the outer side
    of the tangent plane at its foot; in the valley between two patches, of both patches' planes.
    The quadratic problem of each round is solved by a primal-dual active set (M. Hintermueller,
    K. Ito and K. Kunisch, SIAM J. Optim. 13 (2002) 865-888). The bend of the skin under pressure
    enters the matrix, as Newton's method asks, where that stays positive definite.
    """
    nodes = nodes.copy()
    length = polygon_length(nodes)
    feet = skin.feet(nodes[1:-1])
    walls = _walls(skin, nodes[1:-1], feet, np.full(len(nodes) - 2, FIRST_REACH * length))
    load, held = np.zeros((len(nodes) - 2, 2)), np.zeros((len(nodes) - 2, 2), dtype=np.bool_)
    if pressure is None:
        held[:, 0] = feet.gap <= DEPTH_TOLERANCE * length
    else:
        load[:, 0], held[:, 0] = pressure, pressure > 0.0
    quiet = 0
    settled = False
    for _ in range(1, MAX_ROUNDS + 1):
        step, load, held = _quadratic(nodes, weights, walls, load, held)
        moved = np.linalg.norm(step, axis=1)
        longest = float(moved.max())
        nodes[1:-1] += min(1.0, LONGEST_STEP * length / max(longest, 1e-300)) * step
        feet = skin.feet(nodes[1:-1])
        reach = np.clip(REACH_STEPS * moved, LEAST_REACH * length, FIRST_REACH * length)
        walls = _walls(skin, nodes[1:-1], feet, reach)
        off = np.where(held.any(axis=1), np.abs(feet.gap), -feet.gap)
        before, length = length, polygon_length(nodes)
        quiet = quiet + 1 if abs(length - before) <= LENGTH_TOLERANCE * length else 0
        if off.max() <= DEPTH_TOLERANCE * length and (
            longest <= STEP_TOLERANCE * length or quiet >= 2
        ):
            settled = True
            break
    touching = np.asarray(held.any(axis=1))
    return String(nodes, weights, feet, touching, load.sum(axis=1), settled)


def _walls(skin: Skin, positions: _Array, feet: Feet, reach: _Array) -> _Walls:
    count = len(positions)
    normal = np.repeat(feet.normal[:, None], 2, axis=1)
    gap = np.stack([feet.gap, np.full(count, np.inf)], axis=1)
    bend = np.stack([feet.bend, np.zeros_like(feet.bend)], axis=1)
    row, second = skin.creases(positions, feet, reach)
    normal[row, 1], gap[row, 1], bend[row, 1] = second.normal, second.gap, second.bend
    there = np.ones((count, 2), dtype=np.bool_)
    parallel = np.linalg.norm(normal[:, 1] - normal[:, 0], axis=1) < PARALLEL
    there[:, 1] = np.isfinite(gap[:, 1]) & ~parallel
    gap[~there] = 0.0
    return _Walls(normal, gap, bend, there)


def _quadratic(
    nodes: _Array, weights: _Array, walls: _Walls, pressure: _Array, held: _Flags
) -> tuple[_Array, _Array, _Flags]:
    """Steps (k, 3), pressures and walls touched (k, 2) of one round."""
    springs = 1.0 / weights
    force = np.diff(springs[:, None] * np.diff(nodes, axis=0), axis=0)
    bend = np.einsum("kw,kwij->kij", np.where(walls.there, pressure, 0.0), walls.bend)
    for curvature in (bend, np.zeros_like(bend)):
        found = _active_set(springs, force, walls, curvature, held & walls.there)
        if found is not None:
            return found
    raise AssertionError("springs alone are positive definite")


def _active_set(
    springs: _Array, force: _Array, walls: _Walls, bend: _Array, held: _Flags
) -> tuple[_Array, _Array, _Flags] | None:
    stiff = (springs[:-1] + springs[1:])[:, None, None] * np.eye(3) - bend
    seen: list[bytes] = []
    for _ in range(MAX_EXCHANGES):
        frames, fixed, prescribed = _frames(walls, held)
        diagonal = frames.swapaxes(1, 2) @ stiff @ frames
        coupling = -springs[1:-1, None, None] * (frames[:-1].swapaxes(1, 2) @ frames[1:])
        solved = _solve(
            diagonal, coupling, np.einsum("kij,ki->kj", frames, force), fixed, prescribed
        )
        if solved is None:
            return None
        step = np.einsum("kij,kj->ki", frames, solved[0])
        load = _loads(walls, held, np.einsum("kij,kj->ki", frames, solved[1]), frames)
        below = np.einsum("kwc,kc->kw", walls.normal, step) < -walls.gap
        holds = np.where(held, load > 0.0, below & walls.there)
        if (holds == held).all() or holds.tobytes() in seen:
            break
        seen.append(held.tobytes())
        held = holds
    return step, np.where(held, np.maximum(load, 0.0), 0.0), held


def _frames(walls: _Walls, held: _Flags) -> tuple[_Array, _Flags, _Array]:
    """Orthonormal frames (k, 3, 3), which of their coordinates are fixed, and at what.

    The first column is the normal of the wall held; of two, the second lies in their plane.
    """
    only_second = held[:, 1] & ~held[:, 0]
    both = held.all(axis=1)
    first = np.where(only_second[:, None], walls.normal[:, 1], walls.normal[:, 0])
    frames = _completed(first)
    fixed = np.zeros((len(held), 3), dtype=np.bool_)
    fixed[:, 0] = held.any(axis=1)
    prescribed = np.zeros((len(held), 3))
    prescribed[:, 0] = -np.where(only_second, walls.gap[:, 1], walls.gap[:, 0])
    row = np.flatnonzero(both)
    if len(row):
        one, two = walls.normal[row, 0], walls.normal[row, 1]
        cosine = np.einsum("kc,kc->k", one, two)
        across = two - cosine[:, None] * one
        sine = np.linalg.norm(across, axis=1)
        across /= sine[:, None]
        frames[row, :, 1], frames[row, :, 2] = across, np.cross(one, across)
        fixed[row, 1] = True
        prescribed[row, 1] = (-walls.gap[row, 1] - cosine * prescribed[row, 0]) / sine
    prescribed[~fixed] = 0.0
    return frames, fixed, prescribed


def _loads(walls: _Walls, held: _Flags, reaction: _Array, frames: _Array) -> _Array:
    """The walls' pressures (k, 2) whose sum is the reaction (k, 3)."""
    load = np.einsum("kwc,kc->kw", walls.normal, reaction)
    row = np.flatnonzero(held.all(axis=1))
    if len(row):
        across = frames[row, :, 1]
        sine = np.einsum("kc,kc->k", across, walls.normal[row, 1])
        cosine = np.einsum("kc,kc->k", walls.normal[row, 0], walls.normal[row, 1])
        second = np.einsum("kc,kc->k", across, reaction[row]) / sine
        load[row, 0] -= cosine * second
        load[row, 1] = second
    return np.asarray(load)


def _solve(
    diagonal: _Array, coupling: _Array, force: _Array, fixed: _Flags, prescribed: _Array
) -> tuple[_Array, _Array] | None:
    """Equilibrium with some coordinates prescribed.

    Returns coordinates (k, 3) and reactions (k, 3), or None if the matrix is not positive definite.
    """
    count = len(diagonal)
    right = force - _apply(diagonal, coupling, prescribed)
    right[fixed] = 0.0
    free = (~fixed).astype(np.float64)
    own = diagonal * (free[:, :, None] * free[:, None, :])
    row, axis = np.nonzero(fixed)
    own[row, axis, axis] = 1.0
    next_ = coupling * (free[:-1, :, None] * free[1:, None, :])
    # Lower bands: row r of column c stands at (r - c, c).
    bands = np.zeros((6, count, 3))
    for column in range(3):
        for i in range(column, 3):
            bands[i - column, :, column] = own[:, i, column]
        for i in range(3):
            bands[3 + i - column, :-1, column] = next_[:, column, i]
    try:
        z = scipy.linalg.solveh_banded(
            bands.reshape(6, -1), right.ravel(), lower=True, check_finite=False
        ).reshape(-1, 3)
    except np.linalg.LinAlgError:
        return None
    z += prescribed
    return z, _apply(diagonal, coupling, z) - force


def _apply(diagonal: _Array, coupling: _Array, z: _Array) -> _Array:
    result = np.einsum("kij,kj->ki", diagonal, z)
    result[:-1] += np.einsum("kij,kj->ki", coupling, z[1:])
    result[1:] += np.einsum("kji,kj->ki", coupling, z[:-1])
    return np.asarray(result)


def _completed(normal: _Array) -> _Array:
    """Orthonormal frames whose first column is the normal, shape (k, 3, 3)."""
    sign = np.where(normal[:, 2] >= 0.0, 1.0, -1.0)
    # T. Duff et al., Building an orthonormal basis, revisited, JCGT 6 (2017).
    a = -1.0 / (sign + normal[:, 2])
    b = normal[:, 0] * normal[:, 1] * a
    first = np.stack([1.0 + sign * normal[:, 0] ** 2 * a, sign * b, -sign * normal[:, 0]], axis=1)
    second = np.stack([b, sign + normal[:, 1] ** 2 * a, -normal[:, 1]], axis=1)
    return np.stack([normal, first, second], axis=2)
