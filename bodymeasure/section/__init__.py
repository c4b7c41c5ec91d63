"""Exact sections of the smooth atlas by planes, their convex hulls and extents."""

from bodymeasure.section.bridged import BridgedLoop
from bodymeasure.section.curve import DRAWN, Curve, DrawnTape, drawn
from bodymeasure.section.hull import Hull, convex_hull, outer_hull, signed_area
from bodymeasure.section.loop import SectionLoop
from bodymeasure.section.part import part, turned
from bodymeasure.section.places import extent, nearest_place, sign_changes
from bodymeasure.section.plane import Plane
from bodymeasure.section.section import PlaneSection, plane_section

__all__ = [
    "DRAWN",
    "BridgedLoop",
    "Curve",
    "DrawnTape",
    "Hull",
    "Plane",
    "PlaneSection",
    "SectionLoop",
    "convex_hull",
    "drawn",
    "extent",
    "nearest_place",
    "outer_hull",
    "part",
    "plane_section",
    "sign_changes",
    "signed_area",
    "turned",
]
