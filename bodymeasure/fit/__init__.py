"""Bodies fitted to meshes: a triangle mesh of a person goes in, an atlas with landmarks comes out.

The model of bodies is in `bodymeasure.fit.model`, the data that it is made of in `data`.
"""

from bodymeasure.fit.scan import Scan, read_scan, scan_of

__all__ = ["Scan", "read_scan", "scan_of"]
