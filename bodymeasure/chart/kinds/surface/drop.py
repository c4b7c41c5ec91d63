"""Measurements down or up a vertical plane."""

from collections.abc import Mapping
from typing import ClassVar, Literal

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass, length_class
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Landmark
from bodymeasure.chart.input.slopes import end_slopes, level_slope, plane_slope
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, TapeWanted
from bodymeasure.chart.kinds.taped import taped
from bodymeasure.measure import vertical_drop


class DropMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="drop"):
    """The length along the surface in a vertical plane, from a landmark down or up to a level.

    Parameters
    ----------
    start : str
        The landmark at which the tape starts and through which the plane runs.
    level : str
        The landmark at whose height the tape ends.
    plane : {"median", "side"}
        Whether the plane runs from front to back or from left to right.
    tape : {"contact", "taut", "both"}
    """

    example: ClassVar[str] = 'start = "back neck point"\nlevel = "back waist point"'

    start: Landmark
    level: Landmark
    plane: Literal["median", "side"] = "median"
    tape: TapeWanted = "contact"

    @property
    def accuracy_class(self) -> AccuracyClass:
        return length_class(self.name)

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        start, level = body.point(self.start), body.point(self.level)
        found = vertical_drop(body.atlas, start, level, plane=self.plane)
        return taped(body, self, self.tape, found, found.arc.length_by_region)

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        axes, tape = body.atlas.axes, found.tape
        aside = axes.left_vector if self.plane == "median" else axes.front_vector
        start = end_slopes(tape, {self.start: body.position(self.start)})[self.start]
        level = level_slope(tape, axes.up_vector)
        return {self.start: start + plane_slope(tape, aside) * aside, self.level: level}
