"""The largest or smallest girth of a stretch."""

from collections.abc import Mapping
from typing import ClassVar, Literal

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass, girth_class
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Landmark
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, TapeWanted
from bodymeasure.chart.kinds.taped import taped_girth
from bodymeasure.measure import Extremum, extreme_girth


class ExtremeGirthMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="extreme girth"):
    """The largest or smallest girth between two landmarks.

    Parameters
    ----------
    start, end : str
        The two landmarks.
    extreme : {"largest", "smallest"}
    limb : bool
        Whether the girths are square to the line between the landmarks, and not horizontal.
    tape : {"contact", "taut", "both"}
    """

    example: ClassVar[str] = """
        start = "patella point left"
        end = "ankle point left"
        extreme = "largest"
    """

    start: Landmark
    end: Landmark
    extreme: Literal["largest", "smallest"]
    limb: bool = False
    tape: TapeWanted = "taut"

    @property
    def accuracy_class(self) -> AccuracyClass:
        return AccuracyClass.SMALL_GIRTH if self.limb else girth_class(self.name)

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        extreme = extreme_girth(
            body.atlas,
            body.point(self.start),
            body.point(self.end),
            self.extreme,
            tape="contact" if self.tape == "contact" else "taut",
            limb=self.limb,
        )
        inside = extreme.status is Extremum.INSIDE
        remark = "" if inside else f"The extreme is {extreme.status.value}."
        return taped_girth(body, self, self.tape, extreme.girth, remark)

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        # Where a girth is the largest or the smallest, its height makes no difference.
        return {}
