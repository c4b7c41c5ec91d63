"""The posture of a body in its coordinates, by its landmarks and those of an average body."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas

# Meters to the wearer's left, to the front and up from the floor, on the mean of the five sample
# bodies. Only what does not move with the arms serves.
TRUNK = {
    "back neck point": (0.0, -0.018, 1.392),
    "front neck point": (0.0, 0.084, 1.328),
    "side neck point left": (0.056, 0.036, 1.387),
    "shoulder point left": (0.173, -0.005, 1.336),
    "armpit point left": (0.160, 0.022, 1.231),
    "bust point left": (0.106, 0.168, 1.169),
    "underbust point left": (0.086, 0.129, 1.134),
    "front waist point": (0.0, 0.151, 0.995),
    "back waist point": (0.0, -0.035, 0.988),
    "side waist point left": (0.132, 0.028, 1.003),
    "front hip point": (0.0, 0.110, 0.806),
    "back hip point": (0.0, -0.080, 0.836),
    "side hip point left": (0.172, 0.034, 0.834),
    "crotch point": (0.0, 0.061, 0.765),
}
# Legs bend, so that they serve only where the trunk has too few landmarks.
LEGS = {
    "patella point left": (0.144, 0.101, 0.481),
    "ankle point left": (0.176, 0.055, 0.127),
}
STATURE = 1.68
# Three places are the fewest that show a posture.
_FEWEST = 3
# Parts of the largest singular value: with a smaller second one the landmarks lie on a line, about
# which they may be turned; with a smaller third one in a plane, which looks like its mirror image.
_ON_A_LINE = 0.02
_IN_A_PLANE = 0.005
# Part of the correlation that a mirror image has to gain. Bodies differ from the average by less.
_GAIN = 0.02


class Posture(NamedTuple):
    """The posture of a body.

    Parameters
    ----------
    directions : ndarray, shape (3, 3)
        Unit vectors to the wearer's left, to the front and up, in the atlas's coordinates, which
        the landmarks show.
    mirrored : bool
        Whether the landmarks are those of a body's mirror image.
    stature : float
        Height that a body with such landmarks has, in the atlas's unit.
    """

    directions: Array
    mirrored: bool
    stature: float


def _both_sides(places: Mapping[str, tuple[float, float, float]]) -> dict[str, Array]:
    both = {}
    for name, (left, front, up) in places.items():
        both[name] = np.array([left, front, up])
        if name.endswith(" left"):
            both[name.removesuffix("left") + "right"] = np.array([-left, front, up])
    return both


_TRUNK, _LEGS = _both_sides(TRUNK), _both_sides(LEGS)


def posture(atlas: Atlas) -> Posture | None:
    """Return how a body stands; None if too few of its landmarks are known.

    Notes
    -----
    The average body's landmarks are turned and scaled to fit the body's best in the sense of least
    squares: orthogonal Procrustes analysis (Schoenemann, Psychometrika 31, 1966).
    """
    return _fitted(atlas, _TRUNK) or _fitted(atlas, _TRUNK | _LEGS)


def _fitted(atlas: Atlas, places: Mapping[str, Array]) -> Posture | None:
    names = [name for name in atlas.landmarks if name in places]
    if len(names) < _FEWEST:
        return None
    # To the right, to the front and up are right-handed, as the atlas's coordinates are.
    average = np.stack([places[name] for name in names]) * [-1.0, 1.0, 1.0]
    found = np.stack([atlas.position(atlas.landmarks[name]) for name in names])
    average, found = average - average.mean(axis=0), found - found.mean(axis=0)
    size = np.linalg.norm(average), np.linalg.norm(found)
    if not size[1] > 0.0:
        return None
    before, shared, after = np.linalg.svd((average / size[0]).T @ (found / size[1]))
    if shared[1] < _ON_A_LINE * shared[0]:
        return None
    hand = float(np.linalg.det(before) * np.linalg.det(after))
    mirrored = hand < 0.0 and shared[2] > max(_IN_A_PLANE * shared[0], _GAIN / 2.0)
    last = 1.0 if mirrored else hand
    right, front, up = before @ np.diag([1.0, 1.0, last]) @ after
    return Posture(np.stack([-right, front, up]), mirrored, float(STATURE * size[1] / size[0]))
