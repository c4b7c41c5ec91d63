"""The depth of a horizontal loop."""

from collections.abc import Mapping
from typing import ClassVar

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Landmark
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition
from bodymeasure.chart.kinds.straight.line import extent, extent_slope
from bodymeasure.measure import depth


class DepthMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="depth"):
    """The horizontal distance from front to back of the loop at a landmark's height.

    Parameters
    ----------
    at : str
        The landmark.
    """

    example: ClassVar[str] = 'at = "side hip point left"'

    at: Landmark

    @property
    def accuracy_class(self) -> AccuracyClass:
        return AccuracyClass.DEPTH

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        return extent(body, self, self.at, body.atlas.axes.front_vector, depth)

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        return extent_slope(body, self.at, body.atlas.axes.front_vector)

    def skin(self, body: Body, found: Measured) -> Array:
        return body.level_girth(self.at).contact_tape.positions
