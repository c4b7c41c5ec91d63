"""Drops: lengths along the surface in a vertical plane, from a place to the level of another."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Unit
from bodymeasure.atlas.queries.locations import Location, position_of
from bodymeasure.errors import InputError
from bodymeasure.section import (
    DrawnTape,
    Hull,
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
from bodymeasure.threads import one_blas_thread
from bodymeasure.trust import is_known
from bodymeasure.wording import result_line

# A way down that first rises by more than this part of the difference of heights leads over
# something, such as the head; one that rises by less only starts on a slope, such as a shoulder's.
RISE = 0.1
# Places are known well enough to tell their order by this part of the number of pieces.
ORDER = 1e-7
# An open boundary that misses the level by less than this part of the same difference lies at it.
ROUNDING = 1e-12


@dataclass(frozen=True, eq=False)
class Drop:
    """A length along the surface in a vertical plane, from a place to a level.

    Parameters
    ----------
    contact : float
        Length of the section from the place to the level: a tape that follows the skin. In `unit`.
    taut : float
        The shortest way outside the body between the same two points, in the plane. Never above
        `contact`.
    error_estimate : float
        Estimated error of either length, in `unit`.
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

    def __repr__(self) -> str:
        return result_line(
            "Drop", self.unit, self.error_estimate, contact=self.contact, taut=self.taut
        )

    @property
    def converged(self) -> bool:
        """Whether the lengths can be trusted: their error is a small enough part of them."""
        return bool(is_known(self.contact, self.error_estimate, self.contact))

    @property
    def approximation_error(self) -> float:
        """A bound on the difference from the length on the surface that the patches approximate."""
        return self.arc.approximation_error

    @property
    def gap(self) -> float:
        """The length that the taut tape saves over the one that follows the skin."""
        return self.contact - self.taut

    @property
    def contact_tape(self) -> DrawnTape:
        """The tape that follows the skin, to be drawn."""
        return drawn(self.arc)

    @property
    def taut_tape(self) -> DrawnTape:
        """The tape drawn taut, to be drawn."""
        return drawn(self.arc, self.hull.spans)


@one_blas_thread()
def vertical_drop(
    atlas: Atlas, start: Location, level: Location, *, plane: Literal["median", "side"] = "median"
) -> Drop:
    """Return the length along the surface in a vertical plane, from a place to another's height.

    Parameters
    ----------
    atlas : Atlas
    start : str, AtlasPoint or ndarray of shape (3,)
        The start of the tape; a position off the surface stands for the nearest point of the
        section.
    level : str, AtlasPoint or ndarray of shape (3,)
        The place at whose height the tape ends. Where two ways lead there directly, as from the
        side of the neck to the front and to the back, the one that ends nearer to this place is
        meant.
    plane : {"median", "side"}
        Whether the plane through the start runs from front to back or from left to right.

    Raises
    ------
    InputError
        If no way leads from the start directly to the level, both have one height, the section is
        not clean, or the surface winds about an end of the tape.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> back = bm.vertical_drop(body, "back neck point", "back waist point")
    >>> print(f"{back.contact:.4f} {back.unit} along the skin, {back.taut:.4f} drawn taut")
    0.4163 m along the skin, 0.4107 drawn taut
    """
    first, last = position_of(atlas, start, "the start"), position_of(atlas, level, "the level")
    up = atlas.axes.up_vector
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
    forth, word = np.sign(rise) * up, "up" if rise > 0.0 else "down"
    arc, curve = _direct_way(section, first, last, forth, word)
    turn = _turn(section, arc, 0.5 * (first + last), forth)
    # Where the atlas is open at the middle height, the way in which the whole curve turns decides.
    turn = signed_area(curve.positions @ curve.plane.frame().T) if turn is None else turn
    hull = outer_hull(arc, turn)
    return Drop(arc.length, hull.length, hull.error_estimate, arc, hull, atlas.unit)


def _direct_way(
    section: PlaneSection, first: Array, last: Array, forth: Array, word: str
) -> tuple[SectionLoop, SectionLoop]:
    """Return the way from the first point to the height of the last, and its whole curve."""
    loop = section.nearest(first)
    far = float((last - first) @ forth)
    ways: list[tuple[SectionLoop, SectionLoop]] = []
    roundabout = False
    place = nearest_place(loop, first)
    for curve, begin in ((loop, place), (turned(loop), loop.count - place)):
        end = begin + curve.count if curve.closed else float(curve.count)
        if begin == end:
            continue
        whole = part(curve, begin, end)
        reached = _reached(whole, last, forth, ROUNDING * far)
        if reached is None:
            continue
        way = part(whole, 0.0, reached)
        roundabout = True
        if ((way.positions - first) @ forth).min() >= -RISE * far:
            ways.append((way, curve))
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
    return min(ways, key=lambda way: float(np.linalg.norm(way[0].positions[-1] - last)))


def _reached(arc: SectionLoop, last: Array, forth: Array, rounding: float) -> float | None:
    """Return the first place at which an arc reaches a level, if it does."""
    places = sign_changes(arc, lambda x: (x - last) @ forth)
    if len(places):
        return float(places[0])
    end = float(arc.count)
    below = float((arc.positions_at(np.array([end]))[0] - last) @ forth)
    return end if abs(below) <= rounding else None


def _turn(section: PlaneSection, arc: SectionLoop, middle: Array, forth: Array) -> float | None:
    """Return a positive number if the body lies to the left of an arc in the plane's frame.

    The number is negative if the body lies to the right. The horizontal line at a height enters and
    leaves the body by turns; None is returned if it does not leave it.
    """

    def height(positions: Array) -> Array:
        return np.asarray((positions - middle) @ forth)

    along = np.cross(section.plane.normal, forth)
    crossings = np.concatenate(
        [loop.positions_at(sign_changes(loop, height, ORDER)) @ along for loop in section.loops]
    )
    if len(crossings) % 2:
        return None
    own = arc.positions_at(sign_changes(arc, height, ORDER)[:1])[0] @ along
    enters = np.abs(np.sort(crossings) - own).argmin() % 2 == 0
    inwards = along if enters else -along
    # The frame's two vectors and the normal are right-handed.
    return float(np.cross(forth, inwards) @ section.plane.normal)
