"""Landmarks on horizontal sections: outermost points, and points of the median plane."""

from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.landmarks.choice import TIE, atlas_size, direction_vector, preferred
from bodymeasure.chart.landmarks.rules import GirthLevel, Level, Median
from bodymeasure.errors import InputError
from bodymeasure.measure import Extremum, extreme_girth
from bodymeasure.measure.body.girths import section_loop
from bodymeasure.measure.body.merging import refuse_merged
from bodymeasure.section import Plane, SectionLoop, convex_hull, plane_section
from bodymeasure.section.farthest import LoopPlaces, atlas_point, local_maxima, places_on

# Of the atlas's size: so close to the median plane, a place is on it. Rounding is far below.
ON_PLANE = 1e-13
# Steps a piece between which a section crosses the median plane at most once.
STEPS = 12
ROOT_TOLERANCE = 1e-15


def level_point(atlas: Atlas, rule: Level, positions: dict[str, Array]) -> AtlasPoint:
    """The point that a `Level` rule gives.

    Raises
    ------
    InputError
        If the plane has no clean section, the curve is open where it is outermost, or merges trunk
        and arm and its side is asked for.
    """
    return _outermost(atlas, positions[rule.of], positions[rule.of], rule.facing)


def _outermost(atlas: Atlas, at: Array, near: Array, facing: str) -> AtlasPoint:
    """The outermost point at one place's height of the loop that is nearest to another."""
    section = plane_section(atlas, Plane(at, atlas.axes.up_vector))
    loop = section.nearest(near)
    if facing in ("left", "right"):
        # In front and behind, an arm beside the trunk does no harm.
        refuse_merged(section, loop, limb=False)
    direction = direction_vector(atlas, facing)
    places = local_maxima(loop, direction)
    coordinate = places.position @ direction
    tie = TIE * atlas_size(atlas)
    best = np.flatnonzero(coordinate >= coordinate.max() - tie)
    if not loop.closed and any(_is_end(loop, places, int(k)) for k in best):
        raise InputError(
            f"the section at that height ends on the boundary of the atlas, just where it reaches "
            f"farthest to the {facing}; the body may reach farther"
        )
    # Of two that are mirror images, the one on the landmark's own side.
    apart = np.linalg.norm(places.position[best] - near, axis=1)
    best = best[apart <= apart.min() + tie]
    return preferred(atlas, [atlas_point(loop, places, int(k)) for k in best])


def _is_end(loop: SectionLoop, places: LoopPlaces, number: int) -> bool:
    place = places.piece[number] + places.fraction[number]
    return bool(place == 0.0 or place == len(loop.pieces))


def median_point(atlas: Atlas, rule: Median, positions: dict[str, Array]) -> AtlasPoint:
    """The point that a `Median` rule gives.

    Raises
    ------
    InputError
        If the plane has no clean section, or the body is not met in the median plane.
    """
    section = plane_section(atlas, Plane(positions[rule.of], atlas.axes.up_vector))
    median = Plane(positions[rule.through], atlas.axes.left_vector)
    found = []
    for loop in section.loops:
        places = _crossings(loop, median, ON_PLANE * atlas_size(atlas))
        found += [(places.position[k], atlas_point(loop, places, k)) for k in range(len(places[0]))]
    if not found:
        raise InputError(
            f"at the height of {rule.of!r}, no part of the body lies in the median plane through "
            f"{rule.through!r}"
        )
    coordinate = np.array([place for place, _ in found]) @ direction_vector(atlas, rule.facing)
    return found[int(np.argmax(coordinate))][1]


def _crossings(loop: SectionLoop, plane: Plane, near: float) -> LoopPlaces:
    """Places at which a loop meets a plane that cuts its own."""
    grid = np.broadcast_to(np.arange(STEPS + 1) / STEPS, (len(loop.pieces), STEPS + 1))
    side = plane.distances(loop.surface.points(loop.pieces, grid)[1])
    on_plane = np.abs(side) <= near
    side = np.where(on_plane, 0.0, side)
    piece, step = np.nonzero(side[:, :-1] * side[:, 1:] < 0.0)

    def root(number: int, low: float, high: float) -> float:
        row = loop.pieces.take(np.array([number]))

        def distance(fraction: float) -> float:
            points = loop.surface.points(row, np.array([[fraction]]))[1]
            return float(plane.distances(points)[0, 0])

        return float(scipy.optimize.brentq(distance, low, high, xtol=ROOT_TOLERANCE))

    roots = [root(int(i), j / STEPS, (j + 1) / STEPS) for i, j in zip(piece, step, strict=True)]
    there, at = np.nonzero(on_plane)
    return places_on(
        loop, np.concatenate([piece, there]), np.concatenate([np.array(roots), at / STEPS])
    )


def girth_level_point(atlas: Atlas, rule: GirthLevel, positions: dict[str, Array]) -> AtlasPoint:
    """The point that a `GirthLevel` rule gives; the tape is drawn taut.

    Raises
    ------
    InputError
        As `bodymeasure.measure.body.extreme_girth`, or if the girth is extreme at an end of the
        stretch, where a more extreme one may lie beyond.
    """
    start, end = positions[rule.start], positions[rule.end]
    found = extreme_girth(atlas, start, end, rule.extreme, tape="taut")
    if found.status is not Extremum.INSIDE:
        raise InputError(
            f"the {rule.extreme} girth from {rule.start!r} to {rule.end!r} is {found.status}"
        )
    stretch = _Stretch(atlas, start, end)
    at = stretch.point(_polished(stretch, found.fraction))
    return _outermost(atlas, at, at, rule.facing)


class _Stretch(NamedTuple):
    atlas: Atlas
    start: Array
    end: Array

    def point(self, fraction: float) -> Array:
        return self.start + fraction * (self.end - self.start)

    def girth(self, fraction: float) -> float:
        point = self.point(fraction)
        plane = Plane(point, self.atlas.axes.up_vector)
        return convex_hull(section_loop(self.atlas, plane, point)).length


# Of the stretch. Girths hold to 1e-13: over steps this wide, their slope holds to 1e-10, and what
# four of them leave out is as small.
STEP = 2e-3
# Newton's steps; the slope is all but straight so near the extreme.
ROUNDS = 3
# Of the stretch. Farther than that from where the search ended, the girth has a kink.
FARTHEST = 1e-4


def _polished(stretch: _Stretch, fraction: float) -> float:
    """Where the girth's slope vanishes: a search by values alone leaves half of the digits."""
    start = fraction
    for _ in range(ROUNDS):
        values = [stretch.girth(fraction + k * STEP) for k in (-2, -1, 0, 1, 2)]
        slope = (values[0] - 8.0 * values[1] + 8.0 * values[3] - values[4]) / 12.0
        bend = (
            -values[0] + 16.0 * values[1] - 30.0 * values[2] + 16.0 * values[3] - values[4]
        ) / 12.0
        if bend == 0.0:
            return start
        fraction -= STEP * slope / bend
        if abs(fraction - start) > FARTHEST:
            return start
    return fraction
