"""Accuracy classes of body measurements, as ISO 20685-1 has them."""

import re
from enum import StrEnum


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
        """Maximum allowable mean difference from a skilled measurer's value, in millimeters.

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

# The standard names the chest as an example of a large girth and the neck as one of a small girth.
# Girths of the trunk are taken as large here, and all others as small, which is the stricter
# reading.
_NOT_TRUNK = re.compile(
    r"neck|head|armscye|thigh|leg|knee|calf|ankle|foot|heel|arm\b|elbow|wrist|hand|biceps",
    re.IGNORECASE,
)
_GIRTH = re.compile(r"\bgirth|\bcircumference", re.IGNORECASE)


def girth_class(name: str) -> AccuracyClass:
    """Return the class of a girth by its name."""
    return AccuracyClass.SMALL_GIRTH if _NOT_TRUNK.search(name) else AccuracyClass.LARGE_GIRTH


def length_class(name: str) -> AccuracyClass:
    """Return the class of a length by its name, which may say that the length is a girth.

    A path may lead round the body through landmarks, and a formula may be a sum of arcs.
    """
    return girth_class(name) if _GIRTH.search(name) else AccuracyClass.SEGMENT_LENGTH
