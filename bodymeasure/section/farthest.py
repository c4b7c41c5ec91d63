"""Where a loop reaches farthest in a direction: on the smooth curve, not on samples of it."""

from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import AtlasPoint
from bodymeasure.section.loop import SectionLoop
from bodymeasure.section.pieces import Pieces

# Steps a piece in which the loop's slope may change its sign once. Pieces are graphs of cubics,
# which turn back once or twice.
STEPS = 12
# Of a piece: where a slope vanishes is found to rounding.
ROOT_TOLERANCE = 1e-15


class LoopPlaces(NamedTuple):
    """Places on a loop.

    Parameters
    ----------
    piece : ndarray of int, shape (k,)
    fraction : ndarray, shape (k,)
        Of the piece, in [0, 1].
    position : ndarray, shape (k, 3)
    parameters : ndarray, shape (k, 2)
        (u, v) on the piece's patch.
    """

    piece: Ints
    fraction: Array
    position: Array
    parameters: Array


def local_maxima(loop: SectionLoop, direction: Array) -> LoopPlaces:
    """Places at which a loop reaches farther in a direction than beside them.

    Parameters
    ----------
    loop : SectionLoop
    direction : ndarray, shape (3,)

    Returns
    -------
    LoopPlaces
        At least the farthest of all; ends of an open curve are among them.

    Notes
    -----
    Roots of the curve's slope, bracketed on steps of each piece, and the joints of pieces at which
    the slope changes its sign.
    """
    grid = np.broadcast_to(np.arange(STEPS + 1) / STEPS, (len(loop.pieces), STEPS + 1))
    _, position, velocity = loop.surface.points(loop.pieces, grid)
    slope = velocity @ direction

    piece, step = np.nonzero((slope[:, :-1] > 0.0) & (slope[:, 1:] <= 0.0))
    fraction = [
        _slope_root(loop, direction, int(i), j / STEPS, (j + 1) / STEPS)
        for i, j in zip(piece, step, strict=True)
    ]
    before = np.roll(slope[:, -1], 1)
    if not loop.closed:
        before[0] = np.inf
    joints = np.flatnonzero((before >= 0.0) & (slope[:, 0] <= 0.0))
    # Where a stretch is as far as can be, no slope changes its sign.
    farthest, at = np.unravel_index(int(np.argmax(position @ direction)), slope.shape)
    pieces = np.concatenate([piece, joints, [farthest, len(slope) - 1]])
    fractions = np.concatenate([fraction, np.zeros(len(joints)), [at / STEPS, 1.0]])
    return places_on(loop, pieces.astype(np.int64), fractions)


def places_on(loop: SectionLoop, piece: Ints, fraction: Array) -> LoopPlaces:
    """Places of a loop by the numbers of pieces (k,) and fractions (k,) run of them."""
    parameters, position, _ = loop.surface.points(loop.pieces.take(piece), fraction[:, None])
    return LoopPlaces(piece, fraction, position[:, 0], parameters[:, 0])


def atlas_point(loop: SectionLoop, places: LoopPlaces, number: int) -> AtlasPoint:
    """One of the places as a point of the atlas."""
    u, v = np.clip(places.parameters[number], 0.0, 1.0).tolist()
    return AtlasPoint(int(loop.pieces.patch[places.piece[number]]), u, v)


def _slope_root(loop: SectionLoop, direction: Array, piece: int, low: float, high: float) -> float:
    row: Pieces = loop.pieces.take(np.array([piece]))

    def slope(fraction: float) -> float:
        return float(loop.surface.points(row, np.array([[fraction]]))[2][0, 0] @ direction)

    return float(scipy.optimize.brentq(slope, low, high, xtol=ROOT_TOLERANCE))
