"""Geodesics on one patch and across patches: trial spaces, methods, routes, solutions.

What searches across patches, and rarer methods, are loaded when they are first asked for.
"""

from typing import TYPE_CHECKING

from bodymeasure.geodesic.methods.polynomial_collocation import PolynomialCollocation
from bodymeasure.geodesic.methods.rbf_collocation import RBFCollocation
from bodymeasure.geodesic.proofs.bounds import Bounds
from bodymeasure.geodesic.proofs.patches import PatchesOfPaths
from bodymeasure.geodesic.shortest.search import SEARCHES, Search
from bodymeasure.geodesic.solution import GeodesicSolution
from bodymeasure.geodesic.solve import HasDerivatives, solve_geodesic
from bodymeasure.geodesic.solving.protocol import EdgeContact, Method, MethodResult, PathBatch
from bodymeasure.geodesic.spaces.kernels import WU_C2, WU_C4, WU_C6, WU_C10, Kernel
from bodymeasure.geodesic.spaces.rbf import rbf_coefficients
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.status import Status
from bodymeasure.geodesic.surfaces.protocol import Surface
from bodymeasure.lazy import loader

__all__ = [
    "SEARCHES",
    "WU_C2",
    "WU_C4",
    "WU_C6",
    "WU_C10",
    "AtlasPath",
    "Bounds",
    "ClosedPath",
    "DirectedPath",
    "EdgeContact",
    "GeodesicSolution",
    "HasDerivatives",
    "Kernel",
    "LoopKind",
    "Method",
    "MethodResult",
    "PatchesOfPaths",
    "PathBatch",
    "PathPart",
    "PathPiece",
    "PolynomialCollocation",
    "RBFCollocation",
    "RBFRitz",
    "Relaxation",
    "Ritz",
    "SeamCrossing",
    "Search",
    "Shooting",
    "Status",
    "Surface",
    "TrialSpace",
    "contracted_loop",
    "enclose",
    "geodesic_alternatives",
    "geodesic_between",
    "geodesic_from",
    "geodesics_between",
    "rbf_coefficients",
    "solve_geodesic",
]

if TYPE_CHECKING:
    from bodymeasure.geodesic.across.pieces.error import LoopKind
    from bodymeasure.geodesic.across.pieces.part import PathPart, PathPiece
    from bodymeasure.geodesic.across.pieces.path import AtlasPath, SeamCrossing
    from bodymeasure.geodesic.alternatives import geodesic_alternatives
    from bodymeasure.geodesic.between import geodesic_between, geodesics_between
    from bodymeasure.geodesic.closed import ClosedPath, contracted_loop
    from bodymeasure.geodesic.directed import DirectedPath, geodesic_from
    from bodymeasure.geodesic.enclosed import enclose
    from bodymeasure.geodesic.methods.rbf_ritz import RBFRitz
    from bodymeasure.geodesic.methods.relaxation import Relaxation
    from bodymeasure.geodesic.methods.ritz import Ritz
    from bodymeasure.geodesic.methods.shooting import Shooting
else:
    __getattr__ = loader(
        __name__,
        __all__,
        (
            "across.pieces.error",
            "across.pieces.part",
            "across.pieces.path",
            "alternatives",
            "between",
            "closed",
            "directed",
            "enclosed",
            "methods.rbf_ritz",
            "methods.relaxation",
            "methods.ritz",
            "methods.shooting",
        ),
    )
