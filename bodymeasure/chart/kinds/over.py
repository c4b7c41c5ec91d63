"""A tape down the middle of the body, over another tape that spans a hollow."""

from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.chart.body import Body
from bodymeasure.chart.chart import Measured, Outcome, Tape, TapeKind
from bodymeasure.chart.kinds.definitions import OverMeasure
from bodymeasure.measure import vertical_drop
from bodymeasure.section import SectionLoop

# Points on each piece of the profile.
SAMPLES = 256
# A chain of chords falls short of its arc by what goes with the square of their lengths: chords
# twice as long fall short four times as much, three times more than what the shorter ones lack.
REST = 1.0 / 3.0
# Of the chord: points that stand out less are on it, but for rounding.
STANDING_OUT = 1e-12


class _Profile(NamedTuple):
    """What a tape in a vertical plane passes over.

    Parameters
    ----------
    arc : SectionLoop
        The body's profile, from the tape's start to its end.
    over : ndarray, shape (3,)
        A point that it has to go round as well.
    outwards : ndarray, shape (3,)
        Across the line from start to end, in the plane, away from the body.
    """

    arc: SectionLoop
    over: Array
    outwards: Array


def measure_over(body: Body, definition: OverMeasure) -> Measured:
    """A drop, taut, and over the middle of a straight line between two landmarks."""
    start, level, over = definition.start, definition.level, definition.over
    arc = vertical_drop(body.atlas, body.point(start), body.point(level)).arc
    profile = _Profile(arc, _middle(body, start, over), _outwards(body, start, arc))
    coarse, _ = _hull(profile, SAMPLES // 2)
    fine, places = _hull(profile, SAMPLES)
    rest = REST * (_length(fine) - _length(coarse))
    length = _length(fine) + rest
    return Measured(
        definition,
        Outcome.MEASURED,
        value=length,
        taut=length,
        error_estimate=abs(rest) + arc.error_estimate,
        landmarks=(start, level, *over),
        tapes=(_tape(body, arc, fine, places),),
    )


def _middle(body: Body, start: str, over: tuple[str, str]) -> Array:
    """The middle between two landmarks, moved sideways into the tape's plane."""
    left = body.atlas.axes.left_vector
    middle = 0.5 * (body.position(over[0]) + body.position(over[1]))
    return np.asarray(middle + ((body.position(start) - middle) @ left) * left)


def _outwards(body: Body, start: str, arc: SectionLoop) -> Array:
    """Across the chord of the tape, to the side on which the skin at its start faces."""
    first, last = arc.positions_at(np.array([0.0, float(arc.count)]))
    across = np.cross(body.atlas.axes.left_vector, last - first)
    across /= np.linalg.norm(across)
    point = body.point(start)
    normal = body.normals(np.array([point.patch]), np.array([[point.u, point.v]]))[0]
    return np.asarray(across if normal @ across >= 0.0 else -across)


def _hull(profile: _Profile, count: int) -> tuple[Array, Array]:
    """The tape over points of the profile, and their places on it; NaN where it stands free.

    What stands out beyond the line from start to end is gone round, as a convex hull.
    """
    arc = profile.arc
    place = np.append(np.arange(count * arc.count + 1) / count, np.nan)
    points = np.concatenate([arc.positions_at(place[:-1]), profile.over[None]])
    first, last = points[0], points[-2]
    chord = last - first
    size = float(np.linalg.norm(chord))
    out = (points - first) @ profile.outwards
    out[[0, -2]] = 0.0
    kept = np.flatnonzero(out > STANDING_OUT * size)
    if not len(kept):
        ends = np.array([0, len(points) - 2])
        return points[ends], place[ends]
    kept = np.concatenate([[0], kept, [len(points) - 2]])
    flat = np.stack([(points[kept] - first) @ chord / size, out[kept]], axis=1)
    corners = scipy.spatial.ConvexHull(flat).vertices
    # Both ends are corners, side by side: the way round is the other one.
    corners = np.roll(corners, -int(np.flatnonzero(corners == 0)[0]))
    if corners[1] == len(kept) - 1:
        corners = np.roll(corners[::-1], 1)
    return points[kept[corners]], place[kept[corners]]


def _length(points: Array) -> float:
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def _tape(body: Body, arc: SectionLoop, points: Array, places: Array) -> Tape:
    on_skin = np.isfinite(places)
    normals = np.zeros_like(points)
    normals[on_skin] = body.normals(*arc.surface_points_at(places[on_skin]))
    return Tape(TapeKind.TAUT, points, normals)
