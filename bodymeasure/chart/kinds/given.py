"""Lengths that are given with the body, because its atlas does not show them."""

from collections.abc import Mapping
from typing import ClassVar

from bodymeasure.chart.accuracy import AccuracyClass
from bodymeasure.chart.body import Body, MissingLandmarkError
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition


class GivenMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="given"):
    """A length that is given with the body under the measurement's key.

    A body that was fitted whole has lengths of its head, hands and feet, which its atlas leaves
    out, and others may be taken by hand. Measurements of the other kinds take a given length, too,
    where a landmark is missing.

    Parameters
    ----------
    accuracy : {"height", "segment length", "breadth", "depth", "large girth", "small girth"}
        The class of the measurement in ISO 20685-1.
    """

    example: ClassVar[str] = 'accuracy = "small girth"'

    accuracy: AccuracyClass

    @property
    def accuracy_class(self) -> AccuracyClass:
        return self.accuracy

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        raise MissingLandmarkError(
            f"the body gives no {self.key!r}; a fit of the whole body does, or the member `given` "
            "of the .atlas file"
        )
