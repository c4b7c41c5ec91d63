"""Measurements of an atlas: diagonals, boundary curves, their cross-check, the whole survey."""

from bodymeasure.measure.boundary import BoundaryLengths, boundary_lengths
from bodymeasure.measure.diagonals import diagonals
from bodymeasure.measure.survey import Survey, measure_atlas, package_versions

__all__ = [
    "BoundaryLengths",
    "Survey",
    "boundary_lengths",
    "diagonals",
    "measure_atlas",
    "package_versions",
]
