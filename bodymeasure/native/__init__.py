"""Compiled kernels for what arrays of NumPy do not reach; without them, NumPy does the same."""

from bodymeasure.native.box import box_steps
from bodymeasure.native.closest import ClosestSettings, closest_in_powers
from bodymeasure.native.diagonal import (
    DiagonalProblems,
    DiagonalSettings,
    DiagonalSpace,
    QuadratureTables,
    diagonal_paths,
)
from bodymeasure.native.energy import PathTables, energies
from bodymeasure.native.library import is_compiled
from bodymeasure.native.points import (
    MOST_COLUMNS,
    MOST_DEGREE,
    bezier_jets,
    extremes,
    power_jets,
    roots_in_brackets,
)
from bodymeasure.native.route import NewtonSettings, RouteArrays, route_newton
from bodymeasure.native.trees import shortest_ways
from bodymeasure.native.unfold import unfolded

__all__ = [
    "MOST_COLUMNS",
    "MOST_DEGREE",
    "ClosestSettings",
    "DiagonalProblems",
    "DiagonalSettings",
    "DiagonalSpace",
    "NewtonSettings",
    "PathTables",
    "QuadratureTables",
    "RouteArrays",
    "bezier_jets",
    "box_steps",
    "closest_in_powers",
    "diagonal_paths",
    "energies",
    "extremes",
    "is_compiled",
    "power_jets",
    "roots_in_brackets",
    "route_newton",
    "shortest_ways",
    "unfolded",
]
