"""A course cut into parts on which it is smooth, and refined.

Close to a pole all scales occur at once: a path that passes it at a distance h turns by nearly pi
on a way of a few h. Its pieces are therefore cut at lines w = constant about the pole, at distances
that grow like the powers of a number; on each part the path is as smooth as far from poles. A cut
is the crossing of a line within a patch; where it crosses is an unknown, as on seams.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Crossing, Neighbors
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.across.pieces.problem import EPSILON, RouteProblem
from bodymeasure.geodesic.across.pieces.refine import (
    LEAST_EPSILON,
    RefinedPath,
    measured,
    resampled,
    sharpened,
)
from bodymeasure.geodesic.across.poles.course import Course
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.routes.topology import topology
from bodymeasure.geodesic.spaces.polynomials import polynomial_space

# The first cut lies at this many times the least distance of a piece from the pole, and each cut
# this many times as far away as the one before.
FIRST, FACTOR = 1.4, 3.0
# No cut lies closer to the end of a piece than this part of its distance from the pole, and none
# beyond the middle of a patch, from where another pole may be nearer.
END, FAR = 0.7, 0.5
# What smooths the length (see `problem.EPSILON`) is below this part of the length of the shortest
# part, whose ends it would move.
SMALL = 1e-4


# Cuts that are within this factor of where they would be put stay where they are.
FITS = 1.7
# A part beside a cut has no length if it is below this part of the distance from the pole.
HELD = 5e-2


class Cut(NamedTuple):
    """A course that is cut.

    Parameters
    ----------
    route : Route
        With the cuts among its crossings.
    parts : list of ndarray of shape (k, 2)
        Points of each part.
    least : tuple of float
        The distance of the first cut of each piece from each pole, in the parameter.
    """

    route: Route
    parts: list[Array]
    least: tuple[float, ...]

    def hold(self, refined: RefinedPath) -> bool:
        """Return whether a path would be shorter if it did not have to cross all the lines.

        It then has a part of no length between two of them, or between one and a seam, or it turns
        back at one.
        """
        for number, crossing in enumerate(self.route.crossings):
            if crossing.within is None:
                continue
            axis, along = EDGES[crossing.from_side].fixed_axis, refined.route.along[number]
            before, after = refined.values[number, axis, -2], refined.values[number + 1, axis, 1]
            if (crossing.within - before) * (after - crossing.within) < 0.0:
                return True
            # The same place of the line, and of the pole.
            places = np.full((2, 2), along)
            places[:, axis] = crossing.within, np.round(crossing.within)
            surface = refined.problem.surface.take(np.array([number]))
            away = np.linalg.norm(np.subtract(*surface.positions(places[None])[0]))
            if refined.lengths[[number, number + 1]].min() < HELD * away:
                return True
        return False

    def fits(self, other: "Cut") -> bool:
        """Return whether another course has its cuts about where this one has them."""
        if len(self.least) != len(other.least):
            return False
        pairs = zip(self.least, other.least, strict=True)
        return all(here < FITS * there and there < FITS * here for here, there in pairs)


class _Place(NamedTuple):
    """A place where a piece is cut: how far along its points, and the line."""

    at: float
    axis: int
    value: float


def cut(neighbors: Neighbors, course: Course, first: float = FIRST) -> Cut:
    """Return a course with its pieces cut about poles.

    Parameters
    ----------
    neighbors : Neighbors
    course : Course
    first : float
        The distance of the first cut from the pole, as a multiple of the course's own.
    """
    parts: list[Array] = []
    crossings: list[Crossing] = []
    along: list[float] = []
    least: list[float] = []
    for number, (patch, points) in enumerate(course.pieces):
        if number:
            crossing = course.crossings[number - 1]
            crossings.append(crossing)
            along.append(float(parts[-1][-1, 1 - EDGES[crossing.from_side].fixed_axis]))
        places, nearest = _places(neighbors, patch, points, first)
        least += nearest
        bounds = [0.0, *(place.at for place in places), len(points) - 1.0]
        parts += [_between(points, *ends) for ends in pairwise(bounds)]
        for place, part in zip(places, parts[-len(places) - 1 : -1], strict=True):
            side = 2 * place.axis
            crossings.append(Crossing(-1, side, side, patch, False, place.value))
            along.append(float(part[-1, 1 - place.axis]))
    return Cut(Route(course.ends, tuple(crossings), tuple(along)), parts, tuple(least))


def refined_cut(
    atlas: Atlas, cut_course: Cut, degree: int, size: float, before: RefinedPath | None = None
) -> RefinedPath:
    """Return the shortest path along a course that is cut.

    Parameters
    ----------
    atlas : Atlas
    cut_course : Cut
    degree : int
        The degree of the polynomial on each part.
    size : float
        About the length of the path.
    before : RefinedPath, optional
        A path with the same cuts to start from.
    """
    space = polynomial_space(degree)
    ways = [_ways(atlas, patch, points) for patch, points in _patches(cut_course)]
    lengths = np.array([way[-1] for way in ways]) / size
    least = (SMALL * lengths[lengths > 0.0].min(initial=1.0)) ** 2
    epsilon = float(np.clip(least, LEAST_EPSILON, EPSILON))
    start, end = map(topology(atlas).neighbors.pole_side, cut_course.route.ends or ())
    problem = RouteProblem(atlas, cut_course.route, space, size, (start, end), epsilon)
    if before is None:
        inner = [
            [np.interp(space.nodes[1:-1] * way[-1], way, axis) for axis in points.T]
            for way, points in zip(ways, cut_course.parts, strict=True)
        ]
        guess = problem.unknowns(np.array(inner))
    else:
        guess = resampled(before, problem)
    minimum = problem.minimized(guess)
    return sharpened(measured(problem, minimum), problem.idle)


def _patches(cut_course: Cut) -> list[tuple[int, Array]]:
    return list(zip(cut_course.route.patches, cut_course.parts, strict=True))


def _ways(atlas: Atlas, patch: int, points: Array) -> Array:
    """Return the length of the polygon up to each of its points."""
    x = evaluate(atlas.control_points[patch], points)
    steps = np.linalg.norm(np.diff(x, axis=0), axis=1)
    # The lengths increase, so that there is a point at each of them.
    return np.concatenate([[0.0], np.cumsum(np.maximum(steps, 1e-300))])


def _places(
    neighbors: Neighbors, patch: int, points: Array, first: float
) -> tuple[list[_Place], list[float]]:
    """Return where a piece is cut, in order, and the distances of the first cuts."""
    sides = [side for side in range(len(EDGES)) if neighbors.collapsed[patch, side]]
    away = {
        side: np.abs(points[:, EDGES[side].fixed_axis] - EDGES[side].fixed_value) for side in sides
    }
    if not sides:
        return [], []
    # Lines about poles on adjoining sides would cross: the nearest pole counts.
    nearest = EDGES[min(sides, key=lambda side: float(away[side].min()))].fixed_axis
    places: list[_Place] = []
    least: list[float] = []
    for side in sides:
        edge, w = EDGES[side], away[side]
        if edge.fixed_axis != nearest or w.min() == 0.0:
            continue
        middle = int(np.argmin(w))
        found = [
            (middle + way * at, level)
            for way, outward in ((1.0, w[middle:]), (-1.0, w[middle::-1]))
            for at, level in _outward(outward, first)
        ]
        sign = 1.0 - 2.0 * edge.fixed_value
        places += [
            _Place(at, edge.fixed_axis, edge.fixed_value + sign * level) for at, level in found
        ]
        least += [min(level for _, level in found)] if found else []
    return sorted(places), least


def _outward(w: Array, first: float) -> list[tuple[float, float]]:
    """Return where points that lead away from a pole pass the levels of cuts, and the levels."""
    result = []
    level = first * float(w[0])
    while level < min(END * float(w[-1]), FAR):
        after = int(np.argmax(w >= level))
        step = (level - w[after - 1]) / (w[after] - w[after - 1])
        result.append((after - 1 + float(step), level))
        level *= FACTOR
    return result


def _between(points: Array, begin: float, end: float) -> Array:
    """Return the points of a polygon from one place of it to another."""
    number = np.arange(len(points))
    inner = (number > begin) & (number < end)
    at = np.concatenate([[begin], number[inner], [end]])
    return np.stack([np.interp(at, number, axis) for axis in points.T], axis=-1)
