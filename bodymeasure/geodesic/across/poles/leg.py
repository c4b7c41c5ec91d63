"""Legs of paths over an atlas that may pass close by a pole or begin beside one."""

from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.across.pieces.budget import PATH, WITH_POLES, Budget
from bodymeasure.geodesic.across.pieces.path import AtlasPath
from bodymeasure.geodesic.across.pieces.refine import RefinedPath, refine
from bodymeasure.geodesic.across.poles.composed import beside_pole, composed_path, radial
from bodymeasure.geodesic.across.poles.course import Course, course_along, course_of
from bodymeasure.geodesic.across.poles.fan import Poles, fan_at, poles_of
from bodymeasure.geodesic.across.poles.graded import graded_path
from bodymeasure.geodesic.across.poles.layout import past_pole
from bodymeasure.geodesic.across.poles.pole_to_pole import between_poles
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.search.leg import Ends, first_routes, leg_along, shortest_leg
from bodymeasure.geodesic.across.search.repair import TOLERANCE, Search, repaired
from bodymeasure.geodesic.across.search.search import GOOD_ENOUGH
from bodymeasure.geodesic.across.search.tried import TriedRoutes
from bodymeasure.geodesic.lengths.length import TRUSTED_CORRECTION
from bodymeasure.geodesic.status import Status

# A path passes close by a pole if it is nearer to it than this part of its length, or of the width
# of the patches there. Farther away, polynomials follow it well.
NEAR = 0.25
# It does so as well, however short it is, if it comes nearer than this part of the patches.
AT = 1e-5
# The degree at which a path is first refined, to see whether it is close to a pole.
ROUGH = 8
# A path that passes a pole within this part of its shorter leg is close to both legs.
CLOSE = 0.05
# A path past a pole is composed of its legs if that has at most this relative error.
EXACT = 1e-10
# A path about a pole of this part of the radius of curvature is that over a cone.
TINY = 1e-5
# Poles are sought close to the legs of a path past a pole, too, but no deeper.
DEPTH = 2
# The most routes close by poles that are tried, by depth: all have the same legs to a pole.
MOST_CLOSE = (0, 1, 2)


class Ground(NamedTuple):
    """What all steps of the way to a path need.

    Parameters
    ----------
    atlas : Atlas
    neighbors : Neighbors
    budget : Budget
    legs : dict
        The legs to poles and from them that were found, by their ends and the depth.
    past : dict
        The paths that begin as a line past a pole, by their ends and the pole.
    """

    atlas: Atlas
    neighbors: Neighbors
    budget: Budget
    legs: dict[tuple[Ends, int], AtlasPath]
    past: dict[tuple[Ends, AtlasPoint], AtlasPath | None]


def leg_between(
    atlas: Atlas, neighbors: Neighbors, start: AtlasPoint, end: AtlasPoint
) -> AtlasPath:
    """Return the shortest path between two points that was found.

    A path that passes close by a pole is composed of the geodesics to the pole and from it, if it
    is so close that no more is needed (`junction`); else it is cut about the pole (`cuts`).
    """
    ends = (start, end)
    if not len(poles_of(atlas).patch):
        return shortest_leg(atlas, neighbors, ends, Budget(PATH))
    ground = Ground(atlas, neighbors, Budget(WITH_POLES), {}, {})
    path = _past_poles(ground, ends)
    if ground.budget.cut_short and path.status is Status.CONVERGED:
        return replace(path, status=Status.CUT_SHORT)
    return path


def _past_poles(ground: Ground, ends: Ends) -> AtlasPath:
    """Return the shortest path over an atlas that has poles."""
    atlas, neighbors = ground[:2]
    other = between_poles(atlas, neighbors, ends, ground.budget)
    if other is None or not other.converged:
        return _between(ground, ends, DEPTH)
    if other.error_estimate <= TOLERANCE * other.length and not _is_undercut(ground, other):
        return other
    path = _between(ground, ends, DEPTH)
    shorter = other.length + other.error_estimate < path.length - path.error_estimate
    return other if shorter or not path.converged else path


def _is_undercut(ground: Ground, path: AtlasPath) -> bool:
    """Return whether a path along one of the likeliest routes is shorter, even roughly."""
    ends = path.points[0], path.points[-1]
    routes = first_routes(ground.atlas, ground.neighbors, ends, ground.budget)
    least = path.length - path.error_estimate
    return any(rough.length < least for rough in map(partial(_rough, ground), routes) if rough)


def _between(ground: Ground, ends: Ends, depth: int) -> AtlasPath:
    atlas, neighbors, budget = ground[:3]
    if depth == 0 or neighbors.are_same(*ends):
        return shortest_leg(atlas, neighbors, ends, budget)
    beside = beside_pole(atlas, neighbors, ends)
    if beside is not None:
        return beside
    found: list[AtlasPath] = []
    far: list[Route] = []
    for route in first_routes(atlas, neighbors, ends, budget):
        if found and budget.has_run_out():
            break
        rough = _rough(ground, route)
        pole = None if rough is None else _close_pole(atlas, neighbors, ends, rough)
        if rough is None or pole is None:
            far.append(route)
        elif len(found) < MOST_CLOSE[depth]:
            found.append(_by_pole(ground, ends, (pole, rough), depth))
    if far or not found:
        found.append(
            leg_along(atlas, neighbors, ends, far, budget)
            if far
            else shortest_leg(atlas, neighbors, ends, budget)
        )
    return min(found, key=lambda path: (not path.converged, path.length))


