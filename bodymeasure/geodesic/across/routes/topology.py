"""The seams of an atlas, the parts of it that they join, and its size."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.prepared import prepared
from bodymeasure.atlas.topology.components import connected_components
from bodymeasure.atlas.topology.neighbors import Neighbors


class Topology(NamedTuple):
    """The steps over the seams of an atlas, and the number of the part of each patch."""

    neighbors: Neighbors
    part: Ints


@prepared
def extent(atlas: Atlas) -> float:
    """Return the longest side of the box round an atlas, which is kept for the next path."""
    return float(np.ptp(atlas.points[atlas.index].reshape(-1, 3), axis=0).max())


@prepared
def topology(atlas: Atlas) -> Topology:
    """Return the topology of an atlas, which is kept for the next path."""
    neighbors = Neighbors(atlas)
    links = [
        (patch, crossing.to_patch)
        for (patch, _), crossings in neighbors.over.items()
        for crossing in crossings
    ]
    first, second = np.array(links, dtype=np.int64).reshape(-1, 2).T
    return Topology(neighbors, connected_components(first, second, len(atlas)))
