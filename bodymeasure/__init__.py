"""Geodesic body measurements on atlases of Bezier patches, with stated errors."""

from bodymeasure.atlas import Atlas, AtlasPoint, Axes, Unit, convert_length
from bodymeasure.errors import (
    BodymeasureError,
    ConvergenceError,
    InputError,
    MissingExtraError,
)
from bodymeasure.formats import read_atlas, write_atlas

__all__ = [
    "Atlas",
    "AtlasPoint",
    "Axes",
    "BodymeasureError",
    "ConvergenceError",
    "InputError",
    "MissingExtraError",
    "Unit",
    "convert_length",
    "read_atlas",
    "write_atlas",
]
