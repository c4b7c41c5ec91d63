"""Chains of the sides of a mesh as smooth curves, as long as they are."""

from itertools import pairwise

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints

# The part of its second differences by which a vertex lies off the arc of which each side of its
# chain is as long: a circle with arcs of length h lies h^2 / 24 r inside of the chain's corners.
INSIDE = 1.0 / 24.0
# Secant steps that make the curve exactly as long, and the part of its length that is rounding.
STEPS, EXACT = 8, 1e-12
# The most that is sought: a chain that wants more is no sample of a smooth curve.
MOST = 0.25
# How far the curve may be from its own chords, as a part of a side of the chain, and the most of
# them for one.
SAG, MOST_CHORDS = 1e-3, 16
# Chains of fewer points are left as they are.
FEWEST = 5
# A chain runs on smoothly while its sides differ by less than this factor, and turn by less than
# this angle, in radians.
ALIKE, TURN = 1.5, 0.5


def smooth_chain(points: Array) -> Array:
    """Return a smooth curve along a chain (n, 2), as points (m, 2) of which it is drawn.

    It has the chain's ends, and exactly its length, in each of its parts between corners.

    Notes
    -----
    The sides of a chain are as long as the arcs for which they stand, so that its corners lie
    outside of the curve: by a part of their second differences, which is found so that a cubic
    spline through what is left has the chain's length.
    """
    points = np.asarray(points)
    bounds = [0, *(_corners(points) + 1).tolist(), len(points) - 1]
    parts = [_smooth(points[low : high + 1])[:-1] for low, high in pairwise(bounds) if high > low]
    return np.concatenate([*parts, points[-1:]])


def _corners(points: Array) -> Ints:
    """Return the inner points, counted from 0, at which a chain does not run on smoothly."""
    sides = np.diff(points, axis=0)
    sizes = np.linalg.norm(sides, axis=1)
    cross = sides[:-1, 0] * sides[1:, 1] - sides[:-1, 1] * sides[1:, 0]
    turn = np.arctan2(cross, (sides[:-1] * sides[1:]).sum(axis=1))
    ratio = np.maximum(sizes[1:], sizes[:-1]) / np.minimum(sizes[1:], sizes[:-1])
    return np.flatnonzero((ratio > ALIKE) | (np.abs(turn) > TURN))


def _smooth(chain: Array) -> Array:
    if len(chain) < FEWEST:
        return chain
    wanted = _length(chain)
    bend = np.zeros_like(chain)
    bend[1:-1] = chain[2:] - 2.0 * chain[1:-1] + chain[:-2]
    sag = float(np.linalg.norm(bend, axis=1).max()) / (8.0 * SAG * wanted / (len(chain) - 1))
    chords = int(np.clip(np.ceil(np.sqrt(sag)), 1, MOST_CHORDS))
    places = np.linspace(0.0, len(chain) - 1.0, chords * (len(chain) - 1) + 1)

    def curve(part: float) -> Array:
        moved = chain + part * bend
        return np.asarray(scipy.interpolate.CubicSpline(np.arange(len(chain)), moved)(places))

    low, high = 0.0, INSIDE
    missed = [_length(curve(part)) - wanted for part in (low, high)]
    for _ in range(STEPS):
        if abs(missed[1]) <= EXACT * wanted or missed[0] == missed[1]:
            break
        following = high - missed[1] * (high - low) / (missed[1] - missed[0])
        low, high = high, float(np.clip(following, -MOST, MOST))
        missed = [missed[1], _length(curve(high)) - wanted]
    return curve(high) if abs(missed[1]) <= 1e3 * EXACT * wanted else chain


def _length(points: Array) -> float:
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
