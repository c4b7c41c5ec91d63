"""Ways through given points, pulled straight on the mesh without jumping over an obstacle."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.geodesic.across.routes.reading import Segments, mesh_segments

# Where a way is held while the rest of it is pulled straight, as parts of its length, in turn. No
# part between two holds is longer than a third of the way, so that it stays the shortest between
# its own ends.
HOLDS = ((1 / 6, 1 / 2, 5 / 6), (1 / 3, 2 / 3))
# The number of pulls at most, and the part of its length by which a way that is not yet straight
# gets shorter.
MOST_PULLS, STRAIGHT = 8, 2e-3


def pulled_way(atlas: Atlas, places: Sequence[AtlasPoint]) -> Segments | None:
    """Return a way over the mesh that is nearly straight.

    Parameters
    ----------
    atlas : Atlas
    places : sequence of AtlasPoint
        The points through which it leads at first: start, points on the way, end.

    Returns
    -------
    Segments or None
        None if no path joins two of the points.
    """
    way = _through(atlas, places)
    for number in range(MOST_PULLS):
        if way is None or not way.places:
            break
        length = _bounds(way)[-1]
        held = [_at(way, part) for part in HOLDS[number % len(HOLDS)]]
        pulled = _through(atlas, [places[0], *held, places[-1]])
        if pulled is not None and _bounds(pulled)[-1] > length * (1.0 - STRAIGHT):
            return pulled
        way = pulled
    return way


def along_way(points: Array, parts: Array) -> Array:
    """Return the points of a polygon at parts of its length, shape (len(parts), 3)."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    bounds = np.concatenate([[0.0], np.cumsum(steps)])
    return np.stack([np.interp(parts * bounds[-1], bounds, axis) for axis in points.T], axis=-1)


def _through(atlas: Atlas, places: Sequence[AtlasPoint]) -> Segments | None:
    """The shortest ways from each point to the next, put together."""
    parts = [mesh_segments(atlas, *ends) for ends in pairwise(places)]
    found = [part for part in parts if part is not None]
    if len(found) < len(parts):
        return None
    points = [found[0].points[:1], *(part.points[1:] for part in found)]
    return Segments([segment for part in found for segment in part.places], np.concatenate(points))


def _bounds(way: Segments) -> Array:
    """The length of the way up to each of its points."""
    steps = np.linalg.norm(np.diff(way.points, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def _at(way: Segments, part: float) -> AtlasPoint:
    """The end of a segment that is nearest to a part of the length."""
    bounds = _bounds(way)
    return way.places[int(np.argmin(np.abs(bounds[1:] - part * bounds[-1])))][1]
