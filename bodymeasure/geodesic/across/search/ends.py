"""The ends of paths over an atlas, checked, and put on the seams beside which they lie."""

from collections.abc import Sequence
from functools import partial
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint, on_edges
from bodymeasure.atlas.queries.locations import Location, atlas_point
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.routes.topology import topology


class Ends(NamedTuple):
    """The points that paths join.

    Parameters
    ----------
    points : tuple of AtlasPoint
        A point that lies beside an edge of its patch only by rounding is on the edge: else no seam
        would lead over to the next patch there.
    moves : tuple of float
        How far that moved each of them, in the atlas's unit, by which lengths are uncertain.
    """

    points: tuple[AtlasPoint, ...]
    moves: tuple[float, ...]


def checked_points(atlas: Atlas, locations: Sequence[Location], names: Sequence[str]) -> Ends:
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
    given = tuple(map(partial(atlas_point, atlas), locations, names))
    places = on_edges(np.array([point[1:] for point in given])).tolist()
    points = tuple(
        AtlasPoint(point.patch, *place) for point, place in zip(given, places, strict=True)
    )
    moves = (
        0.0
        if point == there
        else float(np.linalg.norm(atlas.position(point) - atlas.position(there)))
        for point, there in zip(given, points, strict=True)
    )
    part = topology(atlas).part
    for (name, point), (other, there) in pairwise(zip(names, points, strict=True)):
        if part[point.patch] != part[there.patch]:
            raise InputError(
                f"{name} is on {atlas.patch_names[point.patch]!r} and {other} on "
                f"{atlas.patch_names[there.patch]!r}, which no seams join: the atlas has "
                f"{len(np.unique(part))} separate parts; choose points on one of them, or join "
                "the parts' control points (`bodymeasure check` says where they nearly meet)"
            )
    return Ends(points, tuple(moves))
