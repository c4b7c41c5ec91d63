"""Landmarks where parts of the body divide: armpit and crotch."""

from typing import ClassVar

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.landmarks.rules.base import LandmarkRule, Landmarks
from bodymeasure.measure.body.forks import fork_point


class Fork(LandmarkRule, frozen=True, kw_only=True, tag="fork"):
    """The point where two parts of the body divide, going down.

    It is the saddle of the height at which the horizontal section's loop divides into one for each
    of two regions.

    Parameters
    ----------
    regions : tuple of (str, str)
        The beginnings of the regions' names.
    """

    example: ClassVar[str] = 'regions = ["torso", "upper arm left"]'

    regions: tuple[str, str]

    @property
    def description(self) -> str:
        return f"where {self.regions[0]} and {self.regions[1]} divide"

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        return fork_point(atlas, self.regions)
