"""Which topology a mesh has."""

from collections.abc import Iterable, Iterator
from typing import NoReturn

import numpy as np

from bodymeasure.errors import InputError
from bodymeasure.fit.topology.correspondence import Topology, edge_keys
from bodymeasure.fit.topology.hm08 import SURFACES, hm08_topologies
from bodymeasure.fit.topology.polygons import Polygons
from bodymeasure.wording import counted

# MakeHuman's helper geometry makes a mesh 1.43 times as large as its body. What has more vertices
# than this holds other things, such as another person.
MOST = 1.5


def recognized(mesh: Polygons) -> Topology | None:
    """Return the topology that comes with the package and that a mesh has, or None.

    A mesh is recognized by its edges: all that the topology names must be there, between vertices
    with the same numbers. The kind of polygons does not matter, nor what else the mesh holds, if it
    is not as much as another body.
    """
    found = next(_matching(mesh, hm08_topologies()), None)
    alone = found is not None and len(mesh.vertices) <= MOST * found.count
    return found if alone else None


def known_topology(name: str, mesh: Polygons, source: str) -> Topology:
    """Return the topology that comes with the package, by its name and for this mesh.

    Raises
    ------
    InputError
        If there is none of that name, or the mesh is not of it.
    """
    if name not in SURFACES:
        raise InputError(
            f"there is no topology {name!r}; expected one of {', '.join(map(repr, SURFACES))}, or "
            "a file that was written with --save-topology"
        )
    found = next(_matching(mesh, hm08_topologies(name == SURFACES[1])), None)
    if found is None:
        _refuse(mesh, hm08_topologies()[0], source)
    return found


def require(mesh: Polygons, topology: Topology, source: str) -> None:
    """Raise an InputError unless a mesh has a topology."""
    if missing_edges(mesh, topology):
        _refuse(mesh, topology, source)


def missing_edges(mesh: Polygons, topology: Topology) -> int:
    """Return how many of a topology's edges a mesh lacks."""
    count = len(mesh.vertices)
    if count < topology.count:
        return len(topology.edges)
    there = edge_keys(mesh.edges, count)
    return int((~np.isin(edge_keys(topology.edges, count), there)).sum())


def _matching(mesh: Polygons, topologies: Iterable[Topology]) -> Iterator[Topology]:
    return (each for each in topologies if not missing_edges(mesh, each))


def _refuse(mesh: Polygons, topology: Topology, source: str) -> NoReturn:
    lacks, of = missing_edges(mesh, topology), len(topology.edges)
    raise InputError(
        f"{source}: is not of the topology {topology.name!r}: it has "
        f"{counted(len(mesh.vertices), 'vertex', 'vertices')}, of which that needs "
        f"{topology.count:,}, and lacks {lacks:,} of its {of:,} edges; write the body with the "
        "vertices and faces of the model, neither split nor welded nor in another order, or fit it "
        "as a scan"
    )
