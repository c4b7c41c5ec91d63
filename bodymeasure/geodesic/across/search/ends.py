"""The ends of paths over an atlas: what is checked of them, and which parts of it hang together."""

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.components import connected_components
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.errors import InputError


class Topology(NamedTuple):
    """Steps over seams, and the number of the part that each patch belongs to."""

    neighbors: Neighbors
    part: NDArray[np.int64]


@lru_cache(maxsize=4)
def topology(atlas: Atlas) -> Topology:
    """What an atlas's seams join; kept for the next path."""
    neighbors = Neighbors(atlas)
    links = [
        (patch, crossing.to_patch)
        for (patch, _), crossings in neighbors.over.items()
        for crossing in crossings
    ]
    first, second = np.array(links, dtype=np.int64).reshape(-1, 2).T
    return Topology(neighbors, connected_components(first, second, len(atlas)))


def checked_places(
    atlas: Atlas, points: Sequence[AtlasPoint], names: Sequence[str]
) -> list[AtlasPoint]:
    """The points as places, all on one part of the atlas.

    Parameters
    ----------
    atlas : Atlas
    points : sequence of AtlasPoint
    names : sequence of str
        What each is called in an error's message.

    Raises
    ------
    InputError
        If a point is not on the atlas, or two are on parts that no seam joins.
    """
    places = [_checked(atlas, name, point) for name, point in zip(names, points, strict=True)]
    _check_parts(atlas, topology(atlas).part, list(zip(names, places, strict=True)))
    return places


def _checked(atlas: Atlas, name: str, point: AtlasPoint) -> AtlasPoint:
    if not isinstance(point, AtlasPoint):
        raise InputError(f"{name} is {point!r}; expected an AtlasPoint, such as a landmark")
    if not 0 <= point.patch < len(atlas):
        raise InputError(
            f"{name} is on patch {point.patch}, but the patches are numbered 0 to {len(atlas) - 1}"
        )
    # `not inside` rather than `outside`, so that NaN is refused too.
    if not (0.0 <= point.u <= 1.0 and 0.0 <= point.v <= 1.0):
        raise InputError(f"{name} has (u, v) = ({point.u}, {point.v}); expected both in [0, 1]")
    return AtlasPoint(int(point.patch), float(point.u), float(point.v))


def _check_parts(
    atlas: Atlas, part: NDArray[np.int64], named: list[tuple[str, AtlasPoint]]
) -> None:
    for (name, place), (other, there) in pairwise(named):
        if part[place.patch] != part[there.patch]:
            raise InputError(
                f"{name} is on {atlas.patch_names[place.patch]!r} and {other} on "
                f"{atlas.patch_names[there.patch]!r}, which no seams join: the atlas has "
                f"{len(np.unique(part))} separate parts; choose points on one of them, or join "
                "the parts' control points (`bodymeasure check` tells where they nearly meet)"
            )
