"""Girths in a plane that leans."""

from collections.abc import Iterator, Mapping
from typing import ClassVar, Literal

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass, girth_class
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Fault, Landmark
from bodymeasure.chart.input.slopes import plane_slope
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, TapeWanted
from bodymeasure.chart.kinds.taped import taped_girth
from bodymeasure.errors import InputError
from bodymeasure.section import Plane

# The second landmark is on the loop of the first if it is no farther from it than this part of the
# girth, which is far more than the spacing of the loop's samples.
ON_LOOP = 0.02
# The loop round a limb ends no farther beyond the landmarks than this part of their distance; that
# of an armhole ends within 0.1 of it beyond the armpit, if the plane does not cut into the trunk.
BEYOND = 0.5


class TiltedGirthMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="tilted girth"):
    """The girth in the plane through two landmarks that is level in one direction.

    It serves for what leans, such as the neck, and for an armhole.

    Parameters
    ----------
    through : tuple of (str, str)
        The two landmarks.
    plane : {"median", "side"}
        Whether the plane is level from front to back or from left to right.
    limb : bool
        Whether the loop has to go round one leg or arm alone.
    tape : {"contact", "taut", "both"}
    """

    example: ClassVar[str] = 'through = ["front neck point", "back neck point"]'

    through: tuple[Landmark, Landmark]
    plane: Literal["median", "side"] = "side"
    limb: bool = False
    tape: TapeWanted = "taut"

    @property
    def accuracy_class(self) -> AccuracyClass:
        return AccuracyClass.SMALL_GIRTH if self.limb else girth_class(self.name)

    def faults(self) -> Iterator[Fault]:
        return self.same_place("through", *self.through)

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        first, second = map(body.position, self.through)
        axes = body.atlas.axes
        level = axes.front_vector if self.plane == "median" else axes.left_vector
        normal = np.cross(level, first - second)
        if not normal.any():
            one, other = self.through
            beside = "before" if self.plane == "median" else "beside"
            raise InputError(
                f"{one!r} and {other!r} lie one {beside} the other or at one place, so that many "
                "planes hold them; choose two that differ in another direction"
            )
        girth = body.girth(Plane(first, normal), self.through[0], limb=self.limb)
        apart = np.linalg.norm(girth.loop.positions - second, axis=1).min()
        if apart > ON_LOOP * girth.contact:
            raise InputError(
                f"the loop at {self.through[0]!r} does not pass {self.through[1]!r}: the plane "
                "cuts two parts of the body; choose landmarks on one of them"
            )
        if self.limb:
            self._refuse_beyond(girth.loop.positions, first, second)
        return taped_girth(body, self, self.tape, girth)

    def _refuse_beyond(self, loop: Array, first: Array, second: Array) -> None:
        """Refuse a loop that runs on from the limb along the trunk."""
        way = (loop - first) @ (second - first) / ((second - first) @ (second - first))
        if way.min() < -BEYOND or way.max() > 1.0 + BEYOND:
            one, other = self.through
            raise InputError(
                f"the loop through {one!r} and {other!r} runs on far beyond them: the plane cuts "
                f"into the trunk; move {other!r} down the limb, or away from the trunk"
            )

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        first, second = map(body.position, self.through)
        line = first - second
        level = body.atlas.axes.front_vector
        level = level if self.plane == "median" else body.atlas.axes.left_vector
        normal = np.cross(level, line)
        normal /= np.linalg.norm(normal)
        # Either landmark turns the plane about the level line through the other.
        across = line - (line @ level) * level
        share = (found.tape.points - second) @ across / (across @ across)
        return {
            name: plane_slope(found.tape, normal, weights) * normal
            for name, weights in zip(self.through, (share, 1.0 - share), strict=True)
        }
