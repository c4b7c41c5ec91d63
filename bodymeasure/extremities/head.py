"""Stature, and the measurements of the head."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.extremities.places import CHIN, GLABELLA, HEAD, Region, places
from bodymeasure.extremities.surface import Length, Patchwork, farthest, girth, patchworks
from bodymeasure.subdivision import QuadMesh


def head_lengths(whole: QuadMesh, limit: Array, up: Array) -> dict[str, Length]:
    """Return stature and the lengths of the head, by the keys of the default set.

    Parameters
    ----------
    whole : QuadMesh
    limit : ndarray, shape (13380, 3)
        The limits of its vertices.
    up : ndarray, shape (3,)
        The way up; the floor is where the coordinate along it is 0.

    Notes
    -----
    The head's own median plane is square to the line through both ears, so that a turned or tilted
    head has the same girth, length and breadth.
    """
    region = places().region
    skull = patchworks(whole, region == Region.SKULL)
    head = patchworks(whole, np.isin(region, HEAD))
    _, top = farthest(skull, lambda points: points @ up)
    brow = limit[GLABELLA]
    back, length = farthest(skull, lambda points: np.linalg.norm(points - brow, axis=1))
    across = _across(limit)
    normal = np.cross(back - brow, across)
    return {
        "stature": top,
        "head_girth": girth(head, brow, normal / np.linalg.norm(normal)),
        "head_length": length,
        "head_breadth": _extent(skull, across),
        "head_height": Length(top.value - float(limit[CHIN] @ up), top.error),
    }


def _across(limit: Array) -> Array:
    left, right = limit[list(places().landmarks["ear"])]
    return np.asarray((left - right) / np.linalg.norm(left - right))


def _extent(steps: tuple[Patchwork, ...], direction: Array) -> Length:
    _, high = farthest(steps, lambda points: points @ direction)
    _, low = farthest(steps, lambda points: -points @ direction)
    return Length(high.value + low.value, high.error + low.error)
