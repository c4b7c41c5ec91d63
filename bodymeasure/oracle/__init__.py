"""libigl's exact and heat distances over tessellations, to check the methods' lengths against.

Nothing here shares code with `bodymeasure.geodesic`, and no method may use it for its answer.
"""

from bodymeasure.oracle.distances import LEVELS, MeshDistances, mesh_distances
from bodymeasure.oracle.validate import validate_mesh
from bodymeasure.oracle.workers import WorkerError

__all__ = ["LEVELS", "MeshDistances", "WorkerError", "mesh_distances", "validate_mesh"]
