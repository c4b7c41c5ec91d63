"""Landmarks on the way between two others."""

from collections.abc import Iterator
from typing import ClassVar

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.entry import Fault, Landmark
from bodymeasure.chart.landmarks.paths import path_between, point_at
from bodymeasure.chart.landmarks.rules.base import LandmarkRule, Landmarks


class Between(LandmarkRule, frozen=True, kw_only=True, tag="between"):
    """A point of the geodesic between two landmarks.

    Parameters
    ----------
    start, end : str
        The two landmarks.
    fraction : float
        The fraction of the geodesic's length at which the point lies, from 0 to 1.
    """

    example: ClassVar[str] = 'start = "side waist point left"\nend = "side hip point left"'

    start: Landmark
    end: Landmark
    fraction: float = 0.5

    @property
    def description(self) -> str:
        return f"{self.fraction:.4g} of the way from {self.start} to {self.end}"

    def faults(self) -> Iterator[Fault]:
        if not 0.0 <= self.fraction <= 1.0:
            yield Fault(self, "fraction", f"fraction is {self.fraction}; expected 0 to 1")

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        path = path_between(atlas, self.start, self.end, landmarks)
        return point_at(path, self.fraction)
