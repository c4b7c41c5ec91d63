"""The front or the back of a horizontal girth."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import ClassVar, Literal

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Fault, Landmark
from bodymeasure.chart.input.slopes import end_slopes, plane_slope
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, TapeWanted
from bodymeasure.chart.kinds.taped import sentence, taped
from bodymeasure.measure import girth_arc


class GirthArcMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="girth arc"):
    """The front or the back part of the horizontal girth at a landmark's height.

    With one `tape`, both parts together are the girth. Where a taut tape spans a hollow in which
    the arc ends, the arc ends on the tape, square across from there.

    Parameters
    ----------
    at : str
        The landmark at whose height the girth is taken.
    start, end : str
        Two landmarks, one at the left and one at the right: the arc runs between the places of the
        girth that are nearest to them.
    side : {"front", "back"}
    tape : {"contact", "taut", "both"}
    cut : tuple of (str, str), optional
        Two armpits at which arms are cut off, as for a girth.
    """

    example: ClassVar[str] = """
        at = "side hip point left"
        start = "side hip point left"
        end = "side hip point right"
        side = "front"
    """

    at: Landmark
    start: Landmark
    end: Landmark
    side: Literal["front", "back"]
    tape: TapeWanted = "taut"
    cut: tuple[Landmark, Landmark] | None = None

    @property
    def accuracy_class(self) -> AccuracyClass:
        return AccuracyClass.SEGMENT_LENGTH

    def faults(self) -> Iterator[Fault]:
        return self.same_place("end", self.start, self.end)

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        start, end = body.position(self.start), body.position(self.end)
        girth = body.level_girth(self.at, cut=self.cut)
        arc = girth_arc(girth, start, end, body.atlas.axes.front_vector, self.side)
        found = taped(body, self, self.tape, arc, arc.length_by_region)
        return replace(found, reason=sentence(girth.remark))

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        up = body.atlas.axes.up_vector
        slopes = end_slopes(
            found.tape, {name: body.position(name) for name in (self.start, self.end)}
        )
        # The ends follow their landmarks to the sides, but not up and down.
        slopes = {name: slope - (slope @ up) * up for name, slope in slopes.items()}
        height = plane_slope(found.tape, up) * up
        return {**slopes, self.at: slopes.get(self.at, 0.0) + height}
