"""Ease: by how much a garment is wider than the body, at some levels and between them."""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.errors import InputError
from bodymeasure.wording import hint

# Short names of levels, and the landmarks at whose heights they are.
LEVELS = {
    "neck": "side neck point left",
    "bust": "bust point left",
    "waist": "front waist point",
    "hip": "side hip point left",
}
# The level of the bust by all of its names: the ease there fades out up to the neck.
BUST = frozenset({"bust", "bust point left", "bust point right"})
# In meters: levels nearer to one another than this cannot have different eases.
NEAREST = 0.01
# In meters: the least and the most ease of a girth. Cloth that stretches may be narrower than the
# body; and a wider garment is no offset of the skin.
NARROWEST, WIDEST = -0.2, 0.3


@dataclass(frozen=True, eq=False)
class Ease:
    """The ease of girths by the height along an axis.

    Parameters
    ----------
    axis : ndarray, shape (3,)
        A unit vector.
    heights : ndarray, shape (n,)
        Of the levels along the axis, growing, in the atlas's unit.
    girths : ndarray, shape (n,)
        By how much a girth is wider there, in the atlas's unit.
    """

    axis: Array
    heights: Array
    girths: Array

    def offsets(self, positions: Array) -> Array:
        """Return the distance of the cloth from the skin at positions (..., 3).

        By Steiner's formula, a closed level curve at a distance d is 2 pi d longer. Between levels
        it changes smoothly, and beyond the outermost ones it stays the same.
        """
        height = positions @ self.axis
        if len(self.heights) == 1:
            return np.full(height.shape, self.girths[0] / (2.0 * np.pi))
        # A level more at both ends, so that the ease ends level and has no kink there.
        low, high = self.heights[[0, -1]]
        span = high - low
        levels = np.concatenate([[low - span], self.heights, [high + span]])
        girths = self.girths[[0, *range(len(self.girths)), -1]]
        between = scipy.interpolate.PchipInterpolator(levels, girths)
        return np.asarray(between(np.clip(height, low, high))) / (2.0 * np.pi)


def landmarks_of(ease: Mapping[str, float]) -> list[str]:
    """Return the landmarks at whose levels there is ease."""
    names = [LEVELS.get(name, name) for name in ease]
    return [*names, LEVELS["neck"]] if BUST & set(ease) else names


def checked_ease(ease: Mapping[str, float], source: str = "ease") -> dict[str, float]:
    """Return eases in meters by the names of their levels.

    Raises
    ------
    InputError
        If one is no length, or too long.
    """
    for name, girth in ease.items():
        is_number = isinstance(girth, (int, float)) and not isinstance(girth, bool)
        if not isinstance(name, str) or not is_number or not NARROWEST <= girth <= WIDEST:
            raise InputError(
                f"{source} at {name!r} is {girth!r}; expected by how much the girth there is "
                f"wider, in meters, from {NARROWEST} to {WIDEST}"
            )
    return {name: float(girth) for name, girth in ease.items()}


def ease_of(
    atlas: Atlas,
    ease: Mapping[str, float],
    landmarks: Mapping[str, AtlasPoint],
    axis: Array | None = None,
) -> Ease | None:
    """Return eases by their levels on a body; None if there are none.

    Parameters
    ----------
    atlas : Atlas
    ease : mapping of str to float
        The ease of girths in meters, by landmarks or the names in `LEVELS`. If the topmost of them
        is the bust, the ease there fades out up to the neck.
    landmarks : mapping of str to AtlasPoint
    axis : ndarray, shape (3,), optional
        Along which levels are ordered; up if not given.

    Raises
    ------
    InputError
        If a landmark is not there, or levels are too near to one another.
    """
    if not any(ease.values()):
        return None
    axis = atlas.axes.up_vector if axis is None else axis
    meters = atlas.unit.meters

    def height(name: str) -> float:
        landmark = LEVELS.get(name, name)
        if landmark not in landmarks:
            known = sorted({*LEVELS, *landmarks})
            raise InputError(
                f"ease is asked for at {name!r}, which is no landmark of the body; "
                f"{hint(name, known)}"
            )
        return float(atlas.position(landmarks[landmark]) @ axis)

    levels = {name: (height(name), girth / meters) for name, girth in ease.items()}
    if max(levels, key=lambda name: levels[name][0]) in BUST:
        levels["neck"] = (height("neck"), 0.0)
    ordered = sorted(levels.items(), key=lambda item: item[1][0])
    for (one, low), (other, high) in pairwise(ordered):
        if high[0] - low[0] < NEAREST / meters:
            raise InputError(
                f"ease is asked for at {one!r} and {other!r}, whose heights differ by less than "
                f"{100.0 * NEAREST:.0f} cm; leave one of them out"
            )
    heights, girths = np.array([level for _, level in ordered]).T
    return Ease(axis, heights, girths)
