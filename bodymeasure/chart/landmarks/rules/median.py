"""Landmarks on the median plane."""

from typing import ClassVar, Literal

import numpy as np
import scipy

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.entry import Landmark
from bodymeasure.chart.landmarks.choice import direction_vector
from bodymeasure.chart.landmarks.rules.base import LandmarkRule, Landmarks
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.routes.topology import extent
from bodymeasure.section import Plane, SectionLoop, plane_section
from bodymeasure.section.places import LoopPlaces, places_on, point_of_place

# A place within this fraction of the atlas's size from the median plane lies on it. Rounding is far
# smaller.
ON_PLANE = 1e-13
# Steps on a piece, so that a section crosses the median plane at most once in each.
STEPS = 12
ROOT_TOLERANCE = 1e-15


class Median(LandmarkRule, frozen=True, kw_only=True, tag="median"):
    """The front or back point of the median plane at a landmark's height.

    Parameters
    ----------
    of : str
        The landmark at whose height the point lies.
    through : str
        A landmark through which the median plane runs, from front to back.
    facing : {"front", "back"}
    """

    example: ClassVar[str] = """
        of = "shoulder point left"
        through = "back neck point"
        facing = "back"
    """

    of: Landmark
    through: Landmark
    facing: Literal["front", "back"]

    @property
    def description(self) -> str:
        return (
            f"{self.facing} of the median plane through {self.through} at the height of {self.of}"
        )

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        of, through = (atlas.position(landmarks[name]) for name in (self.of, self.through))
        section = plane_section(atlas, Plane(of, atlas.axes.up_vector))
        median = Plane(through, atlas.axes.left_vector)
        direction = direction_vector(atlas, self.facing)
        found = []
        for loop in section.loops:
            places = _crossings(loop, median, ON_PLANE * extent(atlas))
            found += [
                (float(places.position[k] @ direction), loop, point_of_place(loop, places, k))
                for k in range(len(places[0]))
            ]
        if not found:
            raise InputError(
                f"at the height of {self.of!r}, no part of the body lies in the median plane "
                f"through {self.through!r}"
            )
        coordinate, loop, point = max(found, key=lambda candidate: candidate[0])
        if not loop.closed and (loop.positions[[0, -1]] @ direction).max() > coordinate:
            raise InputError(
                f"at the height of {self.of!r}, the body is open at the {self.facing}: the atlas "
                "ends below; pick the point"
            )
        return point


def _crossings(loop: SectionLoop, plane: Plane, near: float) -> LoopPlaces:
    """Return the places at which a loop meets a plane that cuts the loop's own plane."""
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
