"""The choice of patches by region, and of one point among several that are equally good."""

from collections.abc import Sequence

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.routes.topology import extent
from bodymeasure.wording import hint

# Coordinates that differ by less than this fraction of the atlas's size are equal. Mirror images
# differ by their rounding, and by the 1e-11 by which a section's plane may be moved.
TIE = 1e-9


def direction_vector(atlas: Atlas, name: str) -> Array:
    """Return the unit vector, shape (3,), of a direction by its name, as the wearer sees it."""
    axes = atlas.axes
    vectors = {"up": axes.up_vector, "front": axes.front_vector, "left": axes.left_vector}
    opposite = {"down": "up", "back": "front", "right": "left"}
    return vectors[name] if name in vectors else -vectors[opposite[name]]


def patches_of_regions(atlas: Atlas, beginnings: Sequence[str]) -> Ints:
    """Return the patches whose regions begin with one of some words.

    Raises
    ------
    InputError
        If no region begins with one of the words.
    """
    known = sorted(set(filter(None, atlas.regions)))
    if not known:
        raise InputError(
            "the atlas has no body regions, by which the rule chooses patches; name them"
        )
    for beginning in beginnings:
        if not any(region.startswith(beginning) for region in known):
            raise InputError(
                f"no region of the atlas begins with {beginning!r}; {hint(beginning, known)}"
            )
    chosen = [region.startswith(tuple(beginnings)) for region in atlas.regions]
    return np.flatnonzero(chosen)


def preferred(atlas: Atlas, points: Sequence[AtlasPoint]) -> AtlasPoint:
    """Return the point farthest to the wearer's left; among equal ones, farthest to the front."""
    positions = np.stack([atlas.position(point) for point in points])
    best = np.arange(len(points))
    for direction in (atlas.axes.left_vector, atlas.axes.front_vector):
        coordinate = positions[best] @ direction
        best = best[coordinate >= coordinate.max() - TIE * extent(atlas)]
    return points[int(best[0])]
