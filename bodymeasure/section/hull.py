"""The perimeter of a loop's convex hull: the length of a tape drawn taut around it."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError
from bodymeasure.native import is_compiled, planar_hull
from bodymeasure.section.bridged import BridgedLoop
from bodymeasure.section.curve import Curve
from bodymeasure.section.loop import SectionLoop

# The number of samples on each piece to begin with: they have to separate hollows, not to measure
# them.
SAMPLES = 12
# The number of parts into which the steps beside a bridge's ends are cut in each round, and the
# most rounds: three lead from 1/12 of a piece to the finest steps, but some hollows show late.
CUTS = 21
ROUNDS = 12
# Where the ends of bridges are known to within this part of a piece, their lengths are exact except
# for rounding, since an error e of a tangent's foot changes the perimeter by some e^3.
FINEST = 1e-5
# Hollows that save less than this part of the length are not worth a closer look.
NEGLIGIBLE = 1e-14
# Angles with a smaller sine are straight: the rounding of the finest steps stays below, and hollows
# so shallow save 1e-12 of the length.
STRAIGHT = 1e-6
# Which of the samples are corners is left to rounding where they are closer together than this part
# of the length, as on the tiny pieces beside a corner of patches.
CLOSE = 1e-11
# The way round corners may be longer by this part in the loop's order than in the hull's.
ORDER_TOLERANCE = 1e-9
# An arc that crosses its line within this part of the chord from its end starts there, except for
# rounding.
BEYOND = 1e-9
# A hull that encloses less than this part of its perimeter's square is a line.
LINE = 1e-13
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

    def corners(samples: _Samples, rows: Ints) -> Ints:
        return _hull_corners(samples.flat, rows)

    return _refined(loop, corners)


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

    def corners(samples: _Samples, rows: Ints) -> Ints:
        # The line back from the end to the start comes last.
        end = int(np.searchsorted(samples.place, float(arc.count)))
        return _outer_corners(samples.flat, end, turn, rows)

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
    def at(cls, loop: Curve, to_frame: Array, place: Array) -> "_Samples":
        """Return the samples at places that begin pieces or lie within them."""
        row = place.astype(np.int64)
        begins = np.flatnonzero(place == row)
        # The ends of the pieces before are the same points, but for their velocities.
        rows = np.concatenate([row, (row[begins] - 1) % loop.count])
        fraction = np.concatenate([place - row, np.ones(len(begins))])
        flat, velocity = (x[:, 0] @ to_frame for x in loop.motion(rows, fraction[:, None]))
        leaving = velocity[: len(row)]
        arriving = leaving.copy()
        arriving[begins] = velocity[len(row) :]
        return cls(place, flat[: len(row)], arriving, leaving)

    def joined(self, other: "_Samples") -> tuple["_Samples", Ints]:
        """Return both, each place once, and the rows of the first of them."""
        both = [np.concatenate(pair) for pair in zip(self, other, strict=True)]
        _, order, rows = np.unique(both[0], return_index=True, return_inverse=True)
        return _Samples(*(each[order] for each in both)), rows


_Corners = Callable[[_Samples, Ints], Ints]


class _Chords(NamedTuple):
    """Chords over a curve: the places of their ends, shape (k, 2), and their lengths (k,)."""

    ends: Array
    length: Array

    def saved(self, loop: Curve) -> Array:
        """Return the arcs less the chords."""
        first, last = loop.arc_length_at(self.ends.T.ravel()).reshape(2, -1)
        arc = np.where(self.ends[:, 1] < self.ends[:, 0], last - first + loop.length, last - first)
        # No arc is shorter than its chord, except for rounding.
        return np.maximum(arc - self.length, 0.0)


def _refined(loop: Curve, corners_of: _Corners, turn: float | None = None) -> Hull:
    """Return a hull from its corners among samples, refined where it leaves the curve.

    Parameters
    ----------
    loop : Curve
    corners_of : callable
        Takes samples and the rows of some of them, and returns the rows of the corners among these,
        in order.
    turn : float, optional
        Positive if the curve goes counterclockwise round what it encloses; that of its samples if
        not given.
    """
    to_frame = loop.plane.frame().T
    samples = _Samples.at(loop, to_frame, np.arange(SAMPLES * loop.count) / SAMPLES)
    turn = signed_area(samples.flat) if turn is None else turn
    rows = np.arange(len(samples.place))
    chords: list[_Chords] = []
    for _ in range(ROUNDS):
        place, flat = samples.place, samples.flat
        corners = corners_of(samples, rows)
        first, last = corners, np.roll(corners, -1)
        skips = (last - first) % len(place) > 1
        first, last = first[skips], last[skips]
        chord = _sizes(flat[last] - flat[first])
        chords = [*chords[-1:], _Chords(np.stack([place[first], place[last]], axis=1), chord)]
        # Skipped ends of pieces that save nothing may be kinks, whose hollows show on finer steps.
        worth = _polygon_arcs(flat, first, last) - chord > NEGLIGIBLE * loop.length
        worth |= np.floor(place[first]) != np.floor(place[last])
        ends = np.concatenate([first[worth], last[worth]])
        steps = np.concatenate([ends - 1, ends, _concave_steps(samples, corners, turn)])
        steps = _passed_on(flat, steps % len(place), CLOSE * loop.length)
        new = _between(place, steps, float(loop.count))
        if not len(new):
            break
        samples, number = samples.joined(_Samples.at(loop, to_frame, new))
        # What lies inside the hull of some samples lies inside that of more.
        rows = np.unique(np.concatenate([number[corners], number[len(place) :]]))
    saved = chords[-1].saved(loop)
    total = loop.length - float(saved.sum())
    before = loop.length - float(chords[0].saved(loop).sum()) if len(chords) > 1 else total
    spans = chords[-1].ends[saved > NEGLIGIBLE * loop.length]
    bridges = loop.positions_at(spans.ravel()).reshape(-1, 2, 3)
    return Hull(total, loop.error_estimate + abs(before - total), bridges, spans)


def _passed_on(flat: Array, steps: Ints, close: float) -> Ints:
    """Return steps, but in place of those no longer than `close` the ones on both sides of them."""
    short = _sizes(np.roll(flat, -1, axis=0) - flat) <= close
    # Samples that short steps join have one number; the last ones may be joined to the first.
    number = np.cumsum(~np.roll(short, 1), dtype=np.int64)
    number %= number[-1]
    touched = np.isin(number, number[steps[short[steps]]])
    chosen = touched | np.roll(touched, -1)
    chosen[steps] = True
    return np.flatnonzero(chosen & ~short)


def _polygon_arcs(flat: Array, first: Ints, last: Ints) -> Array:
    """Return the lengths of the polygon of samples from some rows forwards to others."""
    sides = _sizes(np.roll(flat, -1, axis=0) - flat)
    way = np.concatenate([[0.0], np.cumsum(sides)])
    arc = way[last] - way[first]
    return np.asarray(np.where(last < first, arc + way[-1], arc))


def _outer_corners(flat: Array, end: int, turn: float, rows: Ints) -> Ints:
    """Samples on the hull of what lies outwards of the chord from the first to the one at `end`."""
    chord = flat[end] - flat[0]
    length = np.linalg.norm(chord)
    along = (flat[: end + 1] - flat[0]) @ chord / length**2
    outwards = np.sign(turn) / length * _cross(flat[: end + 1] - flat[0], chord[None])
    at = np.flatnonzero((outwards[1:] > 0.0) != (outwards[:-1] > 0.0))
    step = outwards[at] / (outwards[at] - outwards[at + 1])
    crossed = along[at] + step * (along[at + 1] - along[at])
    if ((crossed < -BEYOND) | (crossed > 1.0 + BEYOND)).any():
        raise InputError(
            "the surface winds about an end of the tape, so that a taut tape has no clear way out; "
            "choose ends that lie open, or measure along the skin"
        )
    if not (outwards > FLAT * length).any():
        return np.array([0, end])
    # All that is kept lies to one side of the chord, so that the chord is a side of its hull.
    rows = rows[rows <= end]
    kept = np.union1d(rows[outwards[rows] > 0.0], [0, end])
    return np.union1d(_hull_corners(flat, kept), [0, end])


def _hull_corners(flat: Array, rows: Ints) -> Ints:
    """Return which of some rows of samples are on their convex hull, in the curve's order."""
    corners = rows[_planar_hull(flat[rows])]
    if abs(signed_area(flat[corners])) <= LINE * _perimeter(flat[corners]) ** 2:
        raise InputError(
            "the section is as flat as a line, so it has no convex hull; move or tilt the plane"
        )
    ordered = np.sort(corners)
    around, along = (_perimeter(flat[order]) for order in (corners, ordered))
    if along > around * (1.0 + ORDER_TOLERANCE):
        raise InputError(
            "the section crosses itself, so that a tape around it has no clear path; check the "
            "atlas for parts that intersect, or move the plane"
        )
    return ordered


