"""Reading a way over the mesh of an atlas as a route over patches and seams."""

import numpy as np

from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Crossing, Neighbors
from bodymeasure.geodesic.across.routes.mesh import RouteMesh
from bodymeasure.geodesic.across.routes.route import Route, snapped
from bodymeasure.geodesic.across.routes.strips import StraightWay


def route_of(
    neighbors: Neighbors,
    mesh: RouteMesh,
    ends: tuple[AtlasPoint, AtlasPoint],
    way: StraightWay,
) -> Route | None:
    """Return the route of a way over the mesh between two points.

    Where an end lies on a seam that the way crosses there, the route begins or ends beyond it.
    There is no route if the way begins or ends on a patch that does not hold the point, as ways may
    that turn about a pole a hair off the point.
    """
    begin, finish = (
        _on_patch(neighbors, place, patch)
        for place, patch in zip(ends, mesh.patch[way.strip[[0, -1]]].tolist(), strict=True)
    )
    if begin is None or finish is None:
        return None
    crossings: list[Crossing] = []
    along: list[float] = []
    strip, sides = way.strip, way.sides
    left = mesh.sides[strip[:-1], sides]
    over = np.flatnonzero(left >= 0)
    here, there, side, after = strip[over], strip[over + 1], sides[over], (sides[over] + 1) % 3
    # The side by which the next face is entered is that whose corners are both on the one left.
    ends_of_side = mesh.corners[here[:, None], np.stack([side, after], axis=1)]
    shared = (mesh.corners[there][:, :, None] == ends_of_side[:, None]).any(axis=2)
    entered = np.argmax(shared & np.roll(shared, -1, axis=1), axis=1)
    t = way.along[over, None]
    first, last = mesh.parameters[here, side], mesh.parameters[here, after]
    found = (mesh.patch[here], mesh.patch[there], left[over], mesh.sides[there, entered])
    places = ((1.0 - t) * first + t * last).tolist()
    for place, *passed in zip(places, *(each.tolist() for each in found), strict=True):
        patch, beyond, leave, enter = passed
        for crossing in neighbors.over.get((patch, leave), ()):
            if (crossing.to_patch, crossing.to_side) == (beyond, enter):
                crossings.append(crossing)
                along.append(snapped(0, place[1 - EDGES[leave].fixed_axis], 0.0).u)
    return _without_empty_ends(neighbors, Route((begin, finish), tuple(crossings), tuple(along)))


def _on_patch(neighbors: Neighbors, place: AtlasPoint, patch: int) -> AtlasPoint | None:
    """The same point as a point of a patch; None if it is none of that patch."""
    return next((same for same in neighbors.same(place) if same.patch == patch), None)


def _without_empty_ends(neighbors: Neighbors, route: Route) -> Route:
    """The route without pieces that lead from an end to a seam on which that end lies."""
    assert route.ends is not None
    start, end = route.ends
    first, last = 0, len(route.crossings)
    while first < last:
        leave, enter = route.crossed[first]
        same = [place for place in neighbors.same(start) if place.patch == enter.patch]
        if neighbors.key(leave) != neighbors.key(start) or not same:
            break
        start, first = same[0], first + 1
    while first < last:
        leave, enter = route.crossed[last - 1]
        same = [place for place in neighbors.same(end) if place.patch == leave.patch]
        if neighbors.key(enter) != neighbors.key(end) or not same:
            break
        end, last = same[0], last - 1
    return Route((start, end), route.crossings[first:last], route.along[first:last])
