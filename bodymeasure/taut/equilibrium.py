"""The quadratic problem of a string between tangent planes: which of them hold it, and where."""

from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools
from bodymeasure.native import StringForces, is_compiled, string_equilibrium
from bodymeasure.taut.ridges import RidgeFeet
from bodymeasure.taut.skin import Feet, Skin
from bodymeasure.taut.valleys import feet_over_valleys

# The most changes of the set of walls that hold the string; it settles in 2 to 10.
MAX_EXCHANGES = 25
# Walls are one if the sine of the angle between them is below this.
PARALLEL = 1e-6


class Walls(NamedTuple):
    """Half-spaces that each inner node is kept in: one at its foot, and a second one in valleys.

    They have normals (k, 2, 3), gaps (k, 2), second derivatives of the gaps (k, 2, 3, 3), and flags
    (k, 2) of which half-spaces there are.
    """

    normal: Array
    gap: Array
    bend: Array
    there: Bools


def walls_of(skin: Skin, positions: Array, feet: Feet, reach: Array) -> Walls:
    """Return the tangent planes at the feet of positions (k, 3), and over valleys in reach (k,)."""
    count = len(positions)
    normal = np.repeat(feet.normal[:, None], 2, axis=1)
    gap = np.stack([feet.gap, np.full(count, np.inf)], axis=1)
    bend = np.stack([feet.bend, np.zeros_like(feet.bend)], axis=1)
    row, second = feet_over_valleys(skin, positions, feet, reach)
    normal[row, 1], gap[row, 1], bend[row, 1] = second.normal, second.gap, second.bend
    there = np.ones((count, 2), dtype=np.bool_)
    parallel = np.linalg.norm(normal[:, 1] - normal[:, 0], axis=1) < PARALLEL
    there[:, 1] = np.isfinite(gap[:, 1]) & ~parallel
    gap[~there] = 0.0
    return Walls(normal, gap, bend, there)


def with_ridges(walls: Walls, ridges: RidgeFeet) -> Walls:
    """Return the walls with the planes of both patches for pinned nodes, in place."""
    row = ridges.row
    for number, feet in enumerate((ridges.first, ridges.second)):
        walls.normal[row, number], walls.bend[row, number] = feet.normal, feet.bend
        walls.gap[row, number] = 0.0
    sine = np.linalg.norm(np.cross(ridges.first.normal, ridges.second.normal), axis=1)
    walls.there[row, 1] = sine > PARALLEL
    return walls


def equilibrium(
    nodes: Array, weights: Array, walls: Walls, pressure: Array, held: Bools
) -> tuple[Array, Array, Bools]:
    """Return the steps (k, 3), and the pressures and walls touched (k, 2), of one round."""
    springs = 1.0 / weights
    force = np.diff(springs[:, None] * np.diff(nodes, axis=0), axis=0)
    bend = np.einsum("kw,kwij->kij", np.where(walls.there, pressure, 0.0), walls.bend)
    for curvature in (bend, np.zeros_like(bend)):
        found = _active_set(springs, force, walls, curvature, held & walls.there)
        if found is not None:
            return found
    raise AssertionError("springs alone are positive definite")


def _active_set(
    springs: Array, force: Array, walls: Walls, bend: Array, held: Bools
) -> tuple[Array, Array, Bools] | None:
    if is_compiled():
        forces = StringForces(springs, force, walls.normal, walls.gap, bend)
        return string_equilibrium(forces, walls.there, held, MAX_EXCHANGES)
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


def _frames(walls: Walls, held: Bools) -> tuple[Array, Bools, Array]:
    """Return orthonormal frames (k, 3, 3), which of their coordinates are fixed, and at what.

    The first column is the normal of the wall that holds the node; if two do, the second column
    lies in the plane of both normals.
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


def _loads(walls: Walls, held: Bools, reaction: Array, frames: Array) -> Array:
    """Return the walls' pressures (k, 2) whose sum is the reaction (k, 3)."""
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
    diagonal: Array, coupling: Array, force: Array, fixed: Bools, prescribed: Array
) -> tuple[Array, Array] | None:
    """Solve for the equilibrium with some coordinates prescribed.

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


def _apply(diagonal: Array, coupling: Array, z: Array) -> Array:
    result = np.einsum("kij,kj->ki", diagonal, z)
    result[:-1] += np.einsum("kij,kj->ki", coupling, z[1:])
    result[1:] += np.einsum("kji,kj->ki", coupling, z[:-1])
    return np.asarray(result)


def _completed(normal: Array) -> Array:
    """Return orthonormal frames whose first column is the normal, shape (k, 3, 3)."""
    sign = np.where(normal[:, 2] >= 0.0, 1.0, -1.0)
    # T. Duff et al., Building an orthonormal basis, revisited, JCGT 6 (2017).
    a = -1.0 / (sign + normal[:, 2])
    b = normal[:, 0] * normal[:, 1] * a
    first = np.stack([1.0 + sign * normal[:, 0] ** 2 * a, sign * b, -sign * normal[:, 0]], axis=1)
    second = np.stack([b, sign + normal[:, 1] ** 2 * a, -normal[:, 1]], axis=1)
    return np.stack([normal, first, second], axis=2)
