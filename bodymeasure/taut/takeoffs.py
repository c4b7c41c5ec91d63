"""The places at which a string leaves the skin, which lie between its nodes.

A string of points leaves the skin at one of these, and turns there; the tape leaves it
tangentially, up to one and a half segments away. Near the takeoff the skin is taken to be a circle
of its curvature in the direction of the string: from a node A that touches, one or two segments
before the last that does, to the node P at which the string touches again, the tape runs over the
arc and along the tangent through P, whose lengths are known.
"""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.taut.skin import Feet

# Circles that are larger than this multiple of the way from A to P are straight.
STRAIGHT = 1e5


class Takeoffs(NamedTuple):
    """Takeoffs: from node `base`, over `last` that is the last to touch, to node `far` beyond.

    Between `last` and `far`, where the string touches again, it stands free. `last` is the node
    beside `base`, or the same; `bound` is true where the tape cannot take off before `base`,
    because it is held there.
    """

    base: Ints
    last: Ints
    far: Ints
    bound: Bools


def takeoffs(touching: Bools, held: Bools) -> Takeoffs:
    """Return the takeoffs of a string.

    Parameters
    ----------
    touching : ndarray of bool, shape (n + 1,)
        Which nodes touch the skin.
    held : ndarray of bool, shape (n + 1,)
        Which of them are ends, or held on ridges.
    """
    edges = np.flatnonzero(np.diff(touching)).tolist()
    begins = [0, *(edge + 1 for edge in edges)]
    ends = [*edges, len(touching) - 1]
    # The ends of a string touch, so that contact and free runs alternate.
    rows = []
    for number in range(0, len(begins), 2):
        first, last = begins[number], ends[number]
        # Both takeoffs of a short run are counted from one node, so that no segment is in both.
        left, right = (first + 1, last - 1) if last - first > 1 else (first, first)
        if number > 0:
            base = first if held[first] else left
            rows.append((base, first, begins[number - 1] - 1))
        if number + 1 < len(begins):
            base = last if held[last] else right
            rows.append((base, last, begins[number + 2]))
    table = np.array(rows, dtype=np.int64).reshape(-1, 3)
    return Takeoffs(table[:, 0], table[:, 1], table[:, 2], held[table[:, 0]])


class TakeoffLengths(NamedTuple):
    """The lengths from `base` to `far` of takeoffs, their errors, and whether they are known."""

    length: Array
    error: Array
    known: Bools


def takeoff_lengths(nodes: Array, feet: tuple[Feet, Feet], found: Takeoffs) -> TakeoffLengths:
    """Return the lengths of the arcs and tangents of takeoffs.

    The feet are those of `base` and of the next node; the error is the change of the length with
    the curvature from one to the other.
    """
    way = nodes[found.far] - nodes[found.base]
    normal = feet[0].normal
    down = -np.einsum("kc,kc->k", way, normal)
    flat = way + down[:, None] * normal
    along = np.linalg.norm(flat, axis=1)
    direction = flat / np.maximum(along, np.finfo(np.float64).tiny)[:, None]
    one, two = (np.einsum("ki,kij,kj->k", direction, foot.bend, direction) for foot in feet)
    length, known = _over_circle(along, down, one, found.bound)
    changed, also = _over_circle(along, down, two, found.bound)
    error = np.where(also, np.abs(changed - length), 0.0)
    return TakeoffLengths(length, error, known)


def _over_circle(along: Array, down: Array, curvature: Array, bound: Bools) -> tuple[Array, Bools]:
    """Return the lengths of arcs and tangents, and whether there are such."""
    chord = np.hypot(along, down)
    known = curvature * chord > 1.0 / STRAIGHT
    radius = 1.0 / np.where(known, curvature, 1.0)
    squared = chord**2 - 2.0 * radius * down
    known &= squared >= 0.0
    tangent = np.sqrt(np.maximum(squared, 0.0))
    angle = np.arctan2(along, radius - down) - np.arctan2(tangent, radius)
    length = np.where(bound & (angle <= 0.0), chord, radius * angle + tangent)
    return length, known
