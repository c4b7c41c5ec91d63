r"""How much shorter a path is that passes close by a pole than the way through the pole.

Two geodesics, the legs, meet at a pole at an angle :math:`\varphi`, of lengths a and b. If
:math:`\varphi \ge \pi` on both sides, as at the tip of a saddle-shaped cone, the way through the
pole is the shortest. Else the shortest path passes on the side of the smaller angle, at a distance
h from the pole. Moving the joint of the legs by :math:`\delta` across them changes their lengths by
:math:`\tfrac12 (j_a + j_b) \delta^2`, where j is the quotient :math:`\psi' / \psi` at the pole of
the Jacobi field that vanishes at the other end of the leg. To leading order

- two legs that nearly go straight on, :math:`\varphi = \pi - \beta`, are shorter by
  :math:`\tfrac12 \beta^2 / (j_a + j_b)`, with :math:`h = \beta / (j_a + j_b)`;
- a leg whose length a is small beside b and the radius of curvature displaces the end of the other
  one: together they change by
  :math:`-a (1 + \cos\varphi) + \tfrac12 a^2 j_b \sin^2\varphi`;
- two short legs are sides of a triangle in the plane.

Where the end of the long leg is conjugate to the pole, as on the other side of a sphere, no more is
known than the triangle inequality: the path is as long as the long leg, but for the short one.

What is left out elsewhere are terms of the third order in the small length, times the square of the
surface's curvature and of the inverse lengths.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.geodesic.across.pieces.part import PathPiece
from bodymeasure.geodesic.lengths.path_geometry import path_geometry
from bodymeasure.geodesic.surfaces.rational import surfaces_of

# Steps on each piece of a leg in which its curvature is taken as constant, which gives j to some
# four digits, and the part of what follows from j that is added to the error.
STEPS = 64
INEXACT = 1e-2
# What is left out is of the size of the terms above; so many times that is the estimate.
SAFETY = 5.0
# The formula for a leg that displaces the end of the other one holds if its length is at most this
# part of the radii that are compared, and that for two legs up to this angle.
SHORT, STRAIGHT = 0.05, 0.2


# Below this rate sine and its argument are one.
TINY = 1e-12


class PoleLeg(NamedTuple):
    """A geodesic from a pole to another point.

    Parameters
    ----------
    direction : float
        The angle at which it leaves the pole, in its fan.
    unsure : float
        About the error of that angle.
    length : float
    stiffness : float
        The quotient j of the text above; infinite if the other end is conjugate to the pole.
    """

    direction: float
    unsure: float
    length: float
    stiffness: float


class Passage(NamedTuple):
    """The length that a path past a pole gains on the way through it.

    Parameters
    ----------
    gain : float
        How much shorter it is, in the atlas's unit.
    error : float
    away : float
        About how far from the pole it passes.
    conjugate : bool
        Whether the other end of a leg is conjugate to the pole, or nearly so.
    """

    gain: float
    error: float
    away: float
    conjugate: bool = False


def passage(turn: float, legs: tuple[PoleLeg, PoleLeg], curvature: float) -> Passage:
    """Return what the shortest path past a pole gains on two legs that meet there.

    Parameters
    ----------
    turn : float
        The smaller angle between the legs.
    legs : pair of PoleLeg
    curvature : float
        The largest curvature near the pole.
    """
    short, long = sorted(legs, key=lambda leg: leg.length)
    a, b = short.length, long.length
    if not all(np.isfinite(leg.stiffness) for leg in legs):
        return Passage(a, a, a, conjugate=True)
    if turn >= np.pi:
        return Passage(0.0, 0.0, 0.0)
    bend = np.pi - turn
    # Without rounding where the legs go straight on, or back.
    side = np.sqrt((a - b) ** 2 + 4.0 * a * b * np.sin(0.5 * turn) ** 2)
    across = a * b * np.sin(turn) / side if side > 0.0 else 0.0
    away = across if turn > 0.5 * np.pi else a
    gain = (2.0 * a * b * (1.0 + np.cos(turn))) / (a + b + side)
    found = [Passage(gain, SAFETY * curvature**2 * (a + b) ** 3, away)]
    if a * max(1.0 / b, curvature, abs(long.stiffness)) < SHORT:
        gain = 2.0 * a * np.sin(0.5 * bend) ** 2
        second = 0.5 * a**2 * long.stiffness * np.sin(turn) ** 2
        rest = a**3 * (1.0 / b**2 + long.stiffness**2 + curvature**2)
        error = SAFETY * rest + INEXACT * abs(second)
        found.append(Passage(gain - second, error, away))
    stiffness = short.stiffness + long.stiffness
    if bend < STRAIGHT and stiffness > 0.0:
        away = bend / stiffness
        gain = 0.5 * bend * away
        error = SAFETY * away**3 * (curvature**2 + 1.0 / a**2) + INEXACT * gain
        found.append(Passage(gain, error, away))
    best = min(found, key=lambda each: each.error)
    unsure = best.away * (short.unsure + long.unsure)
    return best._replace(error=best.error + unsure)


def stiffness_at_pole(atlas: Atlas, pieces: Sequence[tuple[PathPiece, bool]]) -> float:
    """Return the stiffness of a leg at the pole; infinite if its other end is conjugate to it.

    It is infinite as well if the other end is conjugate to a point between.

    Parameters
    ----------
    atlas : Atlas
    pieces : sequence of (PathPiece, bool)
        The pieces in order, towards the pole, and whether each runs the other way.
    """
    field, slope = 0.0, 1.0
    t = (np.arange(STEPS) + 0.5) / STEPS
    for piece, turned in pieces:
        if piece.length == 0.0:
            continue
        surface = surfaces_of(atlas.control_points[[piece.patch]])
        matrices = piece.space.matrices(1.0 - t if turned else t)
        geometry = path_geometry(
            surface, *((matrix @ piece.values.T).T[None] for matrix in matrices)
        )
        for speed, bend in zip(
            *map(np.ravel, (geometry.speed, geometry.gaussian_curvature)), strict=True
        ):
            step, rate = speed / STEPS, np.sqrt(abs(bend)) * speed / STEPS
            cosine = np.cos(rate) if bend > 0.0 else np.cosh(rate)
            # The sine, or its hyperbolic counterpart, divided by the rate.
            sine = step * (np.sinc(rate / np.pi) if bend > 0.0 else np.sinh(rate) / max(rate, TINY))
            if rate <= TINY:
                cosine, sine = 1.0, step
            field, slope = field * cosine + slope * sine, slope * cosine - field * bend * sine
            if not field > 0.0:
                return np.inf
    return float(slope / field) if field > 0.0 else np.inf
