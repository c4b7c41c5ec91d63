"""Quadrics and tori as rational patches, and whole ones as atlases."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Unit
from bodymeasure.bezier import elevate, project

HALF = np.sqrt(0.5)
# A quarter of the unit circle, from (1, 0) to (0, 1): homogeneous (w x, w y, w).
QUARTER = np.array([[1.0, 0.0, 1.0], [HALF, HALF, HALF], [0.0, 1.0, 1.0]])


def quarter_arc(center: float, radius: float, number: int = 0) -> Array:
    """The quarter `number` of a circle about (center, 0), homogeneous (w r, w z, w)."""
    cosine, sine = np.round([np.cos(number * np.pi / 2), np.sin(number * np.pi / 2)])
    x, y, weight = QUARTER.T
    turned = [cosine * x - sine * y, sine * x + cosine * y]
    return np.stack([center * weight + radius * turned[0], radius * turned[1], weight], axis=-1)


def revolved(profile: Array, number: int = 0) -> Array:
    """A quarter of the surface of revolution of a profile (k, 3); u runs around, v along it."""
    round_, profile = quarter_arc(0.0, 1.0, number), np.asarray(profile, dtype=np.float64)
    x, y, weight = (round_[:, axis, None] for axis in range(3))
    r, z, w = profile.T
    return np.stack([x * r, y * r, weight * z, weight * w], axis=-1)


def line(start: tuple[float, float], end: tuple[float, float]) -> Array:
    """A straight profile between points (r, z)."""
    return np.array([[*start, 1.0], [*end, 1.0]])


def octant(radius: float = 1.0) -> Array:
    """An eighth of a sphere, shape (3, 3, 4): u is the longitude, v the latitude up to the pole."""
    return revolved(quarter_arc(0.0, radius))


def stretched(nets: Array, factors: tuple[float, float, float]) -> Array:
    """The patches scaled along the axes."""
    return np.asarray(nets * [*factors, 1.0])


def sphere_nets() -> Array:
    """The eight octants of the unit sphere."""
    north = quarter_arc(0.0, 1.0)
    south = quarter_arc(0.0, 1.0, 3)
    return np.array([revolved(profile, k) for profile in (north, south) for k in range(4)])


def torus_nets(large: float, small: float) -> Array:
    """The sixteen patches of a torus."""
    profiles = [quarter_arc(large, small, k) for k in range(4)]
    return np.array([revolved(profile, k) for profile in profiles for k in range(4)])


def joined(nets: Array, degree: int = 3) -> Atlas:
    """An atlas of rational patches; control points that agree to nine digits are one."""
    nets = elevate(nets, degree, degree)
    points = project(nets).reshape(-1, 3)
    # The shift keeps rounding away from the numbers that occur.
    _, first, number = np.unique(
        np.round(points + 0.123456789e-3, 9), axis=0, return_index=True, return_inverse=True
    )
    return Atlas(
        points[first], number.reshape(-1, degree + 1, degree + 1), Unit.M, weights=nets[..., 3]
    )


def arc_parameter(angle: Array) -> Array:
    """The parameter of the point at an angle, in [0, pi / 2], on a quarter arc.

    The tangent of half the angle is ``t / (sqrt(2) (1 - t) + t)``, which is solved for t.
    """
    half = np.tan(angle / 2.0)
    return np.asarray(half * np.sqrt(2.0) / (1.0 + half * (np.sqrt(2.0) - 1.0)))
