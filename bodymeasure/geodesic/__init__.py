"""Geodesics on one patch: problem, trial spaces, methods, solution."""

from bodymeasure.geodesic.kernels import WU_C2, WU_C4, WU_C6, WU_C10, Kernel
from bodymeasure.geodesic.method import Method
from bodymeasure.geodesic.rbf import RBFCollocation
from bodymeasure.geodesic.solution import GeodesicSolution
from bodymeasure.geodesic.solve import HasDerivatives, solve_geodesic
from bodymeasure.geodesic.status import Status

__all__ = [
    "WU_C2",
    "WU_C4",
    "WU_C6",
    "WU_C10",
    "GeodesicSolution",
    "HasDerivatives",
    "Kernel",
    "Method",
    "RBFCollocation",
    "Status",
    "solve_geodesic",
]
