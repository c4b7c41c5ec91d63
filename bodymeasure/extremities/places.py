"""Where head, hands and feet are on the quad mesh of bodies."""

from dataclasses import dataclass
from enum import IntEnum
from functools import cache
from pathlib import Path

import numpy as np

from bodymeasure._typing import Ints

_FILE = Path(__file__).parent / "data" / "places.npz"


class Region(IntEnum):
    """The part of the body to which a vertex belongs, where the layout of patches has none."""

    ELSEWHERE = 0
    FACE = 1
    SKULL = 2
    EAR = 3
    LEFT_HAND = 4
    LEFT_THUMB = 5
    RIGHT_HAND = 6
    RIGHT_THUMB = 7
    LEFT_FOOT = 8
    RIGHT_FOOT = 9


HEAD = (Region.FACE, Region.SKULL)
HANDS = {"left": (Region.LEFT_HAND,), "right": (Region.RIGHT_HAND,)}
FEET = {"left": (Region.LEFT_FOOT,), "right": (Region.RIGHT_FOOT,)}
# The brow between the eyebrows and the bottom of the chin, in the median plane.
GLABELLA = 227
CHIN = 5225


@dataclass(frozen=True, eq=False)
class Places:
    """Vertices of the mesh, the same on every body.

    Parameters
    ----------
    region : ndarray of int, shape (13380,)
        The region of each vertex.
    finger : ndarray of int, shape (2, 16, 14)
        Rings of vertices round the middle finger of the left and the right hand, from its root.
    wrist : ndarray of int, shape (2, 20)
        The ring of vertices at the crease of the left and the right wrist.
    landmarks : dict of str to (int, int)
        Vertices on the left and on the right.
    """

    region: Ints
    finger: Ints
    wrist: Ints
    landmarks: dict[str, tuple[int, int]]


@cache
def places() -> Places:
    """Return the places of the mesh's vertices."""
    with np.load(_FILE) as data:
        pairs = data["vertices"].astype(np.int64).tolist()
        return Places(
            data["region"].astype(np.int64),
            data["finger"].astype(np.int64),
            data["wrist"].astype(np.int64),
            {
                name: (left, right)
                for name, (left, right) in zip(data["names"].tolist(), pairs, strict=True)
            },
        )
