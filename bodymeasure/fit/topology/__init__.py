"""Bodies of models with a fixed topology, such as MakeHuman's, by correspondence: no search."""

from bodymeasure.fit.topology.correspondence import Gives, Topology, mapped_vertices
from bodymeasure.fit.topology.known import known_topology, recognized, require
from bodymeasure.fit.topology.mapped import MappedBody, mapped_body
from bodymeasure.fit.topology.polygons import Polygons, polygons_of, read_polygons
from bodymeasure.fit.topology.posture import Posture, posture_of
from bodymeasure.fit.topology.stored import read_topology, require_npz, write_topology
from bodymeasure.fit.topology.transfer import topology_of_fit

__all__ = [
    "Gives",
    "MappedBody",
    "Polygons",
    "Posture",
    "Topology",
    "known_topology",
    "mapped_body",
    "mapped_vertices",
    "polygons_of",
    "posture_of",
    "read_polygons",
    "read_topology",
    "recognized",
    "require",
    "require_npz",
    "topology_of_fit",
    "write_topology",
]
