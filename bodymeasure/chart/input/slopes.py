"""The change of a tape's length when a landmark or a plane that it follows moves.

To first order a chain of points becomes longer by the sum of ``(before - after) . move`` over its
points, with the unit tangents before and after each: a shortest path changes at its ends alone, and
a section of the body where its plane moves the places at which the tape bends.
"""

from collections.abc import Mapping

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart.tapes import Tape

# Points of a tape are at a landmark if they are no farther from it than the nearest one and this
# part of the tape's length. A closed tape begins and ends at one landmark.
AT_LANDMARK = 1e-6
# Where the skin, or a tape's end, is steeper than this against its plane, the linear rule would
# promise changes without bound, as on top of a shoulder.
STEEPEST = 0.2


def tape_slopes(tape: Tape, places: Mapping[str, Array]) -> dict[str, Array]:
    """Return the change of a tape's length with the places of the landmarks that it leads through.

    Parameters
    ----------
    tape : Tape
    places : mapping of str to ndarray, shape (3,)
        The position of each landmark.

    Returns
    -------
    dict of str to ndarray, shape (3,)
        The derivative of the length with respect to each position.
    """
    before, after = _tangents(tape.points)
    near = AT_LANDMARK * float(np.linalg.norm(np.diff(tape.points, axis=0), axis=1).sum())
    found = {}
    for name, place in places.items():
        apart = np.linalg.norm(tape.points - place, axis=1)
        found[name] = (before - after)[apart <= apart.min() + near].sum(axis=0)
    return found


def end_slopes(tape: Tape, places: Mapping[str, Array]) -> dict[str, Array]:
    """Return the change of a tape's length with the landmarks next to which its two ends are."""
    before, after = _tangents(tape.points)
    ends = np.array([0, -1])
    found = {}
    for name, place in places.items():
        end = ends[np.linalg.norm(tape.points[ends] - place, axis=1).argmin()]
        found[name] = before[end] - after[end]
    return found


def plane_slope(tape: Tape, normal: Array, weights: Array | None = None) -> float:
    """Return the change of the length of a tape in a plane, when the plane moves.

    Parameters
    ----------
    tape : Tape
    normal : ndarray, shape (3,)
        The plane's unit normal, along which it moves.
    weights : ndarray, shape (k,), optional
        The movement at each point of the tape, where the plane turns; 1 everywhere if not given.

    Returns
    -------
    float
        The derivative of the length with respect to the movement.
    """
    before, after = _tangents(tape.points)
    steep = tape.normals @ normal
    level = tape.normals - steep[:, None] * normal
    size = np.linalg.norm(level, axis=1)
    # The tape's point stays on the skin: it moves outwards in the plane by as much as the skin does
    # between the two planes. Where the tape stands free it does not bend.
    touching = tape.normals.any(axis=1)
    moved = np.where(touching, -steep / np.maximum(size, STEEPEST) ** 2, 0.0)
    change = ((before - after) * level).sum(axis=1) * moved
    return float(change.sum() if weights is None else change @ weights)


def level_slope(tape: Tape, up: Array) -> Array:
    """Return the change of the length of a tape with the height of the level at which it ends.

    Returns
    -------
    ndarray, shape (3,)
    """
    before, _ = _tangents(tape.points)
    along = float(before[-1] @ up)
    return np.asarray(up / np.copysign(max(abs(along), STEEPEST), along))


def turning(tape: Tape) -> float:
    """Return by how much a tape turns where it touches the skin, in radians."""
    before, after = _tangents(tape.points)
    bend = np.linalg.norm(before - after, axis=1)
    # The ends of an open chain turn nothing.
    touching = np.flatnonzero(tape.normals[1:-1].any(axis=1)) + 1
    return float(bend[touching].sum())


def length(tape: Tape) -> float:
    """Return the length of the chain of points that is drawn of a tape."""
    return float(np.linalg.norm(np.diff(tape.points, axis=0), axis=1).sum())


def _tangents(points: Array) -> tuple[Array, Array]:
    """Return the unit tangents before and after each point; 0 where an open chain has none."""
    steps = np.diff(points, axis=0)
    sizes = np.linalg.norm(steps, axis=1, keepdims=True)
    steps = np.divide(steps, sizes, out=np.zeros_like(steps), where=sizes > 0.0)
    none = np.zeros((1, 3))
    return np.concatenate([none, steps]), np.concatenate([steps, none])
