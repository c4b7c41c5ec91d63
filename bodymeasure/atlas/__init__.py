"""Atlases of Bezier patches: what they hold, how patches meet, their tessellation."""

from bodymeasure.atlas.approximation import Approximation, ApproximationKind
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.axes import Axes
from bodymeasure.atlas.check.check import check_atlas
from bodymeasure.atlas.check.finding import Finding, FindingKind, Severity
from bodymeasure.atlas.check.weld import weld
from bodymeasure.atlas.check.words import check_sentences
from bodymeasure.atlas.contents import LARGEST_DEGREE, LEAST_DEGREE
from bodymeasure.atlas.faces import FileFaces
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.queries.approximation_error import approximation_error
from bodymeasure.atlas.queries.closest import closest_point
from bodymeasure.atlas.queries.locations import Location
from bodymeasure.atlas.scan_fit import LandmarkFound, LandmarkOrigin, ScanFit
from bodymeasure.atlas.seams import EDGES, Edge, EdgeTable, edge_table, sides_of
from bodymeasure.atlas.summary import AtlasSummary, approximation_sentences, summarize
from bodymeasure.atlas.tessellation import Tessellation, tessellate
from bodymeasure.atlas.units import GivenLength, Unit, convert_length

__all__ = [
    "EDGES",
    "LARGEST_DEGREE",
    "LEAST_DEGREE",
    "Approximation",
    "ApproximationKind",
    "Atlas",
    "AtlasPoint",
    "AtlasSummary",
    "Axes",
    "Edge",
    "EdgeTable",
    "FileFaces",
    "Finding",
    "FindingKind",
    "GivenLength",
    "LandmarkFound",
    "LandmarkOrigin",
    "Location",
    "ScanFit",
    "Severity",
    "Tessellation",
    "Unit",
    "approximation_error",
    "approximation_sentences",
    "check_atlas",
    "check_sentences",
    "closest_point",
    "convert_length",
    "edge_table",
    "sides_of",
    "summarize",
    "tessellate",
    "weld",
]
