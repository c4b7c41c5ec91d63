"""A taut tape down the front of the body, over another tape that spans a hollow."""

from collections.abc import Mapping
from typing import ClassVar, NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass, length_class
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Landmark
from bodymeasure.chart.input.slopes import end_slopes, level_slope, tape_slopes
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, Outcome
from bodymeasure.chart.tapes import Tape, TapeKind
from bodymeasure.measure import vertical_drop
from bodymeasure.section import SectionLoop

# The number of points on each piece of the profile.
SAMPLES = 256
# A chain of chords falls short of its arc by an amount that grows with the square of their length.
# Chords twice as long fall short four times as much, so that the two chains differ by three times
# what the finer one lacks.
REST = 1.0 / 3.0
# Points that stand out by less than this fraction of the chord lie on it, except for rounding.
STANDING_OUT = 1e-12


class Profile(NamedTuple):
    """The profile and the point over which a tape in a vertical plane passes.

    Parameters
    ----------
    arc : SectionLoop
        The body's profile, from the tape's start to its end.
    over : ndarray, shape (3,)
        A point that the tape has to pass over as well.
    outwards : ndarray, shape (3,)
        The unit vector across the line from start to end, in the plane, away from the body.
    """

    arc: SectionLoop
    over: Array
    outwards: Array


class OverMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="over"):
    """The length of a taut tape in a vertical plane that also passes over another, straight tape.

    The plane runs from front to back.

    Parameters
    ----------
    start : str
        The landmark at which the tape starts and through which the plane runs.
    level : str
        The landmark at whose height the tape ends.
    over : tuple of (str, str)
        The landmarks between which the straight tape runs, such as the bust points; the measured
        tape passes over its middle.
    """

    example: ClassVar[str] = """
        start = "front neck point"
        level = "front waist point"
        over = ["bust point left", "bust point right"]
    """

    start: Landmark
    level: Landmark
    over: tuple[Landmark, Landmark]

    @property
    def accuracy_class(self) -> AccuracyClass:
        return length_class(self.name)

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        profile = profile_of(body, self)
        arc = profile.arc
        coarse, _ = taut_corners(profile, SAMPLES // 2)
        fine, places = taut_corners(profile, SAMPLES)
        rest = REST * (_length(fine) - _length(coarse))
        length = _length(fine) + rest
        return Measured(
            self,
            Outcome.MEASURED,
            value=length,
            taut=length,
            error_estimate=abs(rest) + arc.error_estimate,
            landmarks=self.landmarks,
            tapes=(_tape(body, arc, fine, places),),
        )

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        start = end_slopes(found.tape, {self.start: body.position(self.start)})
        middle = _middle(body, self.start, self.over)
        half = 0.5 * tape_slopes(found.tape, {"": middle})[""]
        level = level_slope(found.tape, body.atlas.axes.up_vector)
        return {**start, self.level: level, **dict.fromkeys(self.over, half)}


def profile_of(body: Body, definition: OverMeasure) -> Profile:
    """Return the profile along which a tape is measured."""
    start, level = body.point(definition.start), body.point(definition.level)
    arc = vertical_drop(body.atlas, start, level).arc
    middle = _middle(body, definition.start, definition.over)
    return Profile(arc, middle, _outwards(body, definition.start, arc))


def _middle(body: Body, start: str, over: tuple[str, str]) -> Array:
    """Return the middle between two landmarks, moved sideways into the tape's plane."""
    left = body.atlas.axes.left_vector
    middle = 0.5 * (body.position(over[0]) + body.position(over[1]))
    return np.asarray(middle + ((body.position(start) - middle) @ left) * left)


def _outwards(body: Body, start: str, arc: SectionLoop) -> Array:
    """Return the unit vector across the tape's chord, to the skin's outer side at its start."""
    first, last = arc.positions_at(np.array([0.0, float(arc.count)]))
    across = np.cross(body.atlas.axes.left_vector, last - first)
    across /= np.linalg.norm(across)
    point = body.point(start)
    normal = body.normals(np.array([point.patch]), np.array([[point.u, point.v]]))[0]
    return np.asarray(across if normal @ across >= 0.0 else -across)


def taut_corners(profile: Profile, count: int) -> tuple[Array, Array]:
    """Return the corners of the tape, and their places on the profile (NaN where it stands free).

    The tape is the convex hull of all that stands out beyond the line from start to end.
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
    # Both ends are corners, one beside the other: the tape runs the other way round.
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
