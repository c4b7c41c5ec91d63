"""Edges as few cubic Bezier curves that are exactly as long as the edges."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from scipy.optimize import brentq

from bodymeasure._typing import Array

# In millimeters: how far a cubic may be from the points of its edge.
TOLERANCE = 0.15
# A part that is longer than its chord by less than this part of its length is straight.
STRAIGHT = 1e-9
# The shortest part into which an edge is cut, as a fraction of it.
FINEST = 1.0 / 64.0
# Halvings by which it is found how far a cubic can go.
HALVINGS = 6
# Nodes for the length, and places at which the distance is taken.
NODES, WEIGHTS = np.polynomial.legendre.leggauss(32)
SAMPLES = 65
# Rounds in which the parameters of the points are improved.
ROUNDS = 8


def cubic_chains(sides: Sequence[Array], breaks: Sequence[float]) -> list[list[Array]]:
    """Return each of several chains as cubics, all cut at the same fractions of their lengths.

    Parameters
    ----------
    sides : sequence of ndarray, shape (m, 2)
        Edges that are sewn together, from the same end; in millimeters.
    breaks : sequence of float
        Fractions of the lengths at which they are cut in any case, from 0 to 1.

    Returns
    -------
    list of list of ndarray, shape (4, 2)
        The control points of the cubics of each side.
    """
    result: list[list[Array]] = [[] for _ in sides]
    for start, end in pairwise(breaks):
        for number, cubics in enumerate(_fitted(sides, start, end)):
            result[number] += cubics
    return result


def _fitted(sides: Sequence[Array], start: float, end: float) -> list[list[Array]]:
    """Return the cubics of a part of all sides, each of which goes as far as it can."""
    result: list[list[Array]] = [[] for _ in sides]
    while start < end:
        stop, cubics = end, _cubics(sides, start, end)
        if cubics is None:
            stop = min(start + FINEST, end)
            # The shortest one is taken as it is: it only has to be as long.
            cubics = _cubics(sides, start, stop) or _cubics(sides, start, stop, np.inf)
            beyond = end
            for _ in range(HALVINGS):
                middle = 0.5 * (stop + beyond)
                longer = _cubics(sides, start, middle)
                if longer is None:
                    beyond = middle
                else:
                    stop, cubics = middle, longer
        # What would be left of it is shared with its last part.
        rest = 0.5 * (start + end)
        if stop < end < stop + FINEST and (halved := _cubics(sides, start, rest)) is not None:
            stop, cubics = rest, halved
        for number, cubic in enumerate(
            cubics or [_straight(part_of(s, start, stop)) for s in sides]
        ):
            result[number].append(cubic)
        start = stop
    return result


def _cubics(
    sides: Sequence[Array], start: float, end: float, tolerance: float = TOLERANCE
) -> list[Array] | None:
    """Return one cubic for a part of each side; None if one would be too far from its side."""
    found = []
    for side in sides:
        part = part_of(side, start, end)
        cubic = cubic_of(part)
        if cubic is None or _distance(cubic, part) > tolerance:
            return None
        found.append(cubic)
    return found


def part_of(chain: Array, start: float, end: float) -> Array:
    """Return the part of a chain between two fractions of its length."""
    arcs = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(chain, axis=0), axis=1))])
    low, high = start * arcs[-1], end * arcs[-1]
    # A point just beside the end would make a step of no length.
    slack = 1e-9 * arcs[-1]
    inner = arcs[(arcs > low + slack) & (arcs < high - slack)]
    wanted = np.concatenate([[low], inner, [high]])
    return np.stack([np.interp(wanted, arcs, axis) for axis in chain.T], axis=1)


def cubic_of(points: Array) -> Array | None:
    """Return the cubic through both ends of a chain that is as long and runs along it.

    None if no such cubic is as long, because the chain winds to and fro.
    """
    length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    chord = points[-1] - points[0]
    size = float(np.linalg.norm(chord))
    if length - size <= STRAIGHT * length or len(points) < 3:
        return _straight(points)
    frame = np.stack([chord, [-chord[1], chord[0]]]) / size**2
    local = (points - points[0]) @ frame.T
    inner = _least_squares(local)
    if inner is None:
        return None

    def excess(scale: float) -> float:
        return length_of(_whole(inner * [1.0, scale])) - length / size

    low, high = 0.0, 1.0
    while excess(high) < 0.0:
        low, high = high, 1.5 * high
        if high > 4.0:
            return None
    if excess(low) > 0.0:
        return None
    scale = float(brentq(excess, low, high, xtol=1e-15, rtol=1e-14))
    control = _whole(inner * [1.0, scale])
    return np.asarray(points[0] + control @ np.stack([chord, [-chord[1], chord[0]]]))


def length_of(control: Array) -> float:
    """Return the length of a cubic."""
    t = 0.5 + 0.5 * NODES
    step = 3.0 * np.diff(control, axis=0)
    weights = np.stack([(1.0 - t) ** 2, 2.0 * t * (1.0 - t), t**2], axis=1)
    return float(0.5 * WEIGHTS @ np.linalg.norm(weights @ step, axis=1))


def points_of(control: Array, t: Array) -> Array:
    """Return points of a cubic at parameters in [0, 1]."""
    return np.asarray(_basis(t) @ control)


def _basis(t: Array) -> Array:
    s = 1.0 - t
    return np.stack([s**3, 3.0 * s**2 * t, 3.0 * s * t**2, t**3], axis=1)


def _whole(inner: Array) -> Array:
    return np.concatenate([[[0.0, 0.0]], inner, [[1.0, 0.0]]])


def _straight(points: Array) -> Array:
    t = np.linspace(0.0, 1.0, 4)[:, None]
    return np.asarray((1.0 - t) * points[0] + t * points[-1])


def _least_squares(local: Array) -> Array | None:
    """Return the inner control points of the cubic from (0, 0) to (1, 0) nearest to points."""
    sizes = np.linalg.norm(np.diff(local, axis=0), axis=1)
    t = np.concatenate([[0.0], np.cumsum(sizes)]) / sizes.sum()
    if len(local) < 4:
        # Too few points for two control points: a parabola, raised to a cubic.
        middle = (local[1] - t[1] ** 2 * np.array([1.0, 0.0])) / (2.0 * t[1] * (1.0 - t[1]))
        return np.stack([2.0 * middle, 2.0 * middle + [1.0, 0.0]]) / 3.0
    inner: Array | None = None
    for _ in range(ROUNDS):
        basis = _basis(t)
        target = local - basis[:, 3:] * [[1.0, 0.0]]
        inner = np.asarray(np.linalg.lstsq(basis[:, 1:3], target, rcond=None)[0], dtype=float)
        control = _whole(inner)
        # Each point's parameter moves to where the cubic is nearest, to first order.
        step = 3.0 * np.diff(control, axis=0)
        along = np.stack([(1.0 - t) ** 2, 2.0 * t * (1.0 - t), t**2], axis=1) @ step
        off = ((local - basis @ control) * along).sum(axis=1) / (along**2).sum(axis=1)
        t = np.clip(t + off, 0.0, 1.0)
        t[0], t[-1] = 0.0, 1.0
        if (np.diff(t) <= 0.0).any():
            return None
    return inner


def _distance(control: Array, points: Array) -> float:
    """Return how far the points of a chain are from a cubic."""
    curve = points_of(control, np.linspace(0.0, 1.0, SAMPLES))
    along = np.diff(curve, axis=0)
    away = points[:, None] - curve[:-1]
    part = np.clip((away * along).sum(axis=2) / (along**2).sum(axis=1), 0.0, 1.0)
    return float(np.linalg.norm(away - part[..., None] * along, axis=2).min(axis=1).max())
