"""From where tapes are looked at."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Axes
from bodymeasure.scene.camera import View, framed
from bodymeasure.scene.drawing.visibility import Sight, sight
from bodymeasure.scene.model import Surface, TapeLine, TapeScene

# Close-ups are taken from all around, from so far above or below the horizontal (the sine of the
# angle): a girth is then seen as a ring, not as a line.
AZIMUTHS = 8
RISES = (0.28, -0.28)
# Of two sides that see nearly as much of a tape, the first in order is taken: the other needs so
# much more.
WORTH = 1.08
# A straight tape runs through the body, and is drawn over it: it counts by its ends.
HIDDEN_END = 0.7
# Ends that differ in height by less than this fraction of the picture's are level.
LEVEL = 0.02
# A close-up frames its tape with so much room around it, as parts of the picture.
FILL_WIDTH = 0.54
FILL_HEIGHT = 0.72
# It shows at least so much of the body, as a fraction of its size.
LEAST_SHOWN = 0.2


def closeup_directions(axes: Axes) -> list[NDArray[np.float64]]:
    """Unit vectors towards the viewers of close-ups, the front ones first."""
    turns = [0, 4, 1, -1, 2, -2, 3, -3]
    found = []
    for rise in RISES:
        for turn in turns:
            angle = 2.0 * np.pi * turn / AZIMUTHS
            level = np.cos(angle) * axes.front_vector + np.sin(angle) * axes.left_vector
            found.append(np.sqrt(1.0 - rise**2) * level + rise * axes.up_vector)
    return found


def view_along(
    surface: Surface, towards: NDArray[np.float64], up: NDArray[np.float64], margin: float
) -> View:
    """A view of a whole surface."""
    upward = up - (up @ towards) * towards
    upward /= np.linalg.norm(upward)
    return framed(surface.points, towards, upward, margin)


def seen_length(line: TapeLine, view: Sight) -> float:
    """How much of a tape is seen from a side, by its length in the picture, in the atlas's unit."""
    places, _ = view.view.project(line.points, view.size)
    step = np.linalg.norm(np.diff(places, axis=0), axis=1) * view.view.height / view.size[1]
    seen = view.seen(line.points, line.normals)
    if line.through_body:
        ends = seen[marking_ends(places, view.size[1])].mean()
        return float(step.sum() * (HIDDEN_END + (1.0 - HIDDEN_END) * ends))
    return float(step[seen[:-1] & seen[1:]].sum())


def measurement_seen(scene: TapeScene, key: str, view: Sight) -> float:
    """How much of a measurement is seen from a side: of that of its tapes that is seen best."""
    return max(seen_length(line, view) for line in scene.tapes if line.key == key)


def marking_ends(places: NDArray[np.float64], height: int) -> NDArray[np.int64]:
    """Which ends of a straight tape in a picture tell where it is measured.

    The upper one, if one is above the other: a height is known by it.

    Parameters
    ----------
    places : ndarray, shape (k, 2)
        In pixels from the top left.
    height : int
        Of the picture.
    """
    ends = np.array([0, len(places) - 1])
    y = places[ends, 1]
    return np.asarray(ends[y <= y.min() + LEVEL * height])


def best(seen: Sequence[float]) -> int:
    """Which of some sides sees most; the first of those that see nearly as much."""
    chosen = 0
    for number, length in enumerate(seen):
        if length > WORTH * seen[chosen]:
            chosen = number
    return chosen


def closeup_view(
    scene: TapeScene, points: NDArray[np.float64], sight_along: Sight, aspect: float
) -> View:
    """The view of some points, shape (k, 3), from a side, in a picture of that width to height."""
    tight = framed(points, sight_along.view.towards, sight_along.view.up, 0.0)
    height = max(
        tight.height / FILL_HEIGHT, tight.width / FILL_WIDTH / aspect, LEAST_SHOWN * scene.size
    )
    return replace(tight, width=aspect * height, height=height)


def sights(surface: Surface, axes: Axes, margin: float) -> list[Sight]:
    """What is seen of a surface from each of `closeup_directions`."""
    return [
        sight(surface, view_along(surface, towards, axes.up_vector, margin))
        for towards in closeup_directions(axes)
    ]