def _planar_hull(flat: Array) -> Ints:
    """Return the corners of the convex hull of points, in order round it; of a line two or none."""
    if is_compiled():
        return planar_hull(flat)
    try:
        return np.asarray(scipy.spatial.ConvexHull(flat).vertices, dtype=np.int64)
    except scipy.spatial.QhullError:
        return np.empty(0, dtype=np.int64)


def _perimeter(corners: Array) -> float:
    return float(_sizes(corners - np.roll(corners, 1, axis=0)).sum())


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
    # The next sample may be no corner: rounding alone tells which of a tiny piece's samples are.
    kink = anticlockwise * _sine(arriving, samples.leaving[there])
    concave |= kink < -STRAIGHT
    # The hollow of a kink reaches into the step after it, too.
    return np.concatenate([steps[concave], steps[concave] + 1])


def _cross(first: Array, second: Array) -> Array:
    return np.asarray(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])


def _sizes(vectors: Array) -> Array:
    return np.asarray(np.hypot(vectors[:, 0], vectors[:, 1]))


def _sine(first: Array, second: Array) -> Array:
    size = _sizes(first) * _sizes(second)
    sine = np.divide(_cross(first, second), size, out=np.zeros_like(size), where=size > 0.0)
    return np.asarray(sine)


def _between(place: Array, steps: Ints, period: float) -> Array:
    """New places in some steps from sample to sample, but in those that are fine."""
    start = place[steps]
    width = (place[(steps + 1) % len(place)] - start) % period
    coarse = width > FINEST
    parts = np.arange(1, CUTS) / CUTS
    return np.asarray((start[coarse, None] + width[coarse, None] * parts) % period).ravel()
