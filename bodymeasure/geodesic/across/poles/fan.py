"""The patches about a pole, and the directions in which a path may leave it.

A side that is collapsed to a point is a pole. Along the side w = 0, the derivative
:math:`d(v) = S_w(0, v)` is the direction in which the line of constant v leaves the pole. The angle
that :math:`d` turns through from one end of the side to the other is the angle of that patch at the
pole. The patches about a pole are its fan; their angles add up to 2 pi on a smooth surface.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.prepared import prepared
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.edges import edges_of
from bodymeasure.atlas.topology.neighbors import Crossing, Neighbors, on_side
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.across.routes.topology import topology
from bodymeasure.geodesic.surfaces.rational import surfaces_of

# The angle of a patch is integrated by this many Gauss points: d is a cubic, or rational.
GAUSS = 24
# Places along a side at which angles are tabulated, to find the place of an angle.
TABLE = np.linspace(0.0, 1.0, 65)
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(GAUSS)


class Poles(NamedTuple):
    """The poles of an atlas.

    Parameters
    ----------
    patch, side : ndarray of int, shape (sides,)
        The collapsed sides.
    point : ndarray of int, shape (sides,)
        The control point in which all of a side lies.
    positions : ndarray, shape (sides, 3)
    widths : ndarray, shape (sides,)
        The distance of the middle of the opposite side.
    """

    patch: Ints
    side: Ints
    point: Ints
    positions: Array
    widths: Array

    def place(self, number: int) -> AtlasPoint:
        """Return the place of a pole, the same one for all sides that are collapsed to it."""
        first = int(np.argmax(self.point == self.point[number]))
        return AtlasPoint(int(self.patch[first]), *on_side(int(self.side[first]), 0.5))


@prepared
def poles_of(atlas: Atlas) -> Poles:
    """Return the collapsed sides of an atlas, which are kept for the next path."""
    table = edges_of(atlas)
    patch, side = np.nonzero(table.collapsed)
    point = table.control_index[patch, side, 0]
    positions = atlas.points[point]
    # The sides 0 and 1 lie opposite to each other, and 2 and 3.
    opposite = np.array([on_side(number, 0.5) for number in (1, 0, 3, 2)]).reshape(4, 2)[side]
    middles = evaluate(atlas.control_points[patch], opposite[:, None])[:, 0]
    return Poles(patch, side, point, positions, np.linalg.norm(middles - positions, axis=1))


class _Directions(NamedTuple):
    """Derivatives at a collapsed side, away from it and, of the first one, along it: (3, k)."""

    first: Array
    second: Array
    mixed: Array

    @property
    def rate(self) -> Array:
        """The rate at which the direction turns along the side, shape (k,)."""
        turning = np.linalg.norm(np.cross(self.first.T, self.mixed.T), axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(turning / (self.first**2).sum(axis=0))


class Sector(NamedTuple):
    """A patch of a fan.

    Parameters
    ----------
    patch, side : int
        The collapsed side.
    rising : bool
        Whether the parameter along the side grows with the angle.
    begin, angle : float
        Where the sector begins, and its angle.
    onward : Crossing or None
        The step over the seam to the next sector; None at the end of an open fan.
    back : Crossing or None
        The step over the seam to the sector before.
    """

    patch: int
    side: int
    rising: bool
    begin: float
    angle: float
    onward: Crossing | None
    back: Crossing | None


@dataclass(frozen=True, eq=False)
class Fan:
    """The patches about a pole.

    Parameters
    ----------
    atlas : Atlas
    sectors : tuple of Sector
        In the order of the angle.
    closed : bool
        Whether the last sector joins the first.
    """

    atlas: Atlas
    sectors: tuple[Sector, ...]
    closed: bool

    @property
    def angle(self) -> float:
        """The angle of the whole fan: 2 pi where the surface is smooth."""
        return self.sectors[-1].begin + self.sectors[-1].angle

    @cached_property
    def curvature(self) -> float:
        """The largest curvature of the lines that leave the pole, or the inverse of their length.

        Parts of the surface that are much smaller than its inverse are parts of a cone.
        """
        poles = poles_of(self.atlas)
        fanned = np.isin(poles.patch, [sector.patch for sector in self.sectors])
        largest = float(1.0 / poles.widths[fanned].min())
        for sector in self.sectors:
            here = _directions(self.atlas, sector.patch, sector.side, TABLE[::8])
            bend = np.linalg.norm(here.second, axis=0) / (here.first**2).sum(axis=0)
            largest = max(largest, float(bend.max()))
        return largest

    def sector(self, place: AtlasPoint) -> int | None:
        """Return the number of the sector that holds a place at the pole; None if none does."""
        for number, sector in enumerate(self.sectors):
            edge = EDGES[sector.side]
            if place.patch == sector.patch and place[1 + edge.fixed_axis] == edge.fixed_value:
                return number
        return None

    def direction(self, place: AtlasPoint) -> float | None:
        """Return the angle at which a path leaves the pole from a place of a collapsed side."""
        number = self.sector(place)
        if number is None:
            return None
        sector = self.sectors[number]
        along = place[2 - EDGES[sector.side].fixed_axis]
        turned = _angle(self.atlas, sector.patch, sector.side, along)
        return sector.begin + (turned if sector.rising else sector.angle - turned)

    def chord_direction(self, place: AtlasPoint) -> float | None:
        """Return the angle of the straight line from the pole to a point close to it.

        None if the point is on no patch of the fan.
        """
        sector = next((one for one in self.sectors if one.patch == place.patch), None)
        if sector is None:
            return None
        along = place[2 - EDGES[sector.side].fixed_axis]
        pole = AtlasPoint(place.patch, *on_side(sector.side, along))
        chord = self.atlas.position(place) - self.atlas.position(pole)
        here = _directions(self.atlas, sector.patch, sector.side, np.array([along]))
        first, normal = here.first[:, 0], np.cross(here.first[:, 0], here.mixed[:, 0])
        sine = np.cross(first, chord) @ normal / np.linalg.norm(normal)
        aside = float(np.arctan2(sine, first @ chord))
        turned = self.direction(pole)
        assert turned is not None
        return turned + (aside if sector.rising else -aside)

    def ways(self, first: float, second: float) -> tuple[float, float]:
        """Return the angles from one direction to another, with the growing angle and against it.

        An angle past the border of an open fan is infinite.
        """
        turn = second - first
        if self.closed:
            return turn % self.angle, -turn % self.angle
        return (turn, np.inf) if turn >= 0.0 else (np.inf, -turn)

    def places(self, number: int, angles: Array, distances: Array) -> Array:
        """Return (u, v) of points of a sector given by polar coordinates, to the first order.

        Parameters
        ----------
        number : int
            The sector.
        angles : ndarray, shape (k,)
            From where the sector begins.
        distances : ndarray, shape (k,)
        """
        sector = self.sectors[number]
        edge = EDGES[sector.side]
        here = _directions(self.atlas, sector.patch, sector.side, TABLE)
        rate = here.rate
        table = np.concatenate([[0.0], np.cumsum(0.5 * (rate[1:] + rate[:-1]) * np.diff(TABLE))])
        share = np.clip(angles / sector.angle, 0.0, 1.0)
        along = np.interp(share if sector.rising else 1.0 - share, table / table[-1], TABLE)
        speed = np.interp(along, TABLE, np.linalg.norm(here.first, axis=0))
        away = np.minimum(distances / speed, 1.0)
        across = edge.fixed_value + (1.0 - 2.0 * edge.fixed_value) * away
        pair = (across, along) if edge.fixed_axis == 0 else (along, across)
        return np.stack(pair, axis=-1)


def fan_at(atlas: Atlas, place: AtlasPoint) -> Fan | None:
    """Return the fan of a pole; None if other than two patches meet at a seam of it.

    None as well if a patch that has no collapsed side there belongs to it.
    """
    neighbors = topology(atlas).neighbors
    patch, side = place.patch, neighbors.pole_side(place)
    if side is None:
        return None
    ahead, closed = _walk(neighbors, patch, side, rising=True)
    if not closed:
        behind, _ = _walk(neighbors, patch, side, rising=False)
        turned = [(one, other, not rising) for one, other, rising in reversed(behind[1:])]
        ahead = [*turned, *ahead]
    if not ahead:
        return None
    sectors: list[Sector] = []
    begin = 0.0
    for one, other, rising in ahead:
        angle = _angle(atlas, one, other, 1.0)
        onward, back = (_over(neighbors, one, other, way) for way in (rising, not rising))
        sectors.append(Sector(one, other, rising, begin, angle, onward, back))
        begin += angle
    sound = np.isfinite(begin) and all(sector.angle > 0.0 for sector in sectors)
    return Fan(atlas, tuple(sectors), closed) if sound else None


def _over(neighbors: Neighbors, patch: int, side: int, rising: bool) -> Crossing | None:
    """Return the step over the seam at the end of a collapsed side, if one patch is beyond it."""
    axis = 1 - EDGES[side].fixed_axis
    seam = next(
        number
        for number, edge in enumerate(EDGES)
        if (edge.fixed_axis, edge.fixed_value) == (axis, float(rising))
    )
    crossings = neighbors.over.get((patch, seam), ())
    return crossings[0] if len(crossings) == 1 else None


def _walk(
    neighbors: Neighbors, patch: int, side: int, rising: bool
) -> tuple[list[tuple[int, int, bool]], bool]:
    """Return the collapsed sides from one on, and whether they lead back to it.

    There are none where a patch without a collapsed side at the pole is among them.
    """
    found = [(patch, side, rising)]
    while True:
        here, on, way = found[-1]
        crossing = _over(neighbors, here, on, way)
        if crossing is None:
            return found, False
        along = EDGES[on].fixed_value
        there = 1.0 - along if crossing.flipped else along
        place = AtlasPoint(crossing.to_patch, *on_side(crossing.to_side, there))
        beyond = neighbors.pole_side(place)
        if beyond is None or len(found) > len(neighbors.collapsed):
            return [], False
        if (place.patch, beyond) == (patch, side):
            return found, True
        found.append((place.patch, beyond, place[2 - EDGES[beyond].fixed_axis] == 0.0))


def _directions(atlas: Atlas, patch: int, side: int, along: Array) -> _Directions:
    """Return the derivatives at a collapsed side."""
    edge = EDGES[side]
    axis, sign = edge.fixed_axis, 1.0 - 2.0 * edge.fixed_value
    fixed = np.full(len(along), edge.fixed_value)
    parameters = np.stack([fixed, along] if axis == 0 else [along, fixed], axis=-1)
    jet = surfaces_of(atlas.control_points[[patch]]).jet(parameters[None], 2)[:, :, 0]
    return _Directions(sign * jet[1 + axis], jet[3 + 2 * axis], sign * jet[4])


def _angle(atlas: Atlas, patch: int, side: int, end: float) -> float:
    """Return the angle that the direction turns through along a side, from 0 to an end."""
    here = _directions(atlas, patch, side, 0.5 * end * (1.0 + _NODES))
    return float(0.5 * end * (_WEIGHTS @ here.rate))
