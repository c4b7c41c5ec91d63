"""Numbers in the margins beside a body, and which of its tapes they are led to."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from bodymeasure.scene.drawing.visibility import Sight
from bodymeasure.scene.model import TapeLine
from bodymeasure.scene.tapes.camera import marking_ends
from bodymeasure.scene.tapes.label_layout import Columns, Layout, place_labels

# A leader ends where its tape is this clear of others, as a fraction of the picture's height; more
# is not better.
CLEAR = 0.02
# What a pixel of clearance is worth in pixels of a longer leader.
CLEARANCE_WORTH = 3.0


@dataclass(frozen=True, eq=False)
class Numbered:
    """Labels of a picture of tapes.

    Parameters
    ----------
    numbers : tuple of int
    layout : Layout
    columns : Columns
    """

    numbers: tuple[int, ...]
    layout: Layout
    columns: Columns


def numbered(
    lines: Sequence[TapeLine],
    labeled: Sequence[int],
    sight: Sight,
    size: tuple[int, int],
    columns: Columns,
) -> Numbered:
    """Place the numbers of some measurements beside a picture.

    Parameters
    ----------
    lines : sequence of TapeLine
        All that are drawn.
    labeled : sequence of int
        Numbers that are to be placed.
    sight : Sight
        From the picture's side.
    size : tuple of int
        Of the picture, in pixels.
    columns : Columns
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
    return Numbered(tuple(found), place_labels(ends[0], ends[1], columns), columns)


def _seen_points(
    lines: Sequence[TapeLine], sight: Sight, size: tuple[int, int]
) -> Mapping[int, NDArray[np.float64]]:
    """Where a leader to each measurement may end, by number, in pixels (k, 2)."""
    found: dict[int, NDArray[np.float64]] = {}
    for line in lines:
        pixels, _ = sight.view.project(line.points, size)
        if line.through_body:
            pixels = pixels[marking_ends(pixels, size[1])]
        else:
            pixels = pixels[sight.seen(line.points, line.normals)]
        # The first that is seen at all: contact tapes come before taut ones.
        if len(pixels) and line.number not in found:
            found[line.number] = pixels
    return found


def _clearance(
    points: NDArray[np.float64], others: NDArray[np.float64], most: float
) -> NDArray[np.float64]:
    """Distance of points (k, 2) from the nearest of others (m, 2), at most so much, shape (k,)."""
    if len(others) == 0:
        return np.full(len(points), most)
    distance, _ = scipy.spatial.cKDTree(others).query(points)
    return np.asarray(np.minimum(distance, most))
