"""Geodesics on one patch and across patches: trial spaces, methods, routes, solutions."""

from bodymeasure.geodesic.alternatives import geodesic_alternatives
from bodymeasure.geodesic.atlas_path import AtlasPath, PathPiece, SeamCrossing
from bodymeasure.geodesic.between import geodesic_between, geodesics_between
from bodymeasure.geodesic.closed import ClosedPath, contract
from bodymeasure.geodesic.closed_error import LoopKind
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
    "AtlasPath",
    "ClosedPath",
    "EdgeContact",
    "GeodesicSolution",
    "HasDerivatives",
    "Kernel",
    "LoopKind",
    "Method",
    "PathPiece",
    "PolynomialCollocation",
    "RBFCollocation",
    "Relaxation",
    "Ritz",
    "SeamCrossing",
    "Search",
    "Shooting",
    "Status",
    "contract",
    "geodesic_alternatives",
    "geodesic_between",
    "geodesics_between",
    "solve_geodesic",
]
