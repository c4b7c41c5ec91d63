"""Paths past a pole, composed of the geodesics to it and from it."""

from dataclasses import replace

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Neighbors, on_side
from bodymeasure.geodesic.across.pieces.part import PathPart, PathPiece
from bodymeasure.geodesic.across.pieces.path import AtlasPath
from bodymeasure.geodesic.across.poles.fan import Fan, fan_at
from bodymeasure.geodesic.across.poles.junction import (
    Passage,
    PoleLeg,
    passage,
    stiffness_at_pole,
)
from bodymeasure.geodesic.across.search.leg import ROUNDING, STANDSTILL, Ends
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.status import Status

# A leg of less than this part of the radius of curvature is straight. One of less than the other
# part leaves the pole in the direction of its chord.
BESIDE, SHORT = 1e-7, 0.05
# A leg comes to rest where its length changes by this part of it.
LOOSE = 1e-14
# A path has the largest error of its direction at its ends: so many times that which its length has
# on the whole.
SLOPES = 10.0


def composed_path(
    ends: Ends, fan: Fan, legs: tuple[AtlasPath, AtlasPath]
) -> tuple[AtlasPath, Passage] | None:
    """Return the path past a pole as that over two legs, less what it gains on them."""
    first = _pole_leg(fan, legs[0], ends[0], turned=False)
    second = _pole_leg(fan, legs[1], ends[1], turned=True)
    if first is None or second is None:
        return None
    turn = min(fan.ways(first.direction, second.direction))
    gained = passage(turn, (first, second), fan.curvature)
    whole = AtlasPath.concatenate(legs)
    rounding = ROUNDING * float(np.abs(fan.atlas.points).max())
    path = replace(
        whole,
        points=ends,
        leg_ends=(0.0, 1.0),
        length=whole.length - gained.gain,
        error_estimate=whole.error_estimate + gained.error + rounding,
    )
    return path, gained


def _pole_leg(fan: Fan, leg: AtlasPath, other: AtlasPoint, turned: bool) -> PoleLeg | None:
    """Return what is known of a leg to the pole, or from it, where its end is another point."""
    pieces = leg.pieces[::-1] if turned else leg.pieces
    direction = fan.direction(pieces[-1].end(0 if turned else -1))
    # Its length says how far it is from straight, to the second order.
    doubt = abs(leg.raw_length - leg.length) + leg.error_estimate + LOOSE * leg.length
    unsure = SLOPES * np.sqrt(2.0 * doubt / leg.length)
    straight = fan.chord_direction(other) if leg.length * fan.curvature < SHORT else None
    rounding = ROUNDING * float(np.abs(fan.atlas.points).max()) / leg.length
    bent = rounding + (leg.length * fan.curvature) ** 2
    if straight is not None and bent < unsure:
        direction, unsure = straight, bent
    if direction is None:
        return None
    stiffness = stiffness_at_pole(fan.atlas, [(piece, turned) for piece in pieces])
    return PoleLeg(direction, float(unsure), leg.length, stiffness)


def radial(fan: Fan, ends: Ends) -> AtlasPath | None:
    """Return the straight path between a pole and a point right beside it; None if it is not so."""
    numbers = [number for number, end in enumerate(ends) if fan.sector(end) is not None]
    if len(numbers) != 1:
        return None
    number = numbers[0]
    other = ends[1 - number]
    sector = next((one for one in fan.sectors if one.patch == other.patch), None)
    length = float(np.linalg.norm(np.subtract(*map(fan.atlas.position, ends))))
    if sector is None or length * fan.curvature > BESIDE:
        return None
    pole = AtlasPoint(other.patch, *on_side(sector.side, other[2 - EDGES[sector.side].fixed_axis]))
    points = (pole, other) if number == 0 else (other, pole)
    values = np.array([point[1:] for point in points]).T
    error = fan.curvature * length**2 + ROUNDING * float(np.abs(fan.atlas.points).max())
    known = Length(*map(np.asarray, (length, 0.0, error, 0.0, 0, True)))
    part = PathPart((PathPiece(other.patch, STANDSTILL, values, length),), (), known)
    return AtlasPath.of(fan.atlas, ends, part, Status.CONVERGED)


def beside_pole(atlas: Atlas, neighbors: Neighbors, ends: Ends) -> AtlasPath | None:
    """Return the path between a pole and a point right beside it; None if that is not so."""
    pole = next((end for end in ends if neighbors.pole_side(end) is not None), None)
    fan = None if pole is None else fan_at(atlas, pole)
    return None if fan is None else radial(fan, ends)
