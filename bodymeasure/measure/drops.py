"""Drops: lengths along the surface in a vertical plane, from a place to the level of another."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Atlas, Unit
from bodymeasure.errors import InputError
from bodymeasure.measure.places import Place, position_of
from bodymeasure.section import (
    DrawnTape,
    Plane,
    PlaneSection,
    SectionLoop,
    drawn,
    nearest_place,
    outer_hull,
    part,
    plane_section,
    sign_changes,
    signed_area,
    turned,
)
from bodymeasure.section.hull import Hull

_Array = NDArray[np.float64]

# Of the difference of heights: a way down that rises by more first leads over something, such as
# the head; one that rises by less only starts on a slope, such as a shoulder's.
RISE = 0.1


@dataclass(frozen=True, eq=False)
class Drop:
    """A length in a vertical plane, from a place to a level.

    Parameters
    ----------
    contact : float
        Length of the section from the place to the level: a tape that follows the skin. In `unit`.
    taut : float
        The shortest way outside the body between the same two points, in the plane. Never above
        `contact`.
    error_estimate : float
        Of either.
    arc : SectionLoop
        The part of the section, from its start.
    hull : Hull
        Where the taut tape leaves it.
    unit : Unit
    """

    contact: float
    taut: float
    error_estimate: float
    arc: SectionLoop
    hull: Hull
    unit: Unit

    @property
    def gap(self) -> float:
        """By how much the taut tape is shorter than the one that follows the skin."""
        return self.contact - self.taut

    @property
    def contact_tape(self) -> DrawnTape:
        """The tape that follows the skin, to be drawn."""
        return drawn(self.arc)

    @property
    def taut_tape(self) -> DrawnTape:
        """The tape drawn taut, to be drawn."""
        return drawn(self.arc, self.hull.spans)


class _Way(NamedTuple):
    """A way from the start to the level.

    Parameters
    ----------
    arc : SectionLoop
    turn : float
        Positive if the body lies to its left in the plane's frame.
    end : ndarray, shape (3,)
    """

    arc: SectionLoop
    turn: float
    end: _Array


def drop(
    atlas: Atlas, start: Place, level: Place, *, plane: Literal["median", "side"] = "median"
) -> Drop:
    """Length along the surface in a vertical plane, from a place to the height of another one.

    Parameters
    ----------
    atlas : Atlas
    start : str, AtlasPoint or ndarray of shape (3,)
        Where the tape starts; a position off the surface stands for the nearest point of the
        section.
    level : str, AtlasPoint or ndarray of shape (3,)
        At whose height it ends. Where two ways lead there directly, as from the side of the neck
        to the front and to the back, the one that ends nearer to this place is meant.
    plane : {"median", "side"}
        Whether the plane through the start runs from front to back or from left to right.

    Raises
    ------
    InputError
        If no way leads from the start directly to the level, both have one height, the section is
        not clean, or the surface winds about an end of the tape.
    """
    first, last, up = position_of(atlas, start), position_of(atlas, level), atlas.axes.up_vector
    if plane not in ("median", "side"):
        raise InputError(f"plane is {plane!r}; expected 'median' or 'side'")
    rise = float((last - first) @ up)
    if rise == 0.0:
        raise InputError(
            "the tape's start and its level have one height, so there is nothing between them; "
            "expected two heights"
        )
    normal = atlas.axes.left_vector if plane == "median" else atlas.axes.front_vector
    section = plane_section(atlas, Plane(first, normal))
    way = _direct_way(section, first, last, np.sign(rise) * up, "up" if rise > 0.0 else "down")
    hull = outer_hull(way.arc, way.turn)
    return Drop(way.arc.length, hull.length, hull.error_estimate, way.arc, hull, atlas.unit)


def _direct_way(
    section: PlaneSection, first: _Array, last: _Array, forth: _Array, word: str
) -> _Way:
    """The way from the first point in a direction to the height of the last."""
    loop = section.nearest(first)
    far = float((last - first) @ forth)
    ways: list[_Way] = []
    roundabout = False
    for curve in (loop, turned(loop)):
        begin = nearest_place(curve, first)
        arc = part(curve, begin, begin + curve.count if curve.closed else float(curve.count))
        reached = sign_changes(arc, lambda x: (x - last) @ forth)
        if not len(reached):
            continue
        way = part(arc, 0.0, float(reached[0]))
        roundabout = True
        if ((way.positions - first) @ forth).min() >= -RISE * far:
            flat = curve.positions @ curve.plane.frame().T
            ways.append(_Way(way, signed_area(flat), arc.positions_at(reached[:1])[0]))
    if not ways:
        why = (
            "only by going the other way first"
            if roundabout
            else "nowhere: it ends on the boundary of the atlas, or turns back before"
        )
        raise InputError(
            f"along the section by {section.plane} the tape reaches the level, {far:.4g} {word} "
            f"from its start, {why}; choose a start or a level on the part of the body that is to "
            "be measured, or the other plane"
        )
    return min(ways, key=lambda way: float(np.linalg.norm(way.end - last)))
