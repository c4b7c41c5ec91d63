"""Girths: lengths of plane sections, along the skin and with the tape drawn taut."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Unit
from bodymeasure.atlas.queries.locations import Location, position_of
from bodymeasure.errors import InputError
from bodymeasure.measure.body.cutting import cut_loop
from bodymeasure.measure.body.merging import UNCHECKED, merged, refuse_merged
from bodymeasure.section import (
    BridgedLoop,
    DrawnTape,
    Hull,
    Plane,
    SectionLoop,
    convex_hull,
    drawn,
    plane_section,
)
from bodymeasure.threads import one_blas_thread
from bodymeasure.trust import is_known
from bodymeasure.wording import result_line


@dataclass(frozen=True, eq=False)
class Girth:
    """A girth.

    Parameters
    ----------
    contact : float
        Length of the section: a tape that follows the skin. In `unit`. Where the loop is cut at
        the armpits, the straight lines over the cuts are part of it.
    taut : float
        Perimeter of its convex hull: a tape that bridges hollows. Never above `contact`.
    error_estimate : float
        Estimated error of either length, in `unit`.
    loop : SectionLoop
        The whole loop of the section.
    tape : SectionLoop or BridgedLoop
        The curve that is measured: the loop, or what cuts leave of it.
    hull : Hull
        Where the taut tape leaves it.
    unit : Unit
    remark : str
        A remark on what was not checked; empty if all was.
    """

    contact: float
    taut: float
    error_estimate: float
    loop: SectionLoop
    tape: SectionLoop | BridgedLoop
    hull: Hull
    unit: Unit
    remark: str = ""

    def __repr__(self) -> str:
        return result_line(
            "Girth",
            self.unit,
            self.error_estimate,
            outcome=self.remark,
            contact=self.contact,
            taut=self.taut,
        )

    @property
    def converged(self) -> bool:
        """Whether the lengths can be trusted: their error is a small enough part of them."""
        return bool(is_known(self.contact, self.error_estimate, self.contact))

    @property
    def approximation_error(self) -> float:
        """A bound on the difference from the length on the surface that the patches approximate."""
        return self.tape.approximation_error

    @property
    def gap(self) -> float:
        """The length that the taut tape saves over the one that follows the skin."""
        return self.contact - self.taut

    @property
    def bridges(self) -> Array:
        """Ends of the straight parts of the taut tape over hollows, shape (k, 2, 3)."""
        return self.hull.bridges

    @property
    def contact_tape(self) -> DrawnTape:
        """The tape that follows the skin, to be drawn."""
        return drawn(self.tape)

    @property
    def taut_tape(self) -> DrawnTape:
        """The tape drawn taut, to be drawn."""
        return drawn(self.tape, self.hull.spans)


@one_blas_thread()
def plane_girth(atlas: Atlas, plane: Plane, at: Location, *, limb: bool = False) -> Girth:
    """Return the girth in a plane, of the part of the body that is nearest to a place.

    Parameters
    ----------
    atlas : Atlas
    plane : Plane
    at : str, AtlasPoint or ndarray of shape (3,)
        Chooses among the loops of the section.
    limb : bool
        Whether the loop is to go round an arm or a leg alone.

    Returns
    -------
    Girth

    Raises
    ------
    InputError
        If the plane misses the body or has no clean section, the landmark is unknown, or the loop
        is open or merges parts of the body.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> plane = bm.Plane(body.position(body.landmarks["front waist point"]), (0.0, 0.1, 1.0))
    >>> girth = bm.plane_girth(body, plane, "front waist point")
    >>> print(f"{girth.contact:.4f} {girth.unit}")
    0.7299 m
    """
    return girth_of_loop(section_loop(atlas, plane, at, limb=limb))


def section_loop(atlas: Atlas, plane: Plane, at: Location, *, limb: bool = False) -> SectionLoop:
    """Return the loop that `plane_girth` measures."""
    section = plane_section(atlas, plane)
    loop = section.nearest(position_of(atlas, at))
    refuse_merged(section, loop, limb=limb)
    return loop


def girth_of_loop(loop: SectionLoop, tape: SectionLoop | BridgedLoop | None = None) -> Girth:
    """Return the girth of a closed loop, or of what is left of it."""
    tape = loop if tape is None else tape
    hull = convex_hull(tape)
    remark = "" if any(loop.regions) else UNCHECKED
    return Girth(tape.length, hull.length, hull.error_estimate, loop, tape, hull, loop.unit, remark)


@one_blas_thread()
def body_girth(
    atlas: Atlas, at: Location, *, cut: tuple[Location, Location] | None = None
) -> Girth:
    """Return the horizontal girth at the height of a place: bust, waist, hip, neck.

    Parameters
    ----------
    atlas : Atlas
    at : str, AtlasPoint or ndarray of shape (3,)
    cut : tuple of two places, optional
        The left and the right armpit. A loop that goes round trunk and arms is cut there by
        vertical planes from front to back, and the cuts are bridged straight; one that goes round
        the trunk alone is left whole.

    Returns
    -------
    Girth

    Raises
    ------
    InputError
        As `plane_girth`; or if the first place to cut at does not lie to the left of the second,
        or a plane misses the loop that it is to cut.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> waist = bm.body_girth(body, "front waist point")
    >>> print(f"{waist.contact:.4f} {waist.unit} along the skin, {waist.taut:.4f} drawn taut")
    0.7111 m along the skin, 0.7110 drawn taut
    """
    plane = Plane(position_of(atlas, at), atlas.axes.up_vector)
    if cut is None:
        return plane_girth(atlas, plane, at)
    if isinstance(cut, str) or len(cut) != 2:
        raise InputError(f"cut is {cut!r}; expected two places: the left and the right armpit")
    left, right = (
        float(position_of(atlas, place, f"the {side} armpit") @ atlas.axes.left_vector)
        for side, place in zip(("left", "right"), cut, strict=True)
    )
    if left <= right:
        raise InputError(
            f"the loop is to be cut from {left:.4g} {atlas.unit} on the left to {right:.4g} on "
            "the right, which leaves nothing between; expected the left armpit first, then the "
            "right one"
        )
    section = plane_section(atlas, plane)
    loop = section.nearest(position_of(atlas, at))
    if any(atlas.regions) and merged(section, loop, limb=False) is None:
        return girth_of_loop(loop)
    return girth_of_loop(loop, cut_loop(loop, atlas.axes.left_vector, (left, right)))


@one_blas_thread()
def limb_girth(
    atlas: Atlas, start: Location, end: Location, *, at: Location | float = 0.5
) -> Girth:
    """Return the girth of an arm or a leg, perpendicular to its axis.

    Parameters
    ----------
    atlas : Atlas
    start, end : str, AtlasPoint or ndarray of shape (3,)
        Two places, between which the axis is straight.
    at : float, str, AtlasPoint or ndarray of shape (3,)
        A fraction of the way from start to end, or a place that the plane passes through.

    Returns
    -------
    Girth

    Raises
    ------
    InputError
        As `plane_girth`, if start and end coincide, or a fraction is not in [0, 1].

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> girth = bm.limb_girth(body, "shoulder point left", "elbow point left", at=0.7)
    >>> print(f"{girth.contact:.4f} {girth.unit}")
    0.2368 m
    """
    first, last = position_of(atlas, start, "the start"), position_of(atlas, end, "the end")
    # `not inside` rather than `outside`, so that NaN is refused too.
    if isinstance(at, (int, float)) and not 0.0 <= at <= 1.0:
        raise InputError(f"at is {at}; expected 0 to 1, or a place on the limb")
    point = first + at * (last - first) if isinstance(at, (int, float)) else position_of(atlas, at)
    return plane_girth(atlas, Plane(point, limb_axis(first, last)), point, limb=True)


def limb_axis(first: Array, last: Array) -> Array:
    """Return the direction from one position to another; refuse positions that coincide."""
    if np.array_equal(first, last):
        raise InputError("the limb's axis starts and ends at one place; expected two places")
    return last - first
