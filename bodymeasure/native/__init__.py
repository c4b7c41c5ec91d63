"""Compiled kernels for what arrays of NumPy do not reach; without them, NumPy does the same."""

from bodymeasure.native.box import box_steps
from bodymeasure.native.closest import ClosestSettings, PatchSeams, closest_in_powers
from bodymeasure.native.diagonal import (
    DiagonalProblems,
    DiagonalSettings,
    DiagonalSpace,
    diagonal_paths,
)
from bodymeasure.native.energy import PathTables, energies
from bodymeasure.native.lengths import LengthSettings, LengthTables, path_lengths
from bodymeasure.native.library import is_compiled, without_kernels
from bodymeasure.native.normals import normals_in_powers
from bodymeasure.native.paths import (
    CollocationSettings,
    DescentSettings,
    collocated,
    polygons_at_rest,
)
from bodymeasure.native.points import (
    MOST_COLUMNS,
    MOST_DEGREE,
    bezier_jets,
    extents,
    planar_hull,
    power_jets,
    roots_in_brackets,
)
from bodymeasure.native.route import NewtonSettings, RouteArrays, route_newton
from bodymeasure.native.section import CutPatches, Graphs, section_points
from bodymeasure.native.string import StringForces, string_equilibrium
from bodymeasure.native.trees import compiled_shortest_ways
from bodymeasure.native.ways import (
    GraphArrays,
    JoinedEnd,
    MeshArrays,
    WayFound,
    WaysWanted,
    first_ways_straightened,
    way_straightened,
)

__all__ = [
    "MOST_COLUMNS",
    "MOST_DEGREE",
    "ClosestSettings",
    "CollocationSettings",
    "CutPatches",
    "DescentSettings",
    "DiagonalProblems",
    "DiagonalSettings",
    "DiagonalSpace",
    "GraphArrays",
    "Graphs",
    "JoinedEnd",
    "LengthSettings",
    "LengthTables",
    "MeshArrays",
    "NewtonSettings",
    "PatchSeams",
    "PathTables",
    "RouteArrays",
    "StringForces",
    "WayFound",
    "WaysWanted",
    "bezier_jets",
    "box_steps",
    "closest_in_powers",
    "collocated",
    "compiled_shortest_ways",
    "diagonal_paths",
    "energies",
    "extents",
    "first_ways_straightened",
    "is_compiled",
    "normals_in_powers",
    "path_lengths",
    "planar_hull",
    "polygons_at_rest",
    "power_jets",
    "roots_in_brackets",
    "route_newton",
    "section_points",
    "string_equilibrium",
    "way_straightened",
    "without_kernels",
]
