"""The curves that are measured along a section: whole, in part, or joined by straight lines."""

from typing import NamedTuple, Protocol

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.section.plane import Plane

# Fractions of a piece at which a curve is drawn.
DRAWN = 8


class Curve(Protocol):
    """A curve of pieces in a plane.

    A place on it is the number of a piece plus the fraction run of it.
    """

    @property
    def plane(self) -> Plane:
        """The plane that it lies in."""

    @property
    def closed(self) -> bool:
        """Whether it returns to its start."""

    @property
    def count(self) -> int:
        """How many pieces it has."""

    @property
    def length(self) -> float:
        """Its length."""

    @property
    def error_estimate(self) -> float:
        """Estimated error of the length."""

    def positions_at(self, place: Array) -> Array:
        """Return positions (n, 3) at places (n,)."""

    def arc_length_at(self, place: Array) -> Array:
        """Return lengths (n,) from the start to places (n,)."""

    def motion(self, row: Ints, fraction: Array) -> tuple[Array, Array]:
        """Return positions and their derivatives by the fraction, both (n, k, 3).

        They are those at fractions (n, k) of pieces (n,).
        """

    def surface_points_at(self, place: Array) -> tuple[Ints, Array]:
        """Return patches (n,) and (u, v) (n, 2) at places (n,); -1 and NaN off the surface."""


class DrawnTape(NamedTuple):
    """A tape as a chain of points.

    Parameters
    ----------
    positions : ndarray, shape (k, 3)
        In order; a closed tape ends at its first point.
    patch : ndarray of int, shape (k,)
        The patch that each point lies on; -1 where the tape stands free.
    parameters : ndarray, shape (k, 2)
        (u, v) on that patch; NaN where the tape stands free.
    """

    positions: Array
    patch: Ints
    parameters: Array


def drawn(curve: Curve, spans: Array | None = None) -> DrawnTape:
    """Return a curve as a chain of points, straight over some spans.

    Parameters
    ----------
    curve : Curve
    spans : ndarray, shape (k, 2), optional
        Places at which straight parts start and end, such as `Hull.spans`. A part that starts after
        it ends runs over the curve's start.
    """
    end = float(curve.count)
    place = np.arange(DRAWN * curve.count + 1, dtype=np.float64) / DRAWN
    for first, last in np.empty((0, 2)) if spans is None else spans:
        inside = (place > first) & (place < last)
        if first > last:
            inside = (place > first) | (place < last)
        place = np.concatenate([place[~inside], [first, last]])
    place = np.unique(np.clip(place, 0.0, end))
    if curve.closed:
        # The start comes again at the end, unless a span left it out.
        place = np.append(place[place < end], place[0])
    patch, parameters = curve.surface_points_at(place)
    return DrawnTape(curve.positions_at(place), patch, parameters)
