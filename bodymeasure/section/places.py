"""Places along the curves of a section: the nearest, the farthest, and where a sign changes.

Each search samples the curve, and then closes in on what the samples show: the places are those of
the smooth curve, to rounding. A place is the number of a piece plus the fraction run of it.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas import AtlasPoint
from bodymeasure.section.curve import Curve
from bodymeasure.section.loop import SectionLoop

# The number of samples on each piece. A piece is a graph over one parameter of a bicubic patch,
# which turns only a little.
SAMPLES = 24
# The number of parts into which the steps about a place are cut in each round.
CUTS = 8
# The rounds after which 1/24 of a piece has shrunk to rounding, and those after which it has shrunk
# to 1e-7: at a maximum, heights differ by the square of that. After two, slopes take over.
ROUNDS, ROUNDS_OF_HEIGHTS, ROUNDS_TO_SLOPES = 15, 6, 2
# The most steps to a change of sign, each of which at least halves its bracket. Some five are
# usual.
STEPS = 54
# Rounding leaves an error of this part of the number of pieces in a place.
FINEST = 1e-15
# The number of steps of each piece in which the curve's slope may change its sign once. Pieces are
# graphs of cubics, which turn back once or twice.
SLOPES = 12


class LoopPlaces(NamedTuple):
    """Places on a loop.

    Parameters
    ----------
    piece : ndarray of int, shape (k,)
    fraction : ndarray, shape (k,)
        Fraction of the piece, in [0, 1].
    position : ndarray, shape (k, 3)
    parameters : ndarray, shape (k, 2)
        (u, v) on the piece's patch.
    """

    piece: Ints
    fraction: Array
    position: Array
    parameters: Array


def nearest_place(loop: Curve, position: ArrayLike) -> float:
    """Return the place of a curve that is nearest to a position."""
    target = np.asarray(position, dtype=np.float64)

    def nearness(place: Array) -> Array:
        return np.asarray(-np.linalg.norm(loop.positions_at(place) - target, axis=-1))

    place = _sampled(loop)
    center = place[[np.argmax(nearness(place))]]
    near = _highest(loop, nearness, center, ROUNDS_TO_SLOPES)
    # Distances are the same for a way of the square root of their rounding; their slope is not.
    row = np.minimum(near.astype(np.int64), loop.count - 1)
    away = np.array([[-1.0], [1.0]]) / (SAMPLES * CUTS**ROUNDS_TO_SLOPES)
    low, high = np.clip(near - row + away, 0.0, 1.0)

    def slope(fraction: Array, _rows: Ints) -> Array:
        positions, velocities = loop.motion(row, fraction[:, None])
        return np.asarray(((positions - target) * velocities).sum(axis=(1, 2)))

    at_low, at_high = slope(low, row), slope(high, row)
    if at_low[0] < 0.0 < at_high[0]:
        return float((row + roots_between(slope, low, high, at_low, at_high, FINEST))[0])
    # It is a kink between two pieces, or an end.
    return float(_highest(loop, nearness, center, ROUNDS)[0])


def extent(loop: Curve, direction: ArrayLike) -> float:
    """Return the width of a loop along a direction, in the loop's unit.

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
    return _reach(loop, direction) + _reach(loop, -direction)


def _reach(loop: Curve, direction: Array) -> float:
    """Return the largest coordinate along a direction, from all sampled maxima."""

    def height(place: Array) -> Array:
        return np.asarray(loop.positions_at(place) @ direction)

    place = _sampled(loop)
    value = height(place)
    before, after = np.roll(value, 1), np.roll(value, -1)
    if loop.closed:
        # The first point comes again as the last.
        before[0], after[-1] = value[-2], value[1]
    else:
        before[0] = after[-1] = -np.inf
    center = place[(value >= before) & (value >= after)]
    return float(height(_highest(loop, height, center, ROUNDS_OF_HEIGHTS)).max())


def _sampled(loop: Curve) -> Array:
    """Places close together along a curve, shape (n,), its end included."""
    return np.asarray(np.arange(SAMPLES * loop.count + 1) / SAMPLES)


def _highest(loop: Curve, value: Callable[[Array], Array], center: Array, rounds: int) -> Array:
    """Return places (k,) at which a function of the place is largest, near sampled maxima (k,)."""
    end, width = float(loop.count), 1.0 / SAMPLES
    offsets = np.arange(-CUTS, CUTS + 1) / CUTS
    for _ in range(rounds):
        tried = center[:, None] + width * offsets
        tried = tried % end if loop.closed else np.clip(tried, 0.0, end)
        best = value(tried.ravel()).reshape(tried.shape).argmax(axis=1)
        center = tried[np.arange(len(tried)), best]
        width /= CUTS
    return center


