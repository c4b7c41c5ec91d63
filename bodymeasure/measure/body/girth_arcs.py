"""Parts of girths: the front or the back of a tape around the body, between two places."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError
from bodymeasure.measure.body.girths import Girth
from bodymeasure.measure.body.taut_places import TautPlaces
from bodymeasure.section import DRAWN, Curve, DrawnTape, nearest_place
from bodymeasure.trust import is_known
from bodymeasure.wording import result_line

# Parts of a girth whose middles are less than this part of the girth apart from front to back lie
# beside one another. The middles of a circle's halves are 0.2 of it apart.
BESIDE = 0.01
# Places closer together than this part of the girth are one, as far as a body is known.
ONE_PLACE = 1e-6
# Distances to the nearest place distinguish places only down to the square root of their rounding.
UNSETTLED = 4e-8


@dataclass(frozen=True, eq=False)
class GirthArc:
    """The part of a girth between two places; the other part is the rest of it.

    Parameters
    ----------
    contact : float
        Along the skin, in `unit`.
    taut : float
        Along the girth's taut tape. Where that spans a hollow in which the part ends, it ends
        square across from there. At most `contact`, except for
        rounding.
    error_estimate : float
        Estimated error of either length: the whole girth's, and the uncertainty of its ends.
    contact_tape, taut_tape : DrawnTape
    length_by_region : mapping of str to float
        Contact length inside each body region.
    unit : Unit
    """

    contact: float
    taut: float
    error_estimate: float
    contact_tape: DrawnTape
    taut_tape: DrawnTape
    length_by_region: Mapping[str, float]
    unit: Unit

    def __repr__(self) -> str:
        return result_line(
            "GirthArc", self.unit, self.error_estimate, contact=self.contact, taut=self.taut
        )

    @property
    def converged(self) -> bool:
        """Whether the lengths can be trusted: their error is a small enough part of them."""
        return bool(is_known(self.contact, self.error_estimate, self.contact))


def girth_arc(
    girth: Girth,
    start: ArrayLike,
    end: ArrayLike,
    front: ArrayLike,
    side: Literal["front", "back"],
) -> GirthArc:
    """Return the front or the back part of a girth between two places.

    Parameters
    ----------
    girth : Girth
    start, end : array_like, shape (3,)
        Positions; the part ends where the girth is nearest to them.
    front : array_like, shape (3,)
        Unit vector to the front.
    side : {"front", "back"}
        The part whose middle (the center of mass of a thin wire) lies farther that way is meant.

    Raises
    ------
    InputError
        If both places are one on the girth, neither part lies before the other, or the taut tape
        has nothing between them.
    """
    if side not in ("front", "back"):
        raise InputError(f"side is {side!r}; expected 'front' or 'back'")
    curve = girth.tape
    first, last, away = arc_ends(girth, start, end, front, side)
    error = girth.error_estimate + UNSETTLED * away
    contact = _run(curve, first, last)
    places = TautPlaces.on(girth.tape, girth.hull)
    taut, rest = places.run(first, last), places.run(last, first)
    # Neither part runs back over the other.
    if not 0.0 < taut <= contact + error or rest > curve.length - contact + error:
        raise InputError(
            "both ends of the arc lie in one hollow, where the taut tape has nothing between "
            "them; choose ends that lie open"
        )
    around = _around(curve, first, last)
    return GirthArc(
        contact,
        taut,
        error,
        DrawnTape(curve.positions_at(around), *curve.surface_points_at(around)),
        places.drawn(around),
        _length_by_region(girth, first, last),
        girth.unit,
    )


def arc_ends(
    girth: Girth, start: ArrayLike, end: ArrayLike, front: ArrayLike, side: Literal["front", "back"]
) -> tuple[float, float, float]:
    """Return the places at which a part of a girth begins and ends, as for `girth_arc`.

    Returns
    -------
    first, last : float
        Places of the girth's tape; the part runs forwards from the first one.
    away : float
        The sum of their distances from the positions that were given.
    """
    curve = girth.tape
    wanted = np.asarray([start, end], dtype=np.float64)
    wanted -= curve.plane.distances(wanted)[:, None] * curve.plane.normal
    ends = (nearest_place(curve, wanted[0]), nearest_place(curve, wanted[1]))
    away = np.linalg.norm(curve.positions_at(np.array(ends)) - wanted, axis=1)
    first, last = _ends_of(curve, ends, np.asarray(front, dtype=np.float64), side)
    return first, last, float(away.sum())


def _ends_of(
    curve: Curve, ends: tuple[float, float], front: Array, side: Literal["front", "back"]
) -> tuple[float, float]:
    """Return both places in the order in which the curve runs along the part on that side."""
    one, other = ends
    way = _run(curve, one, other)
    if min(way, curve.length - way) <= ONE_PLACE * curve.length:
        raise InputError(
            "both ends of the arc are at one place of the girth, so there is nothing between "
            "them; choose two places beside it"
        )
    before = _middle(curve, one, other, front) - _middle(curve, other, one, front)
    if abs(before) < BESIDE * curve.length:
        raise InputError(
            "the two parts of the girth between the arc's ends lie beside one another, so that "
            "neither is the front one; choose ends at the left and at the right"
        )
    return (one, other) if (before > 0.0) == (side == "front") else (other, one)


def _run(curve: Curve, first: float, last: float) -> float:
    """Return the length of a closed curve from one place forwards to another."""
    start, end = (float(length) for length in curve.arc_length_at(np.array([first, last])))
    return end - start if last >= first else curve.length - (start - end)


def _around(curve: Curve, first: float, last: float) -> Array:
    """Return places at which to draw a closed curve, from one forwards to another."""
    stop = last if last > first else last + curve.count
    inner = np.arange(np.floor(first * DRAWN) + 1.0, np.ceil(stop * DRAWN)) / DRAWN
    places: Array = np.concatenate([[first], inner, [stop]])
    return np.where(places >= curve.count, places - curve.count, places)


def _middle(curve: Curve, first: float, last: float, front: Array) -> float:
    """Return how far in front a part's middle lies, to drawing accuracy."""
    points = curve.positions_at(_around(curve, first, last))
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return float(steps @ (0.5 * (points[1:] + points[:-1]) @ front) / steps.sum())


def _length_by_region(girth: Girth, first: float, last: float) -> dict[str, float]:
    curve, regions = girth.tape, girth.loop.regions
    stop = last if last > first else last + curve.count
    bounds = np.concatenate([[first], np.arange(np.floor(first) + 1.0, np.ceil(stop)), [stop]])
    row = np.floor(0.5 * (bounds[1:] + bounds[:-1]))
    again = np.where(row >= curve.count, curve.count, 0)
    # Both ends of a stretch are taken on its own piece, whose end is not the next one's start here.
    begin, end = (curve.arc_length_at(side - again) for side in (bounds[:-1], bounds[1:]))
    patch, _ = curve.surface_points_at(0.5 * (bounds[1:] + bounds[:-1]) - again)
    result: dict[str, float] = {}
    for number, length in zip(patch.tolist(), (end - begin).tolist(), strict=True):
        # Straight lines over cuts lie in no region.
        if number >= 0:
            result[regions[number]] = result.get(regions[number], 0.0) + length
    return result