def _leg(ground: Ground, ends: Ends, depth: int) -> AtlasPath:
    """Return the leg between a point and a pole: all routes close by that pole have the same."""
    if (ends, depth) not in ground.legs:
        ground.legs[ends, depth] = _between(ground, ends, depth)
    return ground.legs[ends, depth]


def _by_pole(
    ground: Ground, ends: Ends, near: tuple[AtlasPoint, RefinedPath], depth: int
) -> AtlasPath:
    """Return the shortest path along a route that leads close by a pole."""
    past = _past(ground, ends, near, depth)
    if past is not None and past.path is not None:
        return past.path
    composed = None if past is None else past.composed
    if composed is not None and composed.error_estimate > GOOD_ENOUGH * composed.length:
        composed = None
    if composed is not None and ground.budget.has_run_out():
        return composed
    routes = [near[1].problem.route]
    plain = leg_along(ground.atlas, ground.neighbors, ends, routes, ground.budget)
    return plain if composed is None or plain.converged else composed


def _rough(ground: Ground, route: Route) -> RefinedPath | None:
    """Return the shortest path along a route, roughly."""
    straight = [(start.patch, np.array([start[1:], end[1:]])) for start, end in route.pieces]
    size = Course(tuple(straight), route.crossings).length(ground.atlas)
    if not size > 0.0:
        return None
    rough = refine(ground.atlas, route, ROUGH, size)
    ground.budget.spend(rough)
    return rough


def _close_pole(
    atlas: Atlas, neighbors: Neighbors, ends: Ends, rough: RefinedPath
) -> AtlasPoint | None:
    """Return a place of the pole to which a path is closest; None if it is close to none."""
    pieces = course_along(rough).pieces
    points = np.vstack([evaluate(atlas.control_points[patch], x) for patch, x in pieces])
    poles, length = poles_of(atlas), np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    if not length > 0.0:
        return None
    away = np.linalg.norm(points[:, None] - poles.positions, axis=2).min(axis=0)
    passed = {_pole_of(neighbors, poles, end) for end in ends}
    for number in np.argsort(away / np.minimum(poles.widths, length), kind="stable").tolist():
        if away[number] >= max(NEAR * min(poles.widths[number], length), AT * poles.widths[number]):
            return None
        if poles.point[number] not in passed:
            return poles.place(number)
    return None


def _pole_of(neighbors: Neighbors, poles: Poles, place: AtlasPoint) -> int | None:
    """Return the control point of the pole at a place; None if there is none."""
    side = neighbors.pole_side(place)
    on = (poles.patch == place.patch) & (poles.side == side)
    return int(poles.point[on][0]) if on.any() else None


class _Past(NamedTuple):
    """A path close by a pole.

    Parameters
    ----------
    path : AtlasPath or None
        None if there is none with a good length.
    composed : AtlasPath
        The path over its legs, less what it gains on them.
    """

    path: AtlasPath | None
    composed: AtlasPath


def _past(
    ground: Ground, ends: Ends, near: tuple[AtlasPoint, RefinedPath], depth: int
) -> _Past | None:
    """Return the path close by a pole; None if the legs have no good lengths."""
    (place, rough), (atlas, neighbors, budget) = near, ground[:3]
    fan = fan_at(atlas, place)
    if fan is None:
        return None
    first, second = (
        radial(fan, leg) or _leg(ground, leg, depth - 1)
        for leg in ((ends[0], place), (place, ends[1]))
    )
    if not (first.converged and second.converged):
        return None
    found = composed_path(ends, fan, (first, second))
    if found is None:
        return None
    composed, gained = found
    length, gain = composed.raw_length, composed.raw_length - composed.length
    # Rounding errors leave nothing to refine where both ends are right beside the pole.
    exact = composed.error_estimate <= EXACT * length and gain <= TRUSTED_CORRECTION * length
    if exact or length * fan.curvature <= TINY:
        return _Past(composed, composed)
    if gained.conjugate:
        # Paths that differ by little in length may be anywhere.
        return _Past(None, composed)
    good = []
    before, after = course_of(neighbors, first), course_of(neighbors, second)
    if before is not None and after is not None:
        lengths = first.length, second.length
        if (ends, place) not in ground.past:
            course = past_pole(fan, before, after, lengths, gained.away)
            past = None if course is None else graded_path(atlas, neighbors, ends, course, budget)
            ground.past[ends, place] = past
        path = ground.past[ends, place]
        if path is not None and gained.away < CLOSE * min(lengths):
            return _Past(path, composed)
        good.append(path)
    good.append(graded_path(atlas, neighbors, ends, course_along(rough), budget))
    shortest = min((path.length for path in good if path), default=np.inf)
    if good[-1] is None and shortest > rough.length:
        search = Search(atlas, neighbors, rough.problem.size, budget)
        best, _, _ = repaired(search, rough, TriedRoutes((rough.route,)))
        good.append(graded_path(atlas, neighbors, ends, course_along(best), budget))
    path = min((path for path in good if path), key=lambda path: path.length, default=None)
    return _Past(path, composed)
