"""Catmull-Clark surfaces of quadrilateral meshes: subdivision, limit positions, patches, parts."""

from bodymeasure.subdivision.catmull_clark import limit_positions, subdivide
from bodymeasure.subdivision.loop_schaefer import PatchNets, loop_schaefer
from bodymeasure.subdivision.part import children, fill_pinches, part, quads_within
from bodymeasure.subdivision.polygon_mesh import PolygonMesh
from bodymeasure.subdivision.polygons import quads_of
from bodymeasure.subdivision.quad_mesh import QuadMesh, triangles

__all__ = [
    "PatchNets",
    "PolygonMesh",
    "QuadMesh",
    "children",
    "fill_pinches",
    "limit_positions",
    "loop_schaefer",
    "part",
    "quads_of",
    "quads_within",
    "subdivide",
    "triangles",
]
