"""Landmarks that lie farthest in a direction of some regions."""

from typing import ClassVar

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.queries.farthest import farthest_on_patches
from bodymeasure.chart.entry import Landmark
from bodymeasure.chart.landmarks.choice import (
    TIE,
    direction_vector,
    patches_of_regions,
    preferred,
)
from bodymeasure.chart.landmarks.rules.base import Direction, LandmarkRule, Landmarks, towards
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.routes.topology import extent
from bodymeasure.section import Plane, SectionLoop, plane_section
from bodymeasure.section.places import LoopPlaces, local_maxima, places_on, point_of_place


class Prominent(LandmarkRule, frozen=True, kw_only=True, tag="prominent"):
    """The point of some regions that lies farthest in a direction.

    Parameters
    ----------
    direction : {"front", "back", "left", "right", "{side}", "up", "down"}
    regions : tuple of str
        The beginnings of the regions' names.
    above, below : str, optional
        Landmarks between whose heights the point has to lie.
    """

    example: ClassVar[str] = """
        direction = "front"
        regions = ["torso"]
        below = "bust point left"
    """

    direction: Direction
    regions: tuple[str, ...]
    above: Landmark | None = None
    below: Landmark | None = None

    @property
    def description(self) -> str:
        limits = {"above": self.above, "below": self.below}
        between = " and".join(f" {word} {name}" for word, name in limits.items() if name)
        return f"farthest {towards(self.direction)} of {', '.join(self.regions)}{between}"

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        patches = patches_of_regions(atlas, self.regions)
        direction = direction_vector(atlas, self.direction)
        up = atlas.axes.up_vector
        low, high = (
            unlimited if name is None else float(atlas.position(landmarks[name]) @ up)
            for name, unlimited in ((self.above, -np.inf), (self.below, np.inf))
        )
        if low >= high:
            raise InputError(f"{self.above!r} is not below {self.below!r}, so nothing lies between")
        found = farthest_on_patches(atlas, patches, direction, (low, high))
        points = list(found.points)
        if found.at_limit:
            for limit in (low, high):
                if np.isfinite(limit):
                    points += _on_section(atlas, patches, direction, Plane(limit * up, up))
        if not points:
            raise InputError("no part of these regions lies between the two heights")
        far = np.array([atlas.position(point) @ direction for point in points])
        best = np.flatnonzero(far >= far.max() - TIE * extent(atlas))
        return preferred(atlas, [points[int(k)] for k in best])


def _on_section(atlas: Atlas, patches: Ints, direction: Array, plane: Plane) -> list[AtlasPoint]:
    """Return local maxima of the section's curves inside some patches."""
    points = []
    for loop in plane_section(atlas, plane).loops:
        inside = np.flatnonzero(np.isin(loop.pieces.patch, patches))
        for places in (local_maxima(loop, direction), _joints(loop)):
            points += [
                point_of_place(loop, places, int(k))
                for k in np.flatnonzero(np.isin(places.piece, inside))
            ]
    return points


def _joints(loop: SectionLoop) -> LoopPlaces:
    """Return both ends of each piece, where a curve may leave the regions."""
    piece = np.repeat(np.arange(len(loop.pieces)), 2)
    return places_on(loop, piece, np.tile([0.0, 1.0], len(loop.pieces)))
