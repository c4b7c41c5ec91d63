"""Exact sections of the smooth atlas by planes, their convex hulls and extents."""

from bodymeasure.section.extent import extent
from bodymeasure.section.hull import Hull, convex_hull
from bodymeasure.section.loop import SectionLoop
from bodymeasure.section.plane import Plane
from bodymeasure.section.section import PlaneSection, plane_section

__all__ = [
    "Hull",
    "Plane",
    "PlaneSection",
    "SectionLoop",
    "convex_hull",
    "extent",
    "plane_section",
]
