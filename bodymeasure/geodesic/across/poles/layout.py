"""A straight line past a pole, laid over the patches of its fan."""

from dataclasses import dataclass, replace

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.point import ON_EDGE
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Crossing, on_side
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.across.poles.course import Course
from bodymeasure.geodesic.across.poles.fan import Fan

# The line joins the legs halfway between the pole and where they enter its fan; it begins at the
# very end of a leg that is at most this part of the other.
WHOLE = 0.1
# A line passes the pole at no less than this part of the distances of its ends, to be drawn.
LEAST = 1e-9
# Points on each patch, and angles that differ by rounding only.
POINTS, ROUNDING = 65, 1e-9


@dataclass(frozen=True)
class _Line:
    """A straight line in polar coordinates: its least distance, the angle there, its farthest."""

    least: float
    foot: float
    farthest: float

    @classmethod
    def through(cls, first: float, second: float, turn: float, away: float) -> "_Line":
        """Return the line from (first, 0) to (second, turn).

        If it nearly goes straight on, it bends so that it passes at the distance that is given: on
        a curved surface that may be many times what it is in the plane.
        """
        side = np.sqrt((first - second) ** 2 + 4.0 * first * second * np.sin(0.5 * turn) ** 2)
        least = first * second * np.sin(turn) / side if side > 0.0 else first
        least = away if turn > 0.5 * np.pi else least
        least = float(np.clip(least, LEAST * min(first, second), min(first, second)))
        inward = first >= second * np.cos(turn)
        foot = float(np.arccos(least / first)) * (1.0 if inward else -1.0)
        return cls(least, foot, max(first, second))

    def between(self, begin: float, end: float) -> tuple[Array, Array]:
        """Return angles and distances of points, closest together where the line turns fastest."""
        bounds = np.clip(np.array([begin, end]) - self.foot, -0.5 * np.pi, 0.5 * np.pi)
        most = self.farthest / self.least
        ends = np.arcsinh(np.clip(np.tan(bounds), -most, most))
        angles = self.foot + np.arctan(np.sinh(np.linspace(ends[0], ends[1], POINTS)))
        angles = np.clip(angles, begin, end)
        angles[[0, -1]] = begin, end
        cosine = np.maximum(np.cos(angles - self.foot), self.least / self.farthest)
        return angles, self.least / cosine


def past_pole(
    fan: Fan, before: Course, after: Course, lengths: tuple[float, float], away: float
) -> Course | None:
    """Return the course of two legs that meet at a pole, past it on the side of the smaller angle.

    Parameters
    ----------
    fan : Fan
    before, after : Course
        The legs to the pole and from it.
    lengths : pair of float
        Their lengths.
    away : float
        About how far from the pole the shortest path passes.

    Returns
    -------
    Course or None
        None if a leg does not end in the fan.
    """
    numbers = fan.sector(before.ends[1]), fan.sector(after.ends[0])
    first, second = fan.direction(before.ends[1]), fan.direction(after.ends[0])
    if numbers[0] is None or numbers[1] is None or first is None or second is None:
        return None
    ways = fan.ways(first, second)
    turn, onward = min(ways), ways[0] <= ways[1]
    if not np.isfinite(turn):
        return None
    (patch, inward), (other, outward) = before.pieces[-1], after.pieces[0]
    kept, near = _shortened(fan, patch, inward, lengths[0] <= WHOLE * lengths[1])
    beyond, there = _shortened(fan, other, outward[::-1], lengths[1] <= WHOLE * lengths[0])
    line = _Line.through(near, there, turn, away)
    offset = first - fan.sectors[numbers[0]].begin
    pieces, crossings = _over_sectors(fan, line, (numbers[0], offset, numbers[1]), (turn, onward))
    pieces[0] = (patch, np.vstack([kept, pieces[0][1][1:]]))
    pieces[-1] = (other, np.vstack([pieces[-1][1][:-1], beyond[::-1]]))
    return _without_empty_ends(
        Course(
            (*before.pieces[:-1], *pieces, *after.pieces[1:]),
            (*before.crossings, *crossings, *after.crossings),
        )
    )


def _shortened(fan: Fan, patch: int, points: Array, whole: bool) -> tuple[Array, float]:
    """Return the points of a piece that ends at the pole before it is near, and the distance."""
    x = evaluate(fan.atlas.control_points[patch], points)
    away = np.linalg.norm(x - x[-1], axis=1)
    last = 0 if whole else int(np.argmax(away < 0.5 * away[0])) - 1
    last = max(last, 0)
    return points[: last + 1], float(away[last])


def _over_sectors(
    fan: Fan, line: _Line, ends: tuple[int, float, int], way: tuple[float, bool]
) -> tuple[list[tuple[int, Array]], list[Crossing]]:
    """Return the pieces of a line past the pole and the crossings between them."""
    (number, offset, target), (turn, onward) = ends, way
    pieces: list[tuple[int, Array]] = []
    crossings: list[Crossing] = []
    done = 0.0
    for _ in range(len(fan.sectors) + 1):
        sector = fan.sectors[number]
        stop = min(done + max(sector.angle - offset if onward else offset, 0.0), turn)
        angles, distances = line.between(done, stop)
        here = offset + (angles - done) * (1.0 if onward else -1.0)
        pieces.append((sector.patch, fan.places(number, here, distances)))
        crossing = sector.onward if onward else sector.back
        if (number == target and stop >= turn - ROUNDING) or crossing is None:
            break
        crossings.append(crossing)
        number = (number + (1 if onward else -1)) % len(fan.sectors)
        offset, done = (0.0 if onward else fan.sectors[number].angle), stop
    return pieces, crossings


def _without_empty_ends(course: Course) -> Course:
    """Return a course whose first and last piece have a length, where its ends lie on seams."""
    pieces, crossings = course.pieces, course.crossings
    if crossings and _is_point(pieces[0][1]):
        crossing, points = crossings[0], pieces[1][1].copy()
        along = pieces[0][1][0, 1 - EDGES[crossing.from_side].fixed_axis]
        points[0] = on_side(crossing.to_side, 1.0 - along if crossing.flipped else along)
        pieces = ((pieces[1][0], points), *pieces[2:])
        crossings = crossings[1:]
    if crossings and _is_point(pieces[-1][1]):
        crossing, points = crossings[-1], pieces[-2][1].copy()
        along = pieces[-1][1][-1, 1 - EDGES[crossing.to_side].fixed_axis]
        points[-1] = on_side(crossing.from_side, 1.0 - along if crossing.flipped else along)
        pieces = (*pieces[:-2], (pieces[-2][0], points))
        crossings = crossings[:-1]
    return replace(course, pieces=pieces, crossings=crossings)


def _is_point(points: Array) -> bool:
    return bool(np.ptp(points, axis=0).max() <= ON_EDGE)
