"""Vertical distances."""

from collections.abc import Iterator, Mapping
from typing import ClassVar

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Fault, Landmark
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition
from bodymeasure.chart.kinds.straight.line import straight
from bodymeasure.errors import InputError

# Soles may reach below the floor by at most this fraction of the body's extent, as a scan's do.
SUNKEN = 0.02


class HeightMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="height"):
    """The vertical distance of a landmark from the floor, or from another landmark.

    The floor is where the coordinate along the atlas's way up is 0. The lowest point of an atlas
    does not tell where it is, because an atlas may end above the ankles.

    Parameters
    ----------
    at : str
        The landmark.
    above : str, optional
        The other landmark; the floor if not given.
    """

    example: ClassVar[str] = 'at = "back neck point"\nabove = "crotch point"'

    at: Landmark
    above: Landmark | None = None

    @property
    def accuracy_class(self) -> AccuracyClass:
        return AccuracyClass.HEIGHT if self.above is None else AccuracyClass.SEGMENT_LENGTH

    def faults(self) -> Iterator[Fault]:
        return self.same_place("above", self.at, self.above)

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        up = body.atlas.axes.up_vector
        top = body.position(self.at)
        if self.above is None:
            _require_floor(body)
        floor = 0.0 if self.above is None else float(body.position(self.above) @ up)
        height = float(top @ up) - floor
        return straight(body, self, abs(height), (top, top - height * up))

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        up = body.atlas.axes.up_vector
        if self.above is None:
            return {self.at: up}
        sign = np.sign((body.position(self.at) - body.position(self.above)) @ up)
        return {self.at: sign * up, self.above: -sign * up}


def _require_floor(body: Body) -> None:
    """Refuse a body that reaches below the floor."""
    degree, unit = body.atlas.degree, body.atlas.unit
    numbers = body.atlas.index[:, ::degree, ::degree]
    corners = body.atlas.points[numbers] @ body.atlas.axes.up_vector
    low, high = float(corners.min()), float(corners.max())
    if low < -SUNKEN * (high - low):
        raise InputError(
            f"the body reaches {-low:.4g} {unit} below the floor, which is where the coordinate "
            "along the way up is 0; move the body onto the floor, or check the atlas's axes"
        )
