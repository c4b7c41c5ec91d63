"""Paths over an atlas put together from legs, each the geodesic between two places."""

from typing import NamedTuple

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.across.pieces.path import AtlasPath, PathPiece, SeamCrossing
from bodymeasure.geodesic.across.routes.reading import first_route
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.search.route_search import Found, shortest_along
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.status import Status

# Points a piece that tell a path's length roughly, for scaling.
SAMPLES = 5
# What stands for a path that stays where it is.
STANDSTILL = polynomial_space(1)


class Leg(NamedTuple):
    """How one leg ended, what was found, and where it begins.

    Nothing is found where there is no route, or no way to go.
    """

    status: Status
    found: Found | None
    at: AtlasPoint


def shortest_leg(atlas: Atlas, neighbors: Neighbors, start: AtlasPoint, end: AtlasPoint) -> Leg:
    """The shortest path between two places that was found."""
    if neighbors.are_same(start, end):
        return Leg(Status.CONVERGED, None, start)
    route = first_route(atlas, neighbors, (start, end))
    if route is None:
        return Leg(Status.NO_ROUTE, None, start)
    return leg_along(atlas, neighbors, route)


def leg_along(atlas: Atlas, neighbors: Neighbors, route: Route) -> Leg:
    """The shortest path along a route, or along those that it asks for."""
    size = _rough_length(atlas, route)
    if size == 0.0:
        return Leg(Status.CONVERGED, None, route.start)
    found = shortest_along(atlas, neighbors, route, size)
    if not found.good:
        return Leg(Status.NOT_CONVERGED, found, route.start)
    if found.contact:
        return Leg(Status.ON_BOUNDARY, found, route.start)
    status = Status.CONVERGED if found.length.minimal else Status.NOT_A_MINIMUM
    return Leg(status, found, route.start)


def _rough_length(atlas: Atlas, route: Route) -> float:
    """The length of the path that is straight in (u, v) on each patch."""
    t = np.linspace(0.0, 1.0, SAMPLES)[:, None]
    lines = [
        (1.0 - t) * np.array(route.entry(piece)[1:]) + t * np.array(route.exit(piece)[1:])
        for piece in range(len(route.patches))
    ]
    points = evaluate(atlas.control_points[list(route.patches)], np.array(lines))
    return float(np.linalg.norm(np.diff(points, axis=1), axis=2).sum())


def join_legs(atlas: Atlas, points: tuple[AtlasPoint, ...], legs: list[Leg]) -> AtlasPath:
    """One path of all legs, through the points between them."""
    failed = [leg.status for leg in legs if not leg.status.has_length]
    other = [leg.status for leg in legs if leg.status is not Status.CONVERGED]
    status = (failed or other or [Status.CONVERGED])[0]
    lengths = [leg.found.length for leg in legs if leg.found is not None]
    corrected = sum(length.corrected for length in lengths)
    no_path = Status.NO_ROUTE in failed
    pieces = () if no_path else tuple(piece for leg in legs for piece in _pieces(leg))
    return AtlasPath(
        atlas=atlas,
        points=points,
        length=float(corrected) if status.has_length else np.nan,
        raw_length=np.nan if no_path else float(sum(length.raw for length in lengths)),
        error_estimate=np.inf if no_path else float(sum(length.error for length in lengths)),
        residual=max((length.residual for length in lengths), default=0.0),
        status=status,
        pieces=pieces,
        crossings=() if no_path else _crossings(legs, pieces),
    )


def _pieces(leg: Leg) -> list[PathPiece]:
    if leg.found is None:
        stays = np.repeat(np.array(leg.at[1:])[:, None], 2, axis=1)
        return [PathPiece(leg.at.patch, STANDSTILL, stays, 0.0)]
    if leg.found.held is not None:
        return list(leg.found.held.pieces)
    refined = leg.found.refined
    lengths = (refined.lengths * refined.problem.size).tolist()
    parts = zip(refined.route.patches, refined.values, lengths, strict=True)
    return [PathPiece(patch, refined.problem.space, *rest) for patch, *rest in parts]


def _crossings(legs: list[Leg], pieces: tuple[PathPiece, ...]) -> tuple[SeamCrossing, ...]:
    ends = np.cumsum([piece.length for piece in pieces])
    result, passed = [], 0
    for leg in legs:
        for number, (before, after) in _leg_crossings(leg):
            t = float(ends[passed + number] / ends[-1])
            result.append(SeamCrossing(before, after, t))
        passed += len(_pieces(leg))
    return tuple(result)


def _leg_crossings(leg: Leg) -> list[tuple[int, tuple[AtlasPoint, AtlasPoint]]]:
    """After which piece of a leg a seam is crossed, and the point there on both patches."""
    if leg.found is None:
        return []
    if leg.found.held is not None:
        return list(leg.found.held.crossings)
    route = leg.found.refined.route
    return [(n, (route.exit(n), route.entry(n + 1))) for n in range(len(route.crossings))]
