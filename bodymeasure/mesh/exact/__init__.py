"""Exact shortest paths over triangle meshes."""

from bodymeasure.mesh.exact.path import exact_path
from bodymeasure.mesh.exact.places import MeshPoint, barycentric
from bodymeasure.mesh.exact.windows import ROUNDED

__all__ = ["ROUNDED", "MeshPoint", "barycentric", "exact_path"]
