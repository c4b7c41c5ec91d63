"""The landmark among several that lies farthest in a direction."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.entry import Fault, Landmark
from bodymeasure.chart.landmarks.choice import TIE, direction_vector, preferred
from bodymeasure.chart.landmarks.rules.base import Direction, LandmarkRule, Landmarks, towards
from bodymeasure.geodesic.across.routes.topology import extent


class Farthest(LandmarkRule, frozen=True, kw_only=True, tag="farthest"):
    """The landmark among several that lies farthest in a direction, such as the lower of a pair.

    Parameters
    ----------
    of : tuple of str
        The landmarks, at least two.
    direction : {"front", "back", "left", "right", "{side}", "up", "down"}
    """

    example: ClassVar[str] = """
        of = ["bust point left", "bust point right"]
        direction = "down"
    """

    of: tuple[Landmark, ...]
    direction: Direction

    @property
    def description(self) -> str:
        return f"farthest {towards(self.direction)} of {' and '.join(self.of)}"

    def faults(self) -> Iterator[Fault]:
        if len(self.of) < 2:
            yield Fault(self, "of", "of needs two landmarks or more")

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        points = [landmarks[name] for name in self.of]
        positions = np.stack([atlas.position(point) for point in points])
        far = positions @ direction_vector(atlas, self.direction)
        best = np.flatnonzero(far >= far.max() - TIE * extent(atlas))
        return preferred(atlas, [points[int(k)] for k in best])
