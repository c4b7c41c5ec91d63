"""Patches over the square of the plane: height fields, and a flat one with a bulging edge."""

import numpy as np

from bodymeasure._typing import Array


def heights(z: Array, side: float = 1.0) -> Array:
    """Control points over a square grid."""
    line = np.linspace(0.0, side, 4)
    x, y = np.meshgrid(line, line, indexing="ij")
    return np.stack([x, y, z], axis=-1)


def bent_plane() -> Array:
    """A plane patch whose edge u = 0 bulges inwards, across the chord of its diagonal.

    x = u + bulge v (1 - v) (1 - u), y = v: the patch is flat, so its shortest paths are those of a
    plane region.
    """
    u, v = np.meshgrid(np.linspace(0, 1, 4), np.linspace(0, 1, 4), indexing="ij")
    net = np.stack([u, v, np.zeros_like(u)], axis=-1)
    bulge = np.array([0.0, 1.0, 1.0, 0.0]) / 3.0
    net[..., 0] = u + 2.4 * bulge * (1.0 - u)
    return net
