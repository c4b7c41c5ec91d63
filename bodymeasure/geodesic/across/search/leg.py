"""Legs of paths over an atlas, each the geodesic between two points."""

from collections.abc import Sequence
from itertools import product

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.across.pieces.budget import Budget
from bodymeasure.geodesic.across.pieces.part import PathPart, PathPiece
from bodymeasure.geodesic.across.pieces.path import AtlasPath
from bodymeasure.geodesic.across.routes.finer import fine_route
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.routes.ways import first_ways
from bodymeasure.geodesic.across.search.search import shortest_along
from bodymeasure.geodesic.lengths.length import UNKNOWN, Length
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.status import Status

# The number of points on each piece from which the rough length of a path is calculated.
SAMPLES = 5
# Positions of one point on two patches agree to this part of the atlas's coordinates.
ROUNDING = 4e-15
# The trial space of a path that stays where it is.
STANDSTILL = polynomial_space(1)

Ends = tuple[AtlasPoint, AtlasPoint]


def shortest_leg(
    atlas: Atlas, neighbors: Neighbors, ends: Ends, budget: Budget | None = None
) -> AtlasPath:
    """Return the shortest path between two points that was found."""
    start, end = ends
    if neighbors.are_same(start, end):
        return _standstill(atlas, neighbors, start, end)
    routes = first_routes(atlas, neighbors, ends, budget)
    if routes:
        return leg_along(atlas, neighbors, ends, routes, budget)
    none = Length(*map(np.asarray, (np.nan, 0.0, np.inf, 0.0, UNKNOWN, False)))
    return AtlasPath.of(atlas, (start, end), PathPart((), (), none), Status.NO_ROUTE)


def first_routes(
    atlas: Atlas, neighbors: Neighbors, ends: Ends, budget: Budget | None = None
) -> list[Route]:
    """Return the routes along which the shortest path may lead, the likeliest first.

    There are none if no seams join the points.
    """
    if budget is not None:
        budget.spend_on_routes()
    routes = (fine_route(atlas, neighbors, ends, way) for way in first_ways(atlas, *ends))
    # Different ways may lead along one route.
    return list({route.key: route for route in routes if route is not None}.values())


def leg_along(
    atlas: Atlas,
    neighbors: Neighbors,
    points: Ends,
    routes: Sequence[Route],
    budget: Budget | None = None,
) -> AtlasPath:
    """Return the shortest path along one of some routes, or along others that they lead to."""
    # The length of the path that is straight in (u, v) on each patch.
    t = np.linspace(0.0, 1.0, SAMPLES)[:, None]
    start, stop = np.array(routes[0].pieces)[:, :, None, 1:].swapaxes(0, 1)
    samples = evaluate(atlas.control_points[list(routes[0].patches)], (1.0 - t) * start + t * stop)
    size = float(np.linalg.norm(np.diff(samples, axis=1), axis=2).sum())
    if size == 0.0:
        return _standstill(atlas, neighbors, *points)
    found = shortest_along(atlas, neighbors, routes, size, budget)
    return AtlasPath.of(atlas, points, found.part, found.status)


def _standstill(
    atlas: Atlas, neighbors: Neighbors, start: AtlasPoint, end: AtlasPoint
) -> AtlasPath:
    """A path that stays where it is, but for the last digits in which its ends may differ.

    It is straight, on a patch on which both can be written.
    """
    places = product(neighbors.same(start), neighbors.same(end))
    here, there = min(
        (pair for pair in places if neighbors.key(pair[0]) == neighbors.key(pair[1])),
        key=lambda pair: max(abs(pair[0].u - pair[1].u), abs(pair[0].v - pair[1].v)),
    )
    chord = float(np.linalg.norm(atlas.position(there) - atlas.position(here)))
    rounding = ROUNDING * float(np.abs(atlas.points).max())
    if chord <= rounding:
        chord, rounding, here, there = 0.0, chord, end, end
    values = np.array([here[1:], there[1:]]).T
    length = Length(*map(np.asarray, (chord, 0.0, rounding, 0.0, 0, True)))
    part = PathPart((PathPiece(there.patch, STANDSTILL, values, chord),), (), length)
    return AtlasPath.of(atlas, (start, end), part, Status.CONVERGED)
