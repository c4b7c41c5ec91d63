"""Places on a body, by landmark, point of the atlas or position."""

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.errors import InputError
from bodymeasure.wording import hint

Place = str | AtlasPoint | NDArray[np.float64]
"""A landmark's name, a point of the atlas, or a position of shape (3,) in the atlas's unit."""


def position_of(atlas: Atlas, place: Place) -> NDArray[np.float64]:
    """Position of a place, shape (3,).

    Raises
    ------
    InputError
        If the atlas has no such landmark, or the position is not three finite numbers.
    """
    if isinstance(place, AtlasPoint):
        return atlas.position(place)
    if isinstance(place, str):
        return atlas.position(landmark_of(atlas, place))
    position = np.asarray(place, dtype=np.float64)
    if position.shape != (3,) or not np.isfinite(position).all():
        raise InputError(f"the position is {place!r}; expected three finite numbers")
    return position


def landmark_of(atlas: Atlas, name: str) -> AtlasPoint:
    """The landmark of that name.

    Raises
    ------
    InputError
        If there is none; the nearest name is suggested.
    """
    if name not in atlas.landmarks:
        raise InputError(_unknown(atlas, name))
    return atlas.landmarks[name]


def _unknown(atlas: Atlas, name: str) -> str:
    if not atlas.landmarks:
        return f"the atlas has no landmark {name!r}, nor any other; add it, or give a position"
    meant = hint(name, sorted(atlas.landmarks), expected="it has")
    return f"the atlas has no landmark {name!r}; {meant}"
