"""Choosing patches by region, and one point of several that are equally good."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.errors import InputError
from bodymeasure.wording import hint

# Of the atlas's size: coordinates that differ by less are equal. Mirror images differ by their
# rounding, and by the 1e-11 by which a section's plane may be moved.
TIE = 1e-9


def atlas_size(atlas: Atlas) -> float:
    """Largest extent of the control points along an axis, in the atlas's unit."""
    return float(np.ptp(atlas.points, axis=0).max())


def direction_vector(atlas: Atlas, name: str) -> NDArray[np.float64]:
    """Unit vector of a direction by its name, as the wearer sees it, shape (3,)."""
    axes = atlas.axes
    vectors = {"up": axes.up_vector, "front": axes.front_vector, "left": axes.left_vector}
    opposite = {"down": "up", "back": "front", "right": "left"}
    return vectors[name] if name in vectors else -vectors[opposite[name]]


def patches_of_regions(atlas: Atlas, beginnings: Sequence[str]) -> NDArray[np.int64]:
    """Patches whose regions begin with one of some words.

    Raises
    ------
    InputError
        If there is none for one of them.
    """
    known = sorted(set(filter(None, atlas.regions)))
    if not known:
        raise InputError("the atlas has no body regions, by which the rule chooses patches")
    for beginning in beginnings:
        if not any(region.startswith(beginning) for region in known):
            raise InputError(
                f"no region of the atlas begins with {beginning!r}; {hint(beginning, known)}"
            )
    chosen = [region.startswith(tuple(beginnings)) for region in atlas.regions]
    return np.flatnonzero(chosen)


def preferred(atlas: Atlas, points: Sequence[AtlasPoint]) -> AtlasPoint:
    """The one farthest to the wearer's left, or of equal ones to the front."""
    positions = np.stack([atlas.position(point) for point in points])
    best = np.arange(len(points))
    for direction in (atlas.axes.left_vector, atlas.axes.front_vector):
        coordinate = positions[best] @ direction
        best = best[coordinate >= coordinate.max() - TIE * atlas_size(atlas)]
    return points[int(best[0])]
