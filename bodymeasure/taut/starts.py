"""The strings from which tapes slide to rest: evenly spaced points of paths along the skin."""

from itertools import pairwise

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic import AtlasPath
from bodymeasure.geodesic.across.routes.graph import patch_graph
from bodymeasure.geodesic.across.routes.ways import first_ways

# The number of segments of the first string of a leg.
SEGMENTS = 32


def first_strings(contact: AtlasPath) -> list[Array]:
    """Return evenly spaced points, shape (SEGMENTS + 1, 3), of each leg of a path along the skin.

    Where no smooth path was found, they lie on the shortest way over a mesh of the atlas. The list
    is empty if there is none either.
    """
    if contact.pieces:
        return [
            contact.position(np.clip(np.linspace(begin, finish, SEGMENTS + 1), 0.0, 1.0))
            for begin, finish in pairwise(contact.leg_ends)
        ]
    legs = []
    for start, end in pairwise(contact.points):
        ways = first_ways(contact.atlas, start, end)
        if not ways:
            return []
        nodes = _evenly(ways[0].points(patch_graph(contact.atlas).mesh.surface))
        nodes[0], nodes[-1] = contact.atlas.position(start), contact.atlas.position(end)
        legs.append(nodes)
    return legs


def _evenly(points: Array) -> Array:
    """Return evenly spaced points of a polygon (k, 3)."""
    way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    places = np.linspace(0.0, way[-1], SEGMENTS + 1)
    return np.stack([np.interp(places, way, column) for column in points.T], axis=1)
