"""Landmarks that are put on an atlas or taken off."""

import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint, Unit
from bodymeasure.atlas.queries.locations import points_near
from bodymeasure.errors import InputError
from bodymeasure.wording import hint

# Positions farther from the body than this, in meters, are refused: a picked position lies on a
# mesh of the body, from which the atlas is some millimeters off at the worst, and a position in a
# wrong unit is much farther.
FARTHEST = 0.02


@dataclass(frozen=True)
class Pick:
    """A landmark that is to be put on an atlas.

    Parameters
    ----------
    name : str
    point : AtlasPoint
    distance : float
        Distance of the given position from the atlas, in its unit; 0 for a point of a patch.
    """

    name: str
    point: AtlasPoint
    distance: float = 0.0


def nearest_picks(
    atlas: Atlas,
    names: Sequence[str],
    positions: Array,
    unit: Unit | str,
    *,
    far: bool = False,
) -> tuple[Pick, ...]:
    """Return the atlas's closest points to positions, as picks.

    Parameters
    ----------
    atlas : Atlas
    names : sequence of str, length k
    positions : ndarray, shape (k, 3)
    unit : Unit or str
        The unit of the positions.
    far : bool
        Whether the positions may be farther than 2 cm from the body.

    Raises
    ------
    InputError
        If a position is not finite, or too far from the body; the message says in which unit it
        would be close.
    """
    unit = Unit.parse(unit)
    allowed = np.inf if far else FARTHEST / atlas.unit.meters
    said = [f"landmark {name!r}" for name in names]
    points, distances = points_near(
        atlas, positions, said, unit=unit, farthest=allowed, remedy=", or give --far"
    )
    return tuple(
        Pick(name, point, float(distance))
        for name, point, distance in zip(names, points, distances, strict=True)
    )


def with_landmarks(atlas: Atlas, picks: Sequence[Pick], *, replacing: bool = False) -> Atlas:
    """Return the atlas with more landmarks.

    Parameters
    ----------
    atlas : Atlas
    picks : sequence of Pick
    replacing : bool
        Whether the picks may replace landmarks of the same name.

    Raises
    ------
    InputError
        If a name is empty or has more than one line, is given twice, or is there already.
    """
    landmarks = dict(atlas.landmarks)
    new: dict[str, AtlasPoint] = {}
    for pick in picks:
        _check_name(pick.name)
        if pick.name in new:
            raise InputError(f"landmark {pick.name!r} is given twice; expected it once")
        if pick.name in landmarks and not replacing:
            raise InputError(
                f"the atlas has a landmark {pick.name!r} already; give --replace to move it, or "
                "another name"
            )
        new[pick.name] = pick.point
    return replace(atlas, landmarks={**landmarks, **new})


def without_landmarks(atlas: Atlas, names: Sequence[str]) -> Atlas:
    """Return the atlas without some of its landmarks.

    Raises
    ------
    InputError
        If it has no landmark of one of the names.
    """
    landmarks: Mapping[str, AtlasPoint] = atlas.landmarks
    for name in names:
        if name not in landmarks:
            known = hint(name, sorted(landmarks), expected="it has")
            raise InputError(f"the atlas has no landmark {name!r}; {known}")
    return replace(
        atlas, landmarks={name: point for name, point in landmarks.items() if name not in names}
    )


def _check_name(name: str) -> None:
    bad = any(unicodedata.category(sign) in ("Cc", "Cs") for sign in name)
    if bad or not name.strip() or name != name.strip():
        raise InputError(
            f"a landmark is to be named {name!r}; expected a name on one line, without spaces at "
            "its ends"
        )
