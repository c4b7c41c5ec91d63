"""How far a loop reaches in a direction."""

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.section.curve import Curve

SAMPLES = 12
CUTS = 8
# Rounds of refinement. Steps of 1/12 of a piece shrink to 1e-7, and heights differ by its square.
ROUNDS = 7


def extent(loop: Curve, direction: ArrayLike) -> float:
    """Width of a loop along a direction, in the loop's unit.

    Parameters
    ----------
    loop : Curve
    direction : array_like, shape (3,)
        A unit vector.

    Returns
    -------
    float
        The distance of the two planes perpendicular to the direction that hold the loop between
        them.
    """
    direction = np.asarray(direction, dtype=np.float64)
    return _farthest(loop, direction) + _farthest(loop, -direction)


def _farthest(loop: Curve, direction: Array) -> float:
    """Largest coordinate along a direction: each sampled maximum is looked at ever closer."""
    end = float(loop.count)
    place = np.linspace(0.0, end, SAMPLES * loop.count + 1)
    value = loop.positions_at(place) @ direction
    before, after = np.roll(value, 1), np.roll(value, -1)
    if loop.closed:
        # The first point comes again as the last.
        before[0], after[-1] = value[-2], value[1]
    else:
        before[0] = after[-1] = -np.inf
    center = place[(value >= before) & (value >= after)]
    width = 1.0 / SAMPLES
    offsets = np.arange(-CUTS, CUTS + 1) / CUTS
    best = float(value.max())
    for _ in range(ROUNDS):
        tried = center[:, None] + width * offsets
        tried = tried % end if loop.closed else np.clip(tried, 0.0, end)
        value = (loop.positions_at(tried.ravel()) @ direction).reshape(tried.shape)
        center = np.take_along_axis(tried, value.argmax(axis=1)[:, None], axis=1)[:, 0]
        best = max(best, float(value.max()))
        width /= CUTS
    return best
