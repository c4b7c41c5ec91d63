"""Geodesic body measurements on atlases of Bezier patches, with stated errors."""

from bodymeasure.atlas import (
    Atlas,
    AtlasPoint,
    Axes,
    Finding,
    Unit,
    check_atlas,
    convert_length,
    tessellate,
)
from bodymeasure.errors import (
    BodymeasureError,
    ConvergenceError,
    InputError,
    MissingExtraError,
)
from bodymeasure.formats import read_atlas, write_atlas
from bodymeasure.geodesic import (
    WU_C2,
    WU_C4,
    WU_C6,
    WU_C10,
    GeodesicSolution,
    Kernel,
    PolynomialCollocation,
    RBFCollocation,
    Relaxation,
    Ritz,
    Shooting,
    Status,
    solve_geodesic,
)
from bodymeasure.measure import Survey, boundary_lengths, diagonals, measure_atlas
from bodymeasure.samples import load_sample, sample_names

__all__ = [
    "WU_C2",
    "WU_C4",
    "WU_C6",
    "WU_C10",
    "Atlas",
    "AtlasPoint",
    "Axes",
    "BodymeasureError",
    "ConvergenceError",
    "Finding",
    "GeodesicSolution",
    "InputError",
    "Kernel",
    "MissingExtraError",
    "PolynomialCollocation",
    "RBFCollocation",
    "Relaxation",
    "Ritz",
    "Shooting",
    "Status",
    "Survey",
    "Unit",
    "boundary_lengths",
    "check_atlas",
    "convert_length",
    "diagonals",
    "load_sample",
    "measure_atlas",
    "read_atlas",
    "sample_names",
    "solve_geodesic",
    "tessellate",
    "write_atlas",
]