def sign_changes(
    loop: SectionLoop, height: Callable[[Array], Array], tolerance: float = FINEST
) -> Array:
    """Return the places at which a function of the position changes its sign, in order.

    Parameters
    ----------
    loop : SectionLoop
    height : callable
        Takes positions (n, 3) and returns numbers (n,); zero counts as positive.
    tolerance : float
        How exact the places have to be, as a part of the number of pieces.

    Returns
    -------
    ndarray, shape (k,)
    """

    def at(place: Array, _rows: Ints) -> Array:
        return height(loop.positions_at(place))

    place = _sampled(loop)
    value = height(loop.positions_at(place))
    rows = np.flatnonzero((value[1:] < 0.0) != (value[:-1] < 0.0))
    brackets = place[rows], place[rows + 1], value[rows], value[rows + 1]
    return roots_between(at, *brackets, tolerance * loop.count)


def roots_between(
    value: Callable[[Array, Ints], Array],
    low: Array,
    high: Array,
    at_low: Array,
    at_high: Array,
    tolerance: float,
) -> Array:
    """Return the roots of functions, each in its bracket, all of shape (k,).

    `value` takes arguments and the numbers of the functions.

    C. Ridders, "A new algorithm for computing a single root", IEEE Trans. Circuits Syst. 26 (1979).
    """
    rows = np.arange(len(low))
    root = np.where(np.abs(at_low) < np.abs(at_high), low, high)
    for _ in range(STEPS):
        middle = 0.5 * (low + high)
        at_middle = value(middle, rows)
        scale = np.sqrt(at_middle**2 - at_low * at_high)
        shift = np.sign(at_low - at_high) * np.divide(
            at_middle, scale, out=np.zeros_like(scale), where=scale > 0.0
        )
        previous, root = root, np.clip(middle + (middle - low) * shift, low, high)
        at_root = value(root, rows)
        for place, found in ((middle, at_middle), (root, at_root)):
            inside: Bools = (place > low) & (place < high)
            before = inside & ((found < 0.0) == (at_low < 0.0))
            after = inside & ~before
            low, at_low = np.where(before, place, low), np.where(before, found, at_low)
            high, at_high = np.where(after, place, high), np.where(after, found, at_high)
        if (np.abs(root - previous) <= tolerance).all():
            break
    return np.asarray(root)


def local_maxima(loop: SectionLoop, direction: Array) -> LoopPlaces:
    """Return the places at which a loop reaches farther in a direction than beside them.

    Parameters
    ----------
    loop : SectionLoop
    direction : ndarray, shape (3,)

    Returns
    -------
    LoopPlaces
        They hold at least the farthest of all; ends of an open curve are among them.

    Notes
    -----
    They are the roots of the curve's slope, bracketed on steps of each piece, and the joints of
    pieces at which the slope changes its sign.
    """
    grid = np.broadcast_to(np.arange(SLOPES + 1) / SLOPES, (len(loop.pieces), SLOPES + 1))
    _, position, velocity = loop.surface.points(loop.pieces, grid)
    slope = velocity @ direction
    piece, step = np.nonzero((slope[:, :-1] > 0.0) & (slope[:, 1:] <= 0.0))

    def slope_at(fraction: Array, rows: Ints) -> Array:
        return np.asarray(loop.motion(piece[rows], fraction[:, None])[1][:, 0] @ direction)

    ends = slope[piece, step], slope[piece, step + 1]
    fraction = roots_between(slope_at, step / SLOPES, (step + 1) / SLOPES, *ends, FINEST)
    before = np.roll(slope[:, -1], 1)
    if not loop.closed:
        before[0] = np.inf
    joints = np.flatnonzero((before >= 0.0) & (slope[:, 0] <= 0.0))
    # Where a stretch is as far as can be, no slope changes its sign.
    farthest, at = np.unravel_index(int(np.argmax(position @ direction)), slope.shape)
    pieces = np.concatenate([piece, joints, [farthest, len(slope) - 1]])
    fractions = np.concatenate([fraction, np.zeros(len(joints)), [at / SLOPES, 1.0]])
    return places_on(loop, pieces.astype(np.int64), fractions)


def places_on(loop: SectionLoop, piece: Ints, fraction: Array) -> LoopPlaces:
    """Return places of a loop from the numbers of pieces (k,) and fractions (k,) run of them."""
    parameters, position, _ = loop.surface.points(loop.pieces.take(piece), fraction[:, None])
    return LoopPlaces(piece, fraction, position[:, 0], parameters[:, 0])


def point_of_place(loop: SectionLoop, places: LoopPlaces, number: int) -> AtlasPoint:
    """Return one of the places as a point of the atlas."""
    u, v = np.clip(places.parameters[number], 0.0, 1.0).tolist()
    return AtlasPoint(int(loop.pieces.patch[places.piece[number]]), u, v)
