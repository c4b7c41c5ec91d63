"""Closed geodesics round the body."""

from collections.abc import Mapping
from typing import ClassVar

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass, girth_class
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Landmark
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition
from bodymeasure.chart.kinds.surface.along import along
from bodymeasure.measure import closed_geodesic


class ClosedMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="closed"):
    """The closed geodesic to which a tape slides, laid round the body at a landmark's height.

    It follows the skin, so that there is no tape to choose.

    Parameters
    ----------
    at : str
        The landmark.
    """

    example: ClassVar[str] = 'at = "side waist point left"'

    at: Landmark

    @property
    def accuracy_class(self) -> AccuracyClass:
        return girth_class(self.name)

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        path = closed_geodesic(body.atlas, body.point(self.at), on_failure="status")
        return along(body, self, path)

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        # A tape that slides to where it rests ends there wherever it was laid.
        return {}
