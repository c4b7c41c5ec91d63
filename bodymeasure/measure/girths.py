"""Girths: lengths of plane sections, along the skin and with the tape drawn taut."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Atlas, Unit
from bodymeasure.errors import InputError
from bodymeasure.measure.merging import refuse_merged
from bodymeasure.measure.places import Place, position_of
from bodymeasure.section import Plane, SectionLoop, convex_hull, plane_section


@dataclass(frozen=True, eq=False)
class Girth:
    """A girth.

    Parameters
    ----------
    contact : float
        Length of the section: a tape that follows the skin. In `unit`.
    taut : float
        Perimeter of its convex hull: a tape that bridges hollows. Never above `contact`.
    error_estimate : float
        Of either.
    loop : SectionLoop
        The section's loop.
    bridges : ndarray, shape (k, 2, 3)
        Ends of the straight parts of the taut tape.
    unit : Unit
    """

    contact: float
    taut: float
    error_estimate: float
    loop: SectionLoop
    bridges: NDArray[np.float64]
    unit: Unit

    @property
    def gap(self) -> float:
        """By how much the taut tape is shorter than the one that follows the skin."""
        return self.contact - self.taut


def plane_girth(atlas: Atlas, plane: Plane, at: Place, *, limb: bool = False) -> Girth:
    """Girth in a plane, of the part of the body that is nearest to a place.

    Parameters
    ----------
    atlas : Atlas
    plane : Plane
    at : str, AtlasPoint or ndarray of shape (3,)
        Chooses among the loops of the section.
    limb : bool
        Whether the loop is to go round an arm or a leg alone.

    Raises
    ------
    InputError
        If the plane misses the body or has no clean section, the landmark is unknown, or the loop
        is open or merges parts of the body.
    """
    return girth_of_loop(section_loop(atlas, plane, at, limb=limb))


def section_loop(atlas: Atlas, plane: Plane, at: Place, *, limb: bool = False) -> SectionLoop:
    """The loop that `plane_girth` measures."""
    section = plane_section(atlas, plane)
    loop = section.nearest(position_of(atlas, at))
    refuse_merged(section, loop, limb=limb)
    return loop


def girth_of_loop(loop: SectionLoop) -> Girth:
    """Contact and taut length of a closed loop."""
    hull = convex_hull(loop)
    return Girth(loop.length, hull.length, hull.error_estimate, loop, hull.bridges, loop.unit)


def body_girth(atlas: Atlas, at: Place) -> Girth:
    """Horizontal girth at the height of a place: bust, waist, hip, neck.

    Parameters
    ----------
    atlas : Atlas
    at : str, AtlasPoint or ndarray of shape (3,)

    Raises
    ------
    InputError
        As `plane_girth`.
    """
    return plane_girth(atlas, Plane(position_of(atlas, at), atlas.axes.up_vector), at)


def limb_girth(atlas: Atlas, start: Place, end: Place, *, at: Place | float = 0.5) -> Girth:
    """Girth of an arm or a leg, perpendicular to its axis.

    Parameters
    ----------
    atlas : Atlas
    start, end : str, AtlasPoint or ndarray of shape (3,)
        Two places, between which the axis is straight.
    at : float, str, AtlasPoint or ndarray of shape (3,)
        A fraction of the way from start to end, or a place that the plane passes through.

    Raises
    ------
    InputError
        As `plane_girth`, or if start and end coincide.
    """
    first, last = position_of(atlas, start), position_of(atlas, end)
    point = first + at * (last - first) if isinstance(at, (int, float)) else position_of(atlas, at)
    return plane_girth(atlas, Plane(point, limb_axis(first, last)), point, limb=True)


def limb_axis(first: NDArray[np.float64], last: NDArray[np.float64]) -> NDArray[np.float64]:
    """Direction from one position to another, refused where they coincide."""
    if np.array_equal(first, last):
        raise InputError("the limb's axis starts and ends at one place; expected two places")
    return last - first
