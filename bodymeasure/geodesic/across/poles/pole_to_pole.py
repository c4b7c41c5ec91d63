"""Paths between two points of which each is close to a pole, or at it.

Several geodesics of nearly equal lengths may join two poles, as on an ellipsoid with three axes.
Which of them the shortest path between points beside the poles follows, their directions tell.
"""

from functools import lru_cache

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors, on_side
from bodymeasure.geodesic.across.pieces.budget import WITH_POLES, Budget
from bodymeasure.geodesic.across.pieces.path import AtlasPath
from bodymeasure.geodesic.across.poles.composed import composed_path, radial
from bodymeasure.geodesic.across.poles.fan import fan_at, poles_of
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.routes.topology import topology
from bodymeasure.geodesic.across.search.leg import Ends, first_routes, leg_along, shortest_leg

# Both ends are within this part of the patches' widths from their poles.
CLOSE = 1e-2
# A geodesic between the poles is sought from the middle of each sector, so far along it.
AWAY = 0.3
# There may be hundreds of sectors: geodesics are sought from so many of them, evenly spread.
MOST = 6


def between_poles(
    atlas: Atlas, neighbors: Neighbors, ends: Ends, budget: Budget
) -> AtlasPath | None:
    """Return the shortest path over the geodesics between two poles, close to which its ends are.

    None if the ends are not close to two poles, or their legs have no lengths.
    """
    poles = [_pole_beside(atlas, end) for end in ends]
    if poles[0] is None or poles[1] is None or neighbors.are_same(poles[0], poles[1]):
        return None
    near, far = fan_at(atlas, poles[0]), fan_at(atlas, poles[1])
    if near is None or far is None:
        return None
    outer = (near, (ends[0], poles[0])), (far, (poles[1], ends[1]))
    legs: list[AtlasPath | None] = []
    for fan, leg in outer:
        if neighbors.are_same(*leg):
            legs.append(None)
            continue
        legs.append(radial(fan, leg) or shortest_leg(atlas, neighbors, leg, budget))
    if not all(leg is None or (leg.converged and leg.length > 0.0) for leg in legs):
        return None
    found: list[AtlasPath] = []
    for path in _geodesics(atlas, poles[0], poles[1]):
        whole, between = path, (ends[0], poles[1])
        if legs[0] is not None:
            first = composed_path(between, near, (legs[0], whole))
            if first is None or first[1].conjugate:
                continue
            whole = first[0]
        if legs[1] is not None:
            second = composed_path(ends, far, (whole, legs[1]))
            if second is None:
                continue
            whole = second[0]
        found.append(whole)
    return min(found, key=lambda path: path.length, default=None)


def _pole_beside(atlas: Atlas, place: AtlasPoint) -> AtlasPoint | None:
    """Return the place of the pole close to a point, or at it, on its patch; None if none is."""
    poles = poles_of(atlas)
    for number in np.flatnonzero(poles.patch == place.patch).tolist():
        away = np.linalg.norm(atlas.position(place) - poles.positions[number])
        if away < CLOSE * poles.widths[number]:
            return poles.place(number)
    return None


@lru_cache(maxsize=16)
def _geodesics(atlas: Atlas, start: AtlasPoint, end: AtlasPoint) -> tuple[AtlasPath, ...]:
    """Return geodesics between two poles, which are kept for the next path.

    Each is sought from the middle of another sector; several may be the same.
    """
    neighbors, poles, fan = topology(atlas).neighbors, poles_of(atlas), fan_at(atlas, start)
    assert fan is not None
    count, budget = len(fan.sectors), Budget(WITH_POLES)
    most = min(count, MOST)
    found: list[AtlasPath] = []
    for number in sorted({count * step // most for step in range(most)}):
        sector = fan.sectors[number]
        on = (poles.patch == sector.patch) & (poles.side == sector.side)
        middle = np.array([0.5 * sector.angle]), AWAY * poles.widths[on]
        place = AtlasPoint(sector.patch, *fan.places(number, *middle)[0].tolist())
        pole = AtlasPoint(sector.patch, *on_side(sector.side, 0.5))
        for route in first_routes(atlas, neighbors, (place, end), budget)[:1]:
            assert route.ends is not None
            ends = pole, route.ends[1]
            routes = [Route(ends, route.crossings, route.along)]
            path = leg_along(atlas, neighbors, ends, routes, budget)
            if path.converged:
                found.append(path)
        if budget.left <= 0.0:
            break
    return tuple(found)
