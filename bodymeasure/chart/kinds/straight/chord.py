"""Straight distances between landmarks."""

import re
from collections.abc import Iterator, Mapping
from typing import ClassVar

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass, length_class
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Fault, Landmark
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition
from bodymeasure.chart.kinds.straight.line import straight

_BREADTH = re.compile(r"\bbreadth", re.IGNORECASE)


class ChordMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="chord"):
    """The straight distance between two landmarks.

    Parameters
    ----------
    start, end : str
        The two landmarks.
    """

    example: ClassVar[str] = 'start = "shoulder point left"\nend = "shoulder point right"'

    start: Landmark
    end: Landmark

    @property
    def accuracy_class(self) -> AccuracyClass:
        return AccuracyClass.BREADTH if _BREADTH.search(self.name) else length_class(self.name)

    def faults(self) -> Iterator[Fault]:
        return self.same_place("end", self.start, self.end)

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        start, end = body.position(self.start), body.position(self.end)
        return straight(body, self, float(np.linalg.norm(end - start)), (start, end))

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        line = body.position(self.end) - body.position(self.start)
        along = line / np.linalg.norm(line)
        return {self.start: -along, self.end: along}
