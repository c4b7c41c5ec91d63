"""The ends of paths over an atlas, and the parts of it that seams join."""

from collections.abc import Sequence
from functools import lru_cache, partial
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.components import connected_components
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.queries.locations import Location, atlas_point
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.errors import InputError


class Topology(NamedTuple):
    """The steps over the seams of an atlas, and the number of the part of each patch."""

    neighbors: Neighbors
    part: Ints


@lru_cache(maxsize=4)
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


def checked_points(
    atlas: Atlas, locations: Sequence[Location], names: Sequence[str]
) -> tuple[AtlasPoint, ...]:
    """Return the points of locations, all on one part of the atlas.

    Parameters
    ----------
    atlas : Atlas
    locations : sequence of Location
    names : sequence of str
        What an error's message calls each of them.

    Raises
    ------
    InputError
        If a location is not on the atlas, or two are on parts that no seam joins.
    """
    points = tuple(map(partial(atlas_point, atlas), locations, names))
    part = topology(atlas).part
    for (name, point), (other, there) in pairwise(zip(names, points, strict=True)):
        if part[point.patch] != part[there.patch]:
            raise InputError(
                f"{name} is on {atlas.patch_names[point.patch]!r} and {other} on "
                f"{atlas.patch_names[there.patch]!r}, which no seams join: the atlas has "
                f"{len(np.unique(part))} separate parts; choose points on one of them, or join "
                "the parts' control points (`bodymeasure check` says where they nearly meet)"
            )
    return points
