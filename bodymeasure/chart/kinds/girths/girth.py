"""Horizontal girths."""

from collections.abc import Iterator, Mapping
from typing import ClassVar

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass, girth_class
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Fault, Landmark
from bodymeasure.chart.input.slopes import plane_slope
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, TapeWanted
from bodymeasure.chart.kinds.taped import taped_girth


class GirthMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="girth"):
    """The horizontal girth of the trunk or of a limb at a landmark's height.

    Parameters
    ----------
    at : str
        The landmark, which lies on the part of the body that is measured.
    tape : {"contact", "taut", "both"}
    cut : tuple of (str, str), optional
        Two landmarks (armpits) in whose vertical front-to-back planes a loop that merges trunk and
        arms is cut; the gaps are bridged straight.
    limb : bool
        Whether the loop has to go round one leg or arm alone.
    """

    example: ClassVar[str] = 'at = "bust point left"'

    at: Landmark
    tape: TapeWanted = "taut"
    cut: tuple[Landmark, Landmark] | None = None
    limb: bool = False

    @property
    def accuracy_class(self) -> AccuracyClass:
        return AccuracyClass.SMALL_GIRTH if self.limb else girth_class(self.name)

    def faults(self) -> Iterator[Fault]:
        if self.limb and self.cut is not None:
            yield Fault(self, "cut", "cut is for the trunk, limb for a leg or arm; give one")

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        girth = body.level_girth(self.at, cut=self.cut, limb=self.limb)
        return taped_girth(body, self, self.tape, girth)

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        up = body.atlas.axes.up_vector
        return {self.at: plane_slope(found.tape, up) * up}
