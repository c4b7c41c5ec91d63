"""Landmarks that lie farthest in a direction of some regions."""

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.queries.farthest import farthest_on_patches
from bodymeasure.chart.landmarks.choice import (
    TIE,
    atlas_size,
    direction_vector,
    patches_of_regions,
    preferred,
)
from bodymeasure.chart.landmarks.rules import Prominent
from bodymeasure.errors import InputError
from bodymeasure.section import Plane, SectionLoop, plane_section
from bodymeasure.section.farthest import LoopPlaces, atlas_point, local_maxima, places_on


def prominent_point(atlas: Atlas, rule: Prominent, positions: dict[str, Array]) -> AtlasPoint:
    """The point that a `Prominent` rule gives; of mirror images, the one on the wearer's left.

    Raises
    ------
    InputError
        If no region begins as the rule says, nothing of them lies between the heights, or the
        surface is flat across the direction.
    """
    patches = patches_of_regions(atlas, rule.regions)
    direction = direction_vector(atlas, rule.direction)
    up = atlas.axes.up_vector
    low = -np.inf if rule.above is None else float(positions[rule.above] @ up)
    high = np.inf if rule.below is None else float(positions[rule.below] @ up)
    if low >= high:
        raise InputError(f"{rule.above!r} is not below {rule.below!r}, so nothing lies between")
    found = farthest_on_patches(atlas, patches, direction, (low, high))
    points = list(found.points)
    if found.at_limit:
        for limit in (low, high):
            if np.isfinite(limit):
                points += _on_section(atlas, patches, direction, Plane(limit * up, up))
    if not points:
        raise InputError("no part of these regions lies between the two heights")
    far = np.array([atlas.position(point) @ direction for point in points])
    best = np.flatnonzero(far >= far.max() - TIE * atlas_size(atlas))
    return preferred(atlas, [points[int(k)] for k in best])


def _on_section(
    atlas: Atlas, patches: NDArray[np.int64], direction: Array, plane: Plane
) -> list[AtlasPoint]:
    """Local maxima of the section's curves inside some patches."""
    points = []
    for loop in plane_section(atlas, plane).loops:
        inside = np.flatnonzero(np.isin(loop.pieces.patch, patches))
        for places in (local_maxima(loop, direction), _joints(loop)):
            points += [
                atlas_point(loop, places, int(k))
                for k in np.flatnonzero(np.isin(places.piece, inside))
            ]
    return points


def _joints(loop: SectionLoop) -> LoopPlaces:
    """Both ends of each piece: there a curve may leave the regions."""
    piece = np.repeat(np.arange(len(loop.pieces)), 2)
    return places_on(loop, piece, np.tile([0.0, 1.0], len(loop.pieces)))
