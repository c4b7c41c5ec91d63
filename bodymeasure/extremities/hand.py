"""The measurements of a hand."""

from collections.abc import Sequence

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.extremities.places import HANDS, places
from bodymeasure.extremities.surface import Length, Patchwork, breadth, farthest, girth, patchworks
from bodymeasure.subdivision import QuadMesh

# Where the palm may be the widest, as parts of its length from the wrist: at the knuckles.
KNUCKLES = np.linspace(0.6, 0.95, 8)


def hand_lengths(whole: QuadMesh, limit: Array, side: str) -> dict[str, Length]:
    """Return the lengths of a hand, by the keys of the default set without their side.

    Parameters
    ----------
    whole : QuadMesh
    limit : ndarray, shape (13380, 3)
        The limits of its vertices.
    side : {"left", "right"}

    Notes
    -----
    Fingers are bent a little as a rule. The hand's length is that of the line through the middles
    of the rings of vertices round the middle finger, and of the straight line from the middle of
    the wrist to the finger's root, as if the hand were stretched out.
    """
    number = list(HANDS).index(side)
    steps = patchworks(whole, np.isin(places().region, HANDS[side]))
    wrist = limit[places().wrist[number]].mean(axis=0)
    rings = limit[places().finger[number]]
    middles = rings.mean(axis=1)
    palm = float(np.linalg.norm(middles[0] - wrist))
    finger = float(np.linalg.norm(np.diff(middles, axis=0), axis=1).sum())
    tip = _beyond(steps, rings[-1], middles[-1] - middles[-3])
    along = (middles[0] - wrist) / palm
    places_along = wrist + KNUCKLES[:, None] * palm * along
    girths = [girth(steps, place, along) for place in places_along]
    widest = int(np.argmax([each.value for each in girths]))
    return {
        "hand_length": Length(palm + finger + tip.value, tip.error),
        "palm_length": Length(palm, 0.0),
        "hand_breadth": breadth(steps, places_along[widest], along),
        "hand_girth": girths[widest],
    }


def _beyond(steps: Sequence[Patchwork], ring: Array, pointing: Array) -> Length:
    """Return how far a fingertip reaches beyond the last ring of vertices round the finger."""
    middle = ring.mean(axis=0)
    direction = pointing / np.linalg.norm(pointing)
    # The other fingertips are farther away than the width of a finger.
    width = 2.0 * float(np.linalg.norm(ring - middle, axis=1).max())

    def reach(points: Array) -> Array:
        near = np.linalg.norm(points - middle, axis=1) < width
        return np.where(near, (points - middle) @ direction, -np.inf)

    return farthest(steps, reach)[1]
