"""Plain triangle meshes: shortest paths over them, and files of bodies with paths."""

from bodymeasure.mesh.curves.write import write_paths
from bodymeasure.mesh.glb import write_glb
from bodymeasure.mesh.lines import path_to_trimesh
from bodymeasure.mesh.measure import measure_mesh
from bodymeasure.mesh.path import MeshPath

__all__ = ["MeshPath", "measure_mesh", "path_to_trimesh", "write_glb", "write_paths"]
