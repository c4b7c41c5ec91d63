"""Catmull-Clark surfaces of quadrilateral meshes: subdivision, limit positions, patches, parts."""

from bodymeasure.subdivision.catmull_clark import limit_positions, subdivide
from bodymeasure.subdivision.interpolate import interpolating
from bodymeasure.subdivision.part import children, fill_pinches, part, quads_within
from bodymeasure.subdivision.patches.deviation import Deviation, limit_deviation
from bodymeasure.subdivision.patches.fit import fitted
from bodymeasure.subdivision.patches.flat import (
    MeshDeviation,
    face_distances,
    flat_places,
    mesh_deviation,
)
from bodymeasure.subdivision.patches.irregular import children_places, irregular_quads, neighborhood
from bodymeasure.subdivision.patches.loop_schaefer import PatchNets, loop_schaefer
from bodymeasure.subdivision.polygon_mesh import PolygonMesh
from bodymeasure.subdivision.polygons import quads_of, refined
from bodymeasure.subdivision.quad_mesh import QuadMesh, triangles

__all__ = [
    "Deviation",
    "MeshDeviation",
    "PatchNets",
    "PolygonMesh",
    "QuadMesh",
    "children",
    "children_places",
    "face_distances",
    "fill_pinches",
    "fitted",
    "flat_places",
    "interpolating",
    "irregular_quads",
    "limit_deviation",
    "limit_positions",
    "loop_schaefer",
    "mesh_deviation",
    "neighborhood",
    "part",
    "quads_of",
    "quads_within",
    "refined",
    "subdivide",
    "triangles",
]
