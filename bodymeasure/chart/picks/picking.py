"""Putting landmarks on an atlas, and taking them off."""

import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Atlas, AtlasPoint, Unit
from bodymeasure.atlas.queries.locations import points_near
from bodymeasure.errors import InputError
from bodymeasure.wording import hint

# In metres: positions farther from the body are refused. A picked position lies on a mesh of the
# body, whose atlas is some millimeters off at the worst; one in a wrong unit is much farther.
FARTHEST = 0.02


@dataclass(frozen=True)
class Pick:
    """A landmark that is to be put on an atlas.

    Parameters
    ----------
    name : str
    point : AtlasPoint
    distance : float
        Of the position that was given from the atlas, in the atlas's unit; 0 for a patch's point.
    """

    name: str
    point: AtlasPoint
    distance: float = 0.0


def nearest_picks(
    atlas: Atlas,
    names: Sequence[str],
    positions: NDArray[np.float64],
    unit: Unit | str,
    *,
    far: bool = False,
) -> tuple[Pick, ...]:
    """The atlas's closest points to positions.

    Parameters
    ----------
    atlas : Atlas
    names : sequence of str, length k
    positions : ndarray, shape (k, 3)
    unit : Unit or str
        Of the positions.
    far : bool
        Whether they may be farther than 2 cm from the body.

    Raises
    ------
    InputError
        If one is not finite, or too far from the body; the message says in which unit it would not
        be.
    """
    unit = Unit.parse(unit)
    allowed = np.inf if far else FARTHEST / atlas.unit.metres
    said = [f"landmark {name!r}" for name in names]
    points, distances = points_near(
        atlas, positions, said, unit=unit, farthest=allowed, remedy=", or give --far"
    )
    return tuple(
        Pick(name, point, float(distance))
        for name, point, distance in zip(names, points, distances, strict=True)
    )


def with_landmarks(atlas: Atlas, picks: Sequence[Pick], *, replacing: bool = False) -> Atlas:
    """The atlas with more landmarks.

    Parameters
    ----------
    atlas : Atlas
    picks : sequence of Pick
    replacing : bool
        Whether they may take the place of landmarks that are there.

    Raises
    ------
    InputError
        If a name is no name, is given twice, or is there already.
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
    """The atlas without some of its landmarks.

    Raises
    ------
    InputError
        If it has none of that name.
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
