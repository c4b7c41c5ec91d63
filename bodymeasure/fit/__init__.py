"""Bodies fitted to meshes: a triangle mesh of a person goes in, an atlas with landmarks comes out.

The model of bodies is in `bodymeasure.fit.model`, the data that it is made of in `data`.
"""

from bodymeasure.fit.by_topology import map_body, save_topology
from bodymeasure.fit.export import write_fitted
from bodymeasure.fit.fit import fit_body
from bodymeasure.fit.result import FittedBody
from bodymeasure.fit.scan import Scan, read_scan, scan_of
from bodymeasure.fit.solving.judge import Scores
from bodymeasure.fit.topology import Gives, Topology, read_topology

__all__ = [
    "FittedBody",
    "Gives",
    "Scan",
    "Scores",
    "Topology",
    "fit_body",
    "map_body",
    "read_scan",
    "read_topology",
    "save_topology",
    "scan_of",
    "write_fitted",
]
