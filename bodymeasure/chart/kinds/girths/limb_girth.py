"""Girths of limbs, square to them."""

from collections.abc import Iterator, Mapping
from typing import ClassVar

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Fault, Landmark
from bodymeasure.chart.input.slopes import plane_slope
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, TapeWanted
from bodymeasure.chart.kinds.taped import taped_girth
from bodymeasure.measure import limb_girth


class LimbGirthMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="limb girth"):
    """The girth of a limb, square to the line between two landmarks.

    Parameters
    ----------
    start, end : str
        The two landmarks.
    at : float or str
        The place of the girth: a fraction of the line, from 0 to 1, or a landmark.
    tape : {"contact", "taut", "both"}
    """

    example: ClassVar[str] = 'start = "shoulder point left"\nend = "elbow point left"\nat = 0.5'

    start: Landmark
    end: Landmark
    at: float | Landmark = 0.5
    tape: TapeWanted = "taut"

    @property
    def accuracy_class(self) -> AccuracyClass:
        return AccuracyClass.SMALL_GIRTH

    def faults(self) -> Iterator[Fault]:
        if isinstance(self.at, float) and not 0.0 <= self.at <= 1.0:
            yield Fault(self, "at", f"at is {self.at}; expected 0 to 1, or a landmark's name")

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        place = body.point(self.at) if isinstance(self.at, str) else float(self.at)
        girth = limb_girth(body.atlas, body.point(self.start), body.point(self.end), at=place)
        return taped_girth(body, self, self.tape, girth)

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        line = body.position(self.end) - body.position(self.start)
        along = line / np.linalg.norm(line)
        slope = plane_slope(found.tape, along) * along
        if isinstance(self.at, str):
            return {self.at: slope}
        return {self.start: (1.0 - self.at) * slope, self.end: self.at * slope}
