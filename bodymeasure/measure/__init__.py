"""Measurements of an atlas: diagonals and boundary curves of patches, girths, straight measures.

What measures bodies across patches is loaded when it is first asked for.
"""

from typing import TYPE_CHECKING

from bodymeasure.lazy import loader
from bodymeasure.measure.patches.boundary import BoundaryLengths, boundary_lengths
from bodymeasure.measure.patches.diagonals import diagonals
from bodymeasure.measure.patches.many_bodies import DiagonalArrays, diagonals_of_bodies
from bodymeasure.measure.patches.survey import Survey, measure_atlas, package_versions

__all__ = [
    "BoundaryLengths",
    "DiagonalArrays",
    "Drop",
    "ExtremeGirth",
    "Extremum",
    "Girth",
    "GirthArc",
    "Survey",
    "body_girth",
    "boundary_lengths",
    "breadth",
    "chord",
    "closed_geodesic",
    "depth",
    "diagonals",
    "diagonals_of_bodies",
    "extreme_girth",
    "fork_point",
    "girth_arc",
    "height",
    "limb_girth",
    "measure_atlas",
    "package_versions",
    "plane_girth",
    "vertical_drop",
]

if TYPE_CHECKING:
    from bodymeasure.measure.body.closed_girth import closed_geodesic
    from bodymeasure.measure.body.drops import Drop, vertical_drop
    from bodymeasure.measure.body.extreme_girth import ExtremeGirth, Extremum, extreme_girth
    from bodymeasure.measure.body.forks import fork_point
    from bodymeasure.measure.body.girth_arcs import GirthArc, girth_arc
    from bodymeasure.measure.body.girths import Girth, body_girth, limb_girth, plane_girth
    from bodymeasure.measure.body.straight import breadth, chord, depth, height
else:
    __getattr__ = loader(
        __name__,
        __all__,
        (
            "body.closed_girth",
            "body.drops",
            "body.extreme_girth",
            "body.forks",
            "body.girth_arcs",
            "body.girths",
            "body.straight",
        ),
    )
