"""Girths in a plane that leans forwards or backwards."""

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from bodymeasure.chart.accuracy import AccuracyClass, girth_class
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Landmark
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, TapeWanted
from bodymeasure.chart.kinds.taped import taped_girth
from bodymeasure.errors import InputError
from bodymeasure.section import Plane


class TiltedGirthMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="tilted girth"):
    """The girth in the plane through two landmarks that is level from left to right.

    It serves for what leans forwards or backwards, such as the neck.

    Parameters
    ----------
    front, back : str
        The two landmarks.
    tape : {"contact", "taut", "both"}
    """

    example: ClassVar[str] = 'front = "front neck point"\nback = "back neck point"'

    front: Landmark
    back: Landmark
    tape: TapeWanted = "taut"

    @property
    def accuracy_class(self) -> AccuracyClass:
        return girth_class(self.name)

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        front, back = body.position(self.front), body.position(self.back)
        normal = np.cross(body.atlas.axes.left_vector, front - back)
        if not normal.any():
            raise InputError(
                f"{self.front!r} and {self.back!r} lie one beside the other or at one place, so "
                "that many planes hold them; choose a front and a back landmark"
            )
        girth = body.girth(Plane(front, normal), self.front)
        return taped_girth(body, self, self.tape, girth)
