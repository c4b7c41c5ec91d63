"""Landmarks on horizontal sections."""

from typing import ClassVar

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.entry import Landmark
from bodymeasure.chart.landmarks.rules.base import Facing, LandmarkRule, Landmarks, towards
from bodymeasure.chart.landmarks.rules.outermost import outermost


class Level(LandmarkRule, frozen=True, kw_only=True, tag="level"):
    """The outermost point, in a direction, of the horizontal section at a landmark's height.

    Parameters
    ----------
    of : str
        The landmark; the loop of the section that passes closest to it is taken.
    facing : {"front", "back", "left", "right", "{side}"}
    """

    example: ClassVar[str] = 'of = "front waist point"\nfacing = "left"'

    of: Landmark
    facing: Facing

    @property
    def description(self) -> str:
        return f"outermost {towards(self.facing)} at the height of {self.of}"

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        return outermost(atlas, atlas.position(landmarks[self.of]), self.facing)
