"""Accuracy classes of body measurements, as ISO 20685-1 has them."""

import re
from enum import StrEnum

from bodymeasure.chart.kinds.definitions import Measurement


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

# Kinds of which every one is a girth.
GIRTHS = ("girth", "tilted girth", "extreme girth", "closed")

# The standard's examples are the chest for large girths and the neck for small ones. Those of the
# trunk are taken as large here, all others as small: the stricter reading.
_NOT_TRUNK = re.compile(
    r"neck|head|armscye|thigh|leg|knee|calf|ankle|foot|heel|arm\b|elbow|wrist|hand|biceps",
    re.IGNORECASE,
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
    kind, name = definition.__struct_config__.tag, definition.name
    if getattr(definition, "angle", False):
        return None
    if kind == "girth arc":
        return AccuracyClass.SEGMENT_LENGTH
    if kind == "limb girth" or getattr(definition, "limb", False):
        return AccuracyClass.SMALL_GIRTH
    # A formula may be the sum of arcs, and a path may lead round the body through landmarks.
    if kind in GIRTHS or _GIRTH.search(name):
        small = _NOT_TRUNK.search(name)
        return AccuracyClass.SMALL_GIRTH if small else AccuracyClass.LARGE_GIRTH
    if kind == "height" and getattr(definition, "above", None) is None:
        return AccuracyClass.HEIGHT
    if kind == "breadth" or (kind == "chord" and _BREADTH.search(name)):
        return AccuracyClass.BREADTH
    if kind == "depth":
        return AccuracyClass.DEPTH
    # Among them heights above another landmark than the floor.
    return AccuracyClass.SEGMENT_LENGTH
