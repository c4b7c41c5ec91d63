"""The stature of a body of the space, and how each component changes it."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.extremities.places import Region, places
from bodymeasure.extremities.surface import STEPS, Patchwork, closer_to, patchworks
from bodymeasure.fit.model import body_model, limit_matrix, shaped
from bodymeasure.make.body.atlases import COUNT
from bodymeasure.subdivision import QuadMesh

# In meters: the top is looked for that far below the highest limit of a vertex of the skull.
CAP = 0.02


class _Top(NamedTuple):
    """The way to the highest point: what is kept of the mesh, and which vertex it is at the end."""

    cap: bytes
    best: int
    highest: int


def stature_of(coefficients: Array) -> tuple[float, Array]:
    """Return the stature of a body, in meters, and its derivative by each coefficient, (120,).

    The stature is that of `bodymeasure.extremities.extremity_lengths`; its derivative is the
    movement of the highest point upwards.
    """
    vertices = shaped(coefficients)
    height = np.asarray(limit_matrix() @ vertices[:, 2])
    skull = places().region == Region.SKULL
    cap = skull & (height > height[skull].max() - CAP)
    finest = _subdivided(vertices, cap)
    best, _ = finest.farthest(_height)
    closer = closer_to(finest, best)
    highest, stature = closer.farthest(_height)
    slopes = _slopes(_Top(np.packbits(cap).tobytes(), best, highest))
    return stature, slopes


def _height(points: Array) -> Array:
    return points[:, 2]


def _subdivided(vertices: Array, cap: Bools) -> Patchwork:
    return patchworks(QuadMesh(vertices, body_model().quads), cap)[STEPS]


@lru_cache(maxsize=16)
def _slopes(top: _Top) -> Array:
    """Return how each component moves a point of the limit surface upwards.

    Subdivision is linear, so that components are subdivided as bodies are, three at a time in place
    of the coordinates.
    """
    cap = np.unpackbits(np.frombuffer(top.cap, dtype=np.uint8))[: len(places().region)] > 0
    rises = body_model().components[:, :, 2]
    found = []
    for first in range(0, COUNT, 3):
        finest = _subdivided(np.ascontiguousarray(rises[first : first + 3].T), cap)
        found.append(closer_to(finest, top.best).limit[top.highest])
    return np.concatenate(found)
