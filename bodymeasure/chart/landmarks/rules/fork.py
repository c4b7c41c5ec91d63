"""Landmarks where parts of the body divide: armpit and crotch."""

from collections.abc import Iterator
from typing import ClassVar

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.entry import Fault, Landmark
from bodymeasure.chart.landmarks.rules.base import LandmarkRule, Landmarks
from bodymeasure.measure.body.forks import fork_between, fork_point


class Fork(LandmarkRule, frozen=True, kw_only=True, tag="fork"):
    """The point where two parts of the body divide, going down.

    It is the saddle of the height at which the horizontal section's loop divides into one for each
    of two regions, or of two landmarks.

    Parameters
    ----------
    regions : tuple of (str, str), optional
        The beginnings of the regions' names.
    parts : tuple of (str, str), optional
        Landmarks on the two parts, well below the fork, which serve bodies without regions, too.
    """

    example: ClassVar[str] = 'parts = ["side waist point left", "elbow point left"]'

    regions: tuple[str, str] | None = None
    parts: tuple[Landmark, Landmark] | None = None

    @property
    def description(self) -> str:
        if self.parts is not None:
            return f"where the parts of {self.parts[0]} and {self.parts[1]} divide"
        first, second = self.regions or ("", "")
        return f"where {first} and {second} divide"

    def faults(self) -> Iterator[Fault]:
        if (self.regions is None) == (self.parts is None):
            yield Fault(self, "", "give either regions or parts")

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        if self.parts is not None:
            first, second = (landmarks[name] for name in self.parts)
            return fork_between(atlas, (first, second))
        assert self.regions is not None
        return fork_point(atlas, self.regions)
