"""Accuracy classes of body measurements, as ISO 20685-1 has them."""

from __future__ import annotations

import re
from enum import StrEnum

from bodymeasure.chart.definitions import (
    BreadthMeasure,
    ChordMeasure,
    ClosedMeasure,
    DepthMeasure,
    ExtremeGirthMeasure,
    FormulaMeasure,
    GirthMeasure,
    HeightMeasure,
    LimbGirthMeasure,
    Measurement,
)


class AccuracyClass(StrEnum):
    """A class of measurements that share a maximum allowable error."""

    HEIGHT = "height"
    SEGMENT_LENGTH = "segment length"
    BREADTH = "breadth"
    DEPTH = "depth"
    LARGE_GIRTH = "large girth"
    SMALL_GIRTH = "small girth"

    @property
    def maximum_error_mm(self) -> float:
        """Maximum allowable mean difference from a skilled measurer's, in millimeters.

        ISO 20685-1, table 1.
        """
        return _MAXIMUM_ERROR_MM[self]


_MAXIMUM_ERROR_MM = {
    AccuracyClass.HEIGHT: 4.0,
    AccuracyClass.SEGMENT_LENGTH: 5.0,
    AccuracyClass.BREADTH: 4.0,
    AccuracyClass.DEPTH: 5.0,
    AccuracyClass.LARGE_GIRTH: 9.0,
    AccuracyClass.SMALL_GIRTH: 4.0,
}

# The standard's examples are the chest for large girths and the neck for small ones. Those of the
# trunk are taken as large here, all others as small: the stricter reading.
_NOT_TRUNK = re.compile(
    r"neck|head|thigh|leg|knee|calf|ankle|foot|heel|arm\b|elbow|wrist|hand|biceps", re.IGNORECASE
)
_GIRTH = re.compile(r"\bgirth|\bcircumference", re.IGNORECASE)
_BREADTH = re.compile(r"\bbreadth", re.IGNORECASE)


def accuracy_class(definition: Measurement) -> AccuracyClass | None:
    """The class of a measurement, by its kind and, where that leaves it open, its name.

    Parameters
    ----------
    definition : Measurement

    Returns
    -------
    AccuracyClass or None
        None for angles, which the standard has no class for.
    """
    name = definition.name
    match definition:
        case FormulaMeasure(angle=True):
            return None
        case LimbGirthMeasure() | ExtremeGirthMeasure(limb=True):
            return AccuracyClass.SMALL_GIRTH
        case GirthMeasure() | ExtremeGirthMeasure() | ClosedMeasure():
            return _girth_class(name)
        case HeightMeasure(above=above):
            # From one landmark to another it is the length of a segment.
            return AccuracyClass.HEIGHT if above is None else AccuracyClass.SEGMENT_LENGTH
        case BreadthMeasure():
            return AccuracyClass.BREADTH
        case DepthMeasure():
            return AccuracyClass.DEPTH
        case ChordMeasure() if _BREADTH.search(name):
            return AccuracyClass.BREADTH
        case _ if _GIRTH.search(name):
            # Through landmarks round the body, or the sum of arcs.
            return _girth_class(name)
        case _:
            return AccuracyClass.SEGMENT_LENGTH


def _girth_class(name: str) -> AccuracyClass:
    return AccuracyClass.SMALL_GIRTH if _NOT_TRUNK.search(name) else AccuracyClass.LARGE_GIRTH
