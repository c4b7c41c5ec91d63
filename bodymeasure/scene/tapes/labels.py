"""Numbers in the margins beside a body, and the points of its tapes that they belong to."""

from collections.abc import Mapping, Sequence

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.scene.drawing.visibility import Sight
from bodymeasure.scene.model import TapeLine
from bodymeasure.scene.tapes.camera import marking_ends
from bodymeasure.scene.tapes.label_layout import Columns, Layout, place_labels

# A leader should end where its tape is this far from others, as a fraction of the picture's height;
# a larger distance is no better.
CLEAR = 0.02
# A leader may be this many pixels longer if it ends one pixel farther from other tapes.
CLEARANCE_WORTH = 3.0


def numbered(
    lines: Sequence[TapeLine],
    labeled: Sequence[int],
    sight: Sight,
    size: tuple[int, int],
    columns: Columns,
) -> tuple[list[int], Layout]:
    """Place the numbers of some measurements beside a picture.

    Parameters
    ----------
    lines : sequence of TapeLine
        All tapes that are drawn.
    labeled : sequence of int
        Numbers that are to be placed.
    sight : Sight
        What is seen from the picture's side.
    size : tuple of int
        Width and height of the picture in pixels.
    columns : Columns

    Returns
    -------
    numbers : list of int
        Those of the numbers whose tapes are seen.
    layout : Layout
        Where they stand.
    """
    points = _seen_points(lines, sight, size)
    left, right, found = [], [], []
    for number in labeled:
        own = points.get(number)
        if own is None:
            continue
        others = [places for other, places in points.items() if other != number]
        clear = _clearance(own, np.concatenate(others) if others else own[:0], CLEAR * size[1])
        left.append(own[np.argmin(own[:, 0] - CLEARANCE_WORTH * clear)])
        right.append(own[np.argmax(own[:, 0] + CLEARANCE_WORTH * clear)])
        found.append(number)
    ends = np.array([left, right]).reshape(2, -1, 2)
    # The clearest point from the left may lie to the right of that from the right.
    swap = ends[0, :, 0] > ends[1, :, 0]
    ends[:, swap] = ends[::-1, swap]
    return found, place_labels(ends[0], ends[1], columns)


def _seen_points(
    lines: Sequence[TapeLine], sight: Sight, size: tuple[int, int]
) -> Mapping[int, Array]:
    """The points, (k, 2) in pixels, at which a leader to each measurement may end, by number."""
    found: dict[int, Array] = {}
    for line in lines:
        pixels, _ = sight.view.project(line.points, size)
        if line.through_body:
            pixels = pixels[marking_ends(pixels, size[1])]
        else:
            pixels = pixels[sight.seen(line.points, line.normals)]
        # A measurement's first tape that is seen counts: contact tapes come before taut ones.
        if len(pixels) and line.number not in found:
            found[line.number] = pixels
    return found


def _clearance(points: Array, others: Array, most: float) -> Array:
    """Distance of points (k, 2) from the nearest of others (m, 2), at most `most`, shape (k,)."""
    if len(others) == 0:
        return np.full(len(points), most)
    distance, _ = scipy.spatial.cKDTree(others).query(points)
    return np.asarray(np.minimum(distance, most))
