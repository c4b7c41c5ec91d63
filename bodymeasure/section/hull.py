"""The perimeter of a loop's convex hull: the length of a tape drawn taut around it."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError
from bodymeasure.section.bridged import BridgedLoop
from bodymeasure.section.curve import Curve
from bodymeasure.section.loop import SectionLoop

# The number of samples on each piece to begin with: they have to separate hollows, not to measure
# them.
SAMPLES = 12
# The number of parts into which the steps beside a bridge's ends are cut in each round.
CUTS = 8
# Where the ends of bridges are known to within this part of a piece, their lengths are exact except
# for rounding, since an error e of a tangent's foot changes the perimeter by some e^3.
FINEST = 1e-6
# Hollows that save less than this part of the length are not worth a closer look.
NEGLIGIBLE = 1e-14
# Angles with a smaller sine are straight: the rounding of the finest steps stays below, and hollows
# so shallow save 1e-12 of the length.
STRAIGHT = 1e-6
# The way round corners may be longer by this part in the loop's order than in the hull's.
ORDER_TOLERANCE = 1e-9
# An arc that crosses its line within this part of the chord from its end starts there, except for
# rounding.
BEYOND = 1e-9
# What a hull saves is lost in rounding where only this part of the chord lies outwards of it.
FLAT = 1e-9


class Hull(NamedTuple):
    """The convex hull of a closed curve, or the outer side of an open one's.

    Parameters
    ----------
    length : float
        Its perimeter: at most the curve's length.
    error_estimate : float
    bridges : ndarray, shape (k, 2, 3)
        Ends of the straight parts that span hollows.
    spans : ndarray, shape (k, 2)
        Their places on the curve.
    """

    length: float
    error_estimate: float
    bridges: Array
    spans: Array


def convex_hull(loop: Curve) -> Hull:
    """Return the convex hull of a closed loop in its plane, from the smooth curve.

    Parameters
    ----------
    loop : Curve

    Returns
    -------
    Hull

    Raises
    ------
    InputError
        If the loop is open, or crosses itself.

    Notes
    -----
    The hull consists of arcs of the loop, whose lengths are known, and bridges over its hollows.
    Bridges are found on samples; the samples beside their ends are refined until they are exact.
    The arc less the chord, which is what a bridge saves, is taken off the loop's length.
    """
    if not loop.closed:
        raise InputError(
            "the section is open: it ends on the boundary of the atlas, so a tape around it has no "
            "length; choose a plane that cuts the body all round, or join the patches' edges"
        )

    def corners(_: Array, flat: Array) -> Ints:
        return _hull_corners(flat, np.arange(len(flat)))

    frame = loop.plane.frame()
    flat = loop.positions_at(np.arange(SAMPLES * loop.count) / SAMPLES) @ frame.T
    return _refined(loop, corners, signed_area(flat))


def outer_hull(arc: SectionLoop, turn: float) -> Hull:
    """Return the shortest curve in its plane from an arc's start to its end, beside the arc.

    Parameters
    ----------
    arc : SectionLoop
        An open curve.
    turn : float
        Positive if the body lies to the left of the arc, seen in the plane's frame, else negative.

    Raises
    ------
    InputError
        If the arc winds about one of its ends, or crosses itself.

    Notes
    -----
    It is the convex hull of what lies outwards of the arc's chord; see `convex_hull`.
    """
    loop = BridgedLoop((arc,))

    def corners(place: Array, flat: Array) -> Ints:
        # The line back from the end to the start comes last.
        end = int(np.searchsorted(place, float(arc.count)))
        return _outer_corners(flat, end, turn)

    hull = _refined(loop, corners, turn)
    chord = float(np.linalg.norm(loop.bridges[0, 1] - loop.bridges[0, 0]))
    # It lies between the two, except for rounding.
    return hull._replace(length=max(min(hull.length - chord, arc.length), chord))


def signed_area(flat: Array) -> float:
    """Return twice the area inside a closed polygon (n, 2), negative if it runs clockwise."""
    return float(_cross(flat, np.roll(flat, -1, axis=0)).sum())


class _Samples(NamedTuple):
    """Samples of a curve, in order.

    Parameters
    ----------
    place : ndarray, shape (n,)
    flat, arriving, leaving : ndarray, shape (n, 2)
        Positions in the plane's frame, and velocities on the pieces before and after them.
    """

    place: Array
    flat: Array
    arriving: Array
    leaving: Array

    @classmethod
    def at(cls, loop: Curve, place: Array) -> "_Samples":
        """Return the samples at places that begin pieces or lie within them."""
        to_frame = loop.plane.frame().T
        row = place.astype(np.int64)
        leaving = loop.velocities(row, (place - row)[:, None])[:, 0] @ to_frame
        begins = np.flatnonzero(place == row)
        arriving = leaving.copy()
        ends = np.ones((len(begins), 1))
        before = (row[begins] - 1) % loop.count
        arriving[begins] = loop.velocities(before, ends)[:, 0] @ to_frame
        return cls(place, loop.positions_at(place) @ to_frame, arriving, leaving)

    def joined(self, other: "_Samples") -> "_Samples":
        """Return both, each place once."""
        both = [np.concatenate(pair) for pair in zip(self, other, strict=True)]
        _, order = np.unique(both[0], return_index=True)
        return _Samples(*(each[order] for each in both))


_Corners = Callable[[Array, Array], Ints]


def _refined(loop: Curve, corners_of: _Corners, turn: float) -> Hull:
    """Return a hull from its corners among samples, refined where it leaves the curve.

    Parameters
    ----------
    loop : Curve
    corners_of : callable
        Takes places (n,) and positions in the plane (n, 2) and returns the rows of the corners, in
        order.
    turn : float
        Positive if the curve goes counterclockwise round what it encloses.
    """
    samples = _Samples.at(loop, np.arange(SAMPLES * loop.count) / SAMPLES)
    previous = np.inf
    for _ in range(20):
        place = samples.place
        corners = corners_of(place, samples.flat)
        first, last = corners, np.roll(corners, -1)
        saved = _saved(loop, samples, first, last)
        total = loop.length - float(saved.sum())
        hollow = saved > NEGLIGIBLE * loop.length
        # Skipped ends of pieces that save nothing may be kinks, whose hollows show on finer steps.
        skips = (last - first) % len(place) > 1
        skips &= hollow | (np.floor(place[first]) != np.floor(place[last]))
        ends = np.concatenate([first[skips], last[skips]])
        steps = np.concatenate([ends - 1, ends, _concave_steps(samples, corners, turn)])
        new = _between(place, np.unique(steps % len(place)), float(loop.count))
        if not len(new):
            break
        previous = total
        samples = samples.joined(_Samples.at(loop, new))
    change = abs(previous - total) if np.isfinite(previous) else 0.0
    spans = np.stack([place[first[hollow]], place[last[hollow]]], axis=1)
    bridges = loop.positions_at(spans.ravel()).reshape(-1, 2, 3)
    return Hull(total, loop.error_estimate + change, bridges, spans)


def _outer_corners(flat: Array, end: int, turn: float) -> Ints:
    """Samples on the hull of what lies outwards of the chord from the first to the one at `end`."""
    chord = flat[end] - flat[0]
    length = np.linalg.norm(chord)
    along = (flat[: end + 1] - flat[0]) @ chord / length**2
    outwards = np.sign(turn) / length * _cross(flat[: end + 1] - flat[0], chord[None])
    rows = np.flatnonzero((outwards[1:] > 0.0) != (outwards[:-1] > 0.0))
    step = outwards[rows] / (outwards[rows] - outwards[rows + 1])
    crossed = along[rows] + step * (along[rows + 1] - along[rows])
    if ((crossed < -BEYOND) | (crossed > 1.0 + BEYOND)).any():
        raise InputError(
            "the surface winds about an end of the tape, so that a taut tape has no clear way out; "
            "choose ends that lie open, or measure along the skin"
        )
    if not (outwards > FLAT * length).any():
        return np.array([0, end])
    # All that is kept lies to one side of the chord, so that the chord is a side of its hull.
    kept = np.union1d(np.flatnonzero(outwards > 0.0), [0, end])
    return np.union1d(_hull_corners(flat, kept), [0, end])


def _hull_corners(flat: Array, rows: Ints) -> Ints:
    """Return which of some rows of samples are on their convex hull, in the curve's order."""
    try:
        corners = rows[scipy.spatial.ConvexHull(flat[rows]).vertices]
    except scipy.spatial.QhullError:
        raise InputError(
            "the section is as flat as a line, so it has no convex hull; move or tilt the plane"
        ) from None
    ordered = np.sort(corners)
    around, along = (_perimeter(flat[order]) for order in (corners, ordered))
    if along > around * (1.0 + ORDER_TOLERANCE):
        raise InputError(
            "the section crosses itself, so that a tape around it has no clear path; check the "
            "atlas for parts that intersect, or move the plane"
        )
    return ordered


