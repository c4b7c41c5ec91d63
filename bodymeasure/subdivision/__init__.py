"""Catmull-Clark surfaces of quadrilateral meshes: subdivision, limit positions, parts of a mesh."""

from bodymeasure.subdivision.catmull_clark import limit_positions, subdivide
from bodymeasure.subdivision.part import children, fill_pinches, part, quads_within
from bodymeasure.subdivision.quad_mesh import QuadMesh, triangles

__all__ = [
    "QuadMesh",
    "children",
    "fill_pinches",
    "limit_positions",
    "part",
    "quads_within",
    "subdivide",
    "triangles",
]
