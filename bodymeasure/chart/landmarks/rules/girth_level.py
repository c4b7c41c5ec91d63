"""Landmarks where the girth is extreme."""

from typing import ClassVar, Literal, NamedTuple

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.entry import Landmark
from bodymeasure.chart.landmarks.rules.base import Facing, LandmarkRule, Landmarks, towards
from bodymeasure.chart.landmarks.rules.outermost import outermost
from bodymeasure.errors import InputError
from bodymeasure.measure import Extremum, extreme_girth
from bodymeasure.measure.body.girths import section_loop
from bodymeasure.section import Plane, convex_hull

# The width of the steps by which the slope is found, as a fraction of the stretch. Girths hold to
# 1e-13, so that their slope over such steps holds to 1e-10; what the formula of four steps leaves
# out is as small.
STEP = 2e-3
# The most Newton steps; so near the extreme, the slope is almost straight.
ROUNDS = 3
# If the extreme is farther than this fraction of the stretch from where the search ended, the girth
# has a kink.
FARTHEST = 1e-4


class GirthLevel(LandmarkRule, frozen=True, kw_only=True, tag="girth level"):
    """A point at the height where the girth between two landmarks is the largest or smallest.

    Parameters
    ----------
    start, end : str
        The two landmarks.
    extreme : {"largest", "smallest"}
        Which girth is meant; the tape is drawn taut.
    facing : {"front", "back", "left", "right", "{side}"}
        The direction in which the point is the outermost of the girth.
    """

    example: ClassVar[str] = """
        start = "front waist point"
        end = "bust point left"
        extreme = "smallest"
        facing = "front"
    """

    start: Landmark
    end: Landmark
    extreme: Literal["largest", "smallest"]
    facing: Facing

    @property
    def description(self) -> str:
        return (
            f"outermost {towards(self.facing)} at the {self.extreme} girth from {self.start} to "
            f"{self.end}"
        )

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        start, end = (atlas.position(landmarks[name]) for name in (self.start, self.end))
        found = extreme_girth(atlas, start, end, self.extreme, tape="taut")
        if found.status is not Extremum.INSIDE:
            # A more extreme girth may lie beyond the end.
            raise InputError(
                f"the {self.extreme} girth from {self.start!r} to {self.end!r} is {found.status}"
            )
        stretch = _Stretch(atlas, start, end)
        return outermost(atlas, stretch.point(_where_level(stretch, found.fraction)), self.facing)


class _Stretch(NamedTuple):
    """The positions from one to another, and the horizontal girths at their heights."""

    atlas: Atlas
    start: Array
    end: Array

    def point(self, fraction: float) -> Array:
        return self.start + fraction * (self.end - self.start)

    def girth(self, fraction: float) -> float:
        point = self.point(fraction)
        plane = Plane(point, self.atlas.axes.up_vector)
        return convex_hull(section_loop(self.atlas, plane, point)).length


def _where_level(stretch: _Stretch, fraction: float) -> float:
    """Return the fraction at which the girth's slope vanishes, searched from one that is close.

    A search by the girth's values alone finds half of the digits.
    """
    start = fraction
    for _ in range(ROUNDS):
        values = [stretch.girth(fraction + k * STEP) for k in (-2, -1, 0, 1, 2)]
        slope = (values[0] - 8.0 * values[1] + 8.0 * values[3] - values[4]) / 12.0
        bend = (
            -values[0] + 16.0 * values[1] - 30.0 * values[2] + 16.0 * values[3] - values[4]
        ) / 12.0
        if bend == 0.0:
            return start
        fraction -= STEP * slope / bend
        if abs(fraction - start) > FARTHEST:
            return start
    return fraction
