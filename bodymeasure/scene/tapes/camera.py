"""The sides from which tapes are looked at."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Axes
from bodymeasure.scene.camera import View, framed
from bodymeasure.scene.drawing.visibility import Sight, sight
from bodymeasure.scene.model import Surface, TapeLine, TapeScene

# Close-ups are taken from all around, from so far above or below the horizontal (the sine of the
# angle): a girth is then seen as a ring, not as a line.
AZIMUTHS = 8
RISES = (0.28, -0.28)
# A later side is preferred to an earlier one only if it sees more of a tape by this factor.
WORTH = 1.08
# A straight tape runs through the body, and is drawn over it: only its ends may be hidden, and
# they count for the rest of its length.
HIDDEN_END = 0.7
# Ends that differ in height by less than this fraction of the picture's are level.
LEVEL = 0.02
# The most of a close-up's width and height that its tape fills.
FILL_WIDTH = 0.54
FILL_HEIGHT = 0.72
# The least height that a close-up shows, as a fraction of the body's size.
LEAST_SHOWN = 0.2


def closeup_directions(axes: Axes) -> list[Array]:
    """List unit vectors towards the viewers of close-ups, the front ones first."""
    turns = [0, 4, 1, -1, 2, -2, 3, -3]
    found = []
    for rise in RISES:
        for turn in turns:
            angle = 2.0 * np.pi * turn / AZIMUTHS
            level = np.cos(angle) * axes.front_vector + np.sin(angle) * axes.left_vector
            found.append(np.sqrt(1.0 - rise**2) * level + rise * axes.up_vector)
    return found


def view_along(surface: Surface, towards: Array, up: Array, margin: float) -> View:
    """Return the view of a whole surface from a direction."""
    upward = up - (up @ towards) * towards
    upward /= np.linalg.norm(upward)
    return framed(surface.points, towards, upward, margin)


def sights(surface: Surface, axes: Axes, margin: float) -> list[Sight]:
    """Find what is seen of a surface from each of `closeup_directions`."""
    return [
        sight(surface, view_along(surface, towards, axes.up_vector, margin))
        for towards in closeup_directions(axes)
    ]


def seen_lengths(lines: Sequence[TapeLine], side: Sight) -> list[float]:
    """Return the length of each tape in the picture that is seen from a side.

    The lengths are in the atlas's unit.
    """
    if not lines:
        return []
    points = np.concatenate([line.points for line in lines])
    seen = side.seen(points, np.concatenate([line.normals for line in lines]))
    places, _ = side.view.project(points, side.size)
    scale = side.view.height / side.size[1]
    ends = np.cumsum([len(line.points) for line in lines])[:-1]
    lengths = []
    for line, path, shown in zip(lines, np.split(places, ends), np.split(seen, ends), strict=True):
        step = scale * np.linalg.norm(np.diff(path, axis=0), axis=1)
        if line.through_body:
            share = shown[marking_ends(path, side.size[1])].mean()
            lengths.append(float(step.sum() * (HIDDEN_END + (1.0 - HIDDEN_END) * share)))
        else:
            lengths.append(float(step[shown[:-1] & shown[1:]].sum()))
    return lengths


def measurements_seen(scene: TapeScene, side: Sight) -> dict[str, float]:
    """Return the seen length of each measurement: the longest of those of its tapes."""
    found: dict[str, float] = {}
    for line, length in zip(scene.tapes, seen_lengths(scene.tapes, side), strict=True):
        found[line.key] = max(length, found.get(line.key, 0.0))
    return found


def best_sides(scene: TapeScene, around: Sequence[Sight]) -> Mapping[str, Sight]:
    """Choose the side that sees most of each measurement with a tape."""
    seen = [measurements_seen(scene, side) for side in around]
    return {key: around[best([by_key[key] for by_key in seen])] for key in seen[0]}


def best(seen: Sequence[float]) -> int:
    """Choose the side that sees most, or the first of those that see nearly as much."""
    chosen = 0
    for number, length in enumerate(seen):
        if length > WORTH * seen[chosen]:
            chosen = number
    return chosen


def marking_ends(places: Array, height: int) -> Ints:
    """Return the ends of a straight tape in a picture that mark where it is measured.

    If one end is above the other, it is the upper one: it marks a height.

    Parameters
    ----------
    places : ndarray, shape (k, 2)
        In pixels from the top left.
    height : int
        Height of the picture in pixels.
    """
    ends = np.array([0, len(places) - 1])
    y = places[ends, 1]
    return np.asarray(ends[y <= y.min() + LEVEL * height])


def closeup_view(scene: TapeScene, points: Array, side: Sight, aspect: float) -> View:
    """Return the view of points, shape (k, 3), from a side, with a ratio of width to height."""
    tight = framed(points, side.view.towards, side.view.up, 0.0)
    height = max(
        tight.height / FILL_HEIGHT, tight.width / FILL_WIDTH / aspect, LEAST_SHOWN * scene.size
    )
    return replace(tight, width=aspect * height, height=height)
