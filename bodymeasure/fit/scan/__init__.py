"""Triangle meshes of bodies, read from files and cleaned."""

from bodymeasure.fit.scan.load import MESHES
from bodymeasure.fit.scan.read import read_scan, scan_of
from bodymeasure.fit.scan.scan import Scan

__all__ = ["MESHES", "Scan", "read_scan", "scan_of"]
