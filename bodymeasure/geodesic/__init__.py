"""Geodesics on one patch: problem, trial spaces, methods, solution."""

from bodymeasure.geodesic.kernels import WU_C2, WU_C4, WU_C6, WU_C10, Kernel
from bodymeasure.geodesic.method import EdgeContact, Method
from bodymeasure.geodesic.polynomial import PolynomialCollocation
from bodymeasure.geodesic.rbf import RBFCollocation
from bodymeasure.geodesic.relaxation import Relaxation
from bodymeasure.geodesic.ritz import Ritz
from bodymeasure.geodesic.search import SEARCHES, Search
from bodymeasure.geodesic.shooting import Shooting
from bodymeasure.geodesic.solution import GeodesicSolution
from bodymeasure.geodesic.solve import HasDerivatives, solve_geodesic
from bodymeasure.geodesic.status import Status

__all__ = [
    "SEARCHES",
    "WU_C2",
    "WU_C4",
    "WU_C6",
    "WU_C10",
    "EdgeContact",
    "GeodesicSolution",
    "HasDerivatives",
    "Kernel",
    "Method",
    "PolynomialCollocation",
    "RBFCollocation",
    "Relaxation",
    "Ritz",
    "Search",
    "Shooting",
    "Status",
    "solve_geodesic",
]
