"""Tubes of four patches around, whose horizontal sections differ only in their size."""

from collections.abc import Sequence

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Unit
from bodymeasure.bezier import bernstein

# Control points of a quarter of a nearly round, convex curve.
QUARTER = np.array([[1.0, 0.0], [1.0, 0.55], [0.55, 1.0], [0.0, 1.0]])


def tube(radii: Sequence[float], center: tuple[float, float] = (0.0, 0.0)) -> Atlas:
    """A tube from z = 0 to 3 whose radius is a cubic with these Bernstein coefficients."""
    ring = np.concatenate([_turned(quarter)[:3] for quarter in range(4)])
    scaled = np.asarray(radii)[:, None, None] * ring + center
    heights = np.broadcast_to(np.arange(4.0)[:, None, None], (4, 12, 1))
    points = np.concatenate([scaled, heights], axis=-1)
    number = np.arange(48).reshape(4, 12)
    index = [number[:, (3 * quarter + np.arange(4)) % 12].T for quarter in range(4)]
    return Atlas(points.reshape(-1, 3), np.array(index), Unit.CM)


def cone(height: float) -> Atlas:
    """A cone over the ring of radius 1, of four patches whose side u = 0 is its tip."""
    ring = np.concatenate([_turned(quarter)[:3] for quarter in range(4)])
    levels = np.arange(1, 4)[:, None, None] / 3
    heights = np.broadcast_to(height * (1.0 - levels), (3, 12, 1))
    points = np.concatenate([levels * ring, heights], axis=-1).reshape(-1, 3)
    around = (3 * np.arange(4)[:, None] + np.arange(4)) % 12
    index = 1 + 12 * np.arange(3)[:, None] + around[:, None, :]
    tip = np.zeros((4, 1, 4), dtype=np.int64)
    return Atlas(
        np.vstack([[0.0, 0.0, height], points]), np.concatenate([tip, index], axis=1), Unit.CM
    )


def ring_length() -> float:
    """The length of the section of radius 1."""
    # The integrand is smooth, and so 40 Gauss points are exact to rounding.
    x, weights = np.polynomial.legendre.leggauss(40)
    velocity = bernstein(3, 0.5 * (1.0 + x), order=1)[:, 1] @ QUARTER
    return float(2.0 * weights @ np.linalg.norm(velocity, axis=1))


def joined(atlases: Sequence[Atlas], regions: Sequence[str]) -> Atlas:
    """One atlas of several that lie side by side, each of which is a region."""
    starts = np.cumsum([0, *(len(atlas.points) for atlas in atlases)])
    index = [atlas.index + start for atlas, start in zip(atlases, starts[:-1], strict=True)]
    names = [
        region for atlas, region in zip(atlases, regions, strict=True) for _ in range(len(atlas))
    ]
    return Atlas(
        np.concatenate([atlas.points for atlas in atlases]),
        np.concatenate(index),
        Unit.CM,
        regions=tuple(names),
    )


def _turned(quarter: int) -> Array:
    points = QUARTER
    for _ in range(quarter):
        points = np.stack([-points[:, 1], points[:, 0]], axis=-1)
    return points