def _perimeter(corners: Array) -> float:
    return float(np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1).sum())


def _saved(loop: Curve, samples: _Samples, first: Ints, last: Ints) -> Array:
    """Arc less chord from each corner to the next, shape (corners,); 0 from sample to sample."""
    place, flat = samples.place, samples.flat
    span = (last - first) % len(place)
    rows = np.flatnonzero(span > 1)
    result = np.zeros(len(first))
    at = loop.arc_length_at(place[np.concatenate([first[rows], last[rows]])])
    arc = at[len(rows) :] - at[: len(rows)]
    arc = np.where(last[rows] < first[rows], arc + loop.length, arc)
    chord = np.linalg.norm(flat[last[rows]] - flat[first[rows]], axis=1)
    # No arc is shorter than its chord, except for rounding.
    result[rows] = np.maximum(arc - chord, 0.0)
    return result


def _concave_steps(samples: _Samples, corners: Ints, turn: float) -> Ints:
    """Return the steps from a corner to the next sample that may hide a hollow.

    In these the loop turns inwards: at an end, against the chord, or at a kink between two pieces.
    """
    count = len(samples.place)
    on_hull = np.zeros(count, dtype=np.bool_)
    on_hull[corners] = True
    steps = np.flatnonzero(on_hull & np.roll(on_hull, -1))
    there = (steps + 1) % count
    leaving, arriving = samples.leaving[steps], samples.arriving[there]
    chord = samples.flat[there] - samples.flat[steps]

    anticlockwise = np.sign(turn)
    into, out_of = (anticlockwise * _sine(*pair) for pair in ((leaving, chord), (chord, arriving)))
    concave = (into < -STRAIGHT) | (out_of < -STRAIGHT)
    following = np.roll(steps, -1) == there
    kink = anticlockwise * _sine(arriving, np.roll(leaving, -1, axis=0))
    concave |= following & (kink < -STRAIGHT)
    # The hollow of a kink reaches into the step after it, too.
    return np.concatenate([steps[concave], steps[concave] + 1])


def _cross(first: Array, second: Array) -> Array:
    return np.asarray(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])


def _sine(first: Array, second: Array) -> Array:
    size = np.linalg.norm(first, axis=1) * np.linalg.norm(second, axis=1)
    sine = np.divide(_cross(first, second), size, out=np.zeros_like(size), where=size > 0.0)
    return np.asarray(sine)


def _between(place: Array, steps: Ints, period: float) -> Array:
    """New places in some steps from sample to sample, but in those that are fine."""
    start = place[steps]
    width = (place[(steps + 1) % len(place)] - start) % period
    coarse = width > FINEST
    parts = np.arange(1, CUTS) / CUTS
    return np.asarray((start[coarse, None] + width[coarse, None] * parts) % period).ravel()
