"""Geodesics between landmarks, each found once: rules and measurements share them."""

from functools import lru_cache

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.geodesic import AtlasPath, geodesic_between


# As many as a large set of measurements of a body needs; a path takes some kilobytes.
@lru_cache(maxsize=512)
def leg(atlas: Atlas, start: AtlasPoint, end: AtlasPoint) -> AtlasPath:
    """The geodesic between two points; what became of it is in its status."""
    return geodesic_between(atlas, start, end, on_failure="status")
