"""libigl's and potpourri3d's distances over tessellations, to check the methods' lengths against.

Nothing here shares code with `bodymeasure.geodesic`, and no method may use it for its answer.
"""

from bodymeasure.oracle.distances import LEVELS, Engine, MeshDistances, mesh_distances
from bodymeasure.oracle.flips import has_flips
from bodymeasure.oracle.validate import validate_mesh
from bodymeasure.oracle.workers import WorkerError

__all__ = [
    "LEVELS",
    "Engine",
    "MeshDistances",
    "WorkerError",
    "has_flips",
    "mesh_distances",
    "validate_mesh",
]
