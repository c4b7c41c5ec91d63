"""Measures along straight lines: heights, breadths, depths, distances."""

import numpy as np

from bodymeasure.atlas import Atlas
from bodymeasure.atlas.queries.locations import Location, position_of
from bodymeasure.section import Curve, extent


def height(atlas: Atlas, at: Location, *, floor: float = 0.0) -> float:
    """Return the height of a place above the floor, along the atlas's way up, in its unit.

    Parameters
    ----------
    atlas : Atlas
    at : str, AtlasPoint or ndarray of shape (3,)
    floor : float
        Coordinate of the floor along the way up. Feet may be missing, so it is never guessed from
        the lowest point.
    """
    return float(position_of(atlas, at) @ atlas.axes.up_vector) - floor


def chord(atlas: Atlas, start: Location, end: Location) -> float:
    """Return the straight distance between two places, in the atlas's unit."""
    return float(np.linalg.norm(position_of(atlas, end) - position_of(atlas, start)))


def breadth(atlas: Atlas, loop: Curve) -> float:
    """Return the width of a loop from the wearer's left to right, in the loop's unit."""
    return extent(loop, atlas.axes.left_vector)


def depth(atlas: Atlas, loop: Curve) -> float:
    """Return the depth of a loop from front to back, in the loop's unit."""
    return extent(loop, atlas.axes.front_vector)
