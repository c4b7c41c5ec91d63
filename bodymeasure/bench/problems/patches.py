"""Geodesic problems to measure: mild and wild random patches, and the patches of a body."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas
from bodymeasure.measure.patches.diagonals import DIAGONAL_ENDS, DIAGONAL_STARTS

# The paper's random patches have heights k / 5.
LEVELS = 6


class Problems(NamedTuple):
    """Patches (p, 4, 4, 3) and points (p, 2) to be joined."""

    nets: Array
    start: Array
    end: Array

    def take(self, rows: Ints | slice) -> "Problems":
        """Return some of the problems."""
        return Problems(self.nets[rows], self.start[rows], self.end[rows])


def first_diagonals(nets: Array) -> Problems:
    """Return the problems from (0, 0) to (1, 1) on every patch."""
    return Problems(nets, np.zeros((len(nets), 2)), np.ones((len(nets), 2)))


def both_diagonals(atlas: Atlas) -> Problems:
    """Return both diagonals of every patch, in the order of ``diagonals(atlas)`` flattened."""
    nets = atlas.control_points
    start, end = (np.tile(points, (len(nets), 1)) for points in (DIAGONAL_STARTS, DIAGONAL_ENDS))
    return Problems(nets.repeat(2, axis=0), start, end)


def mild_patches(rng: np.random.Generator, count: int, height: float) -> Array:
    """Return control points over a regular grid in the unit square, with heights in [0, height]."""
    nets = _flat(count, 1.0)
    nets[..., 2] = height * rng.random((count, 4, 4))
    return nets


def wild_patches(rng: np.random.Generator, count: int, side: float) -> Array:
    """Return patches as in the paper: heights k / 5, the first corner at 0 and the last at 1."""
    nets = _flat(count, side)
    nets[..., 2] = rng.integers(0, LEVELS, (count, 4, 4)) / (LEVELS - 1.0)
    nets[:, 0, 0, 2], nets[:, 3, 3, 2] = 0.0, 1.0
    return nets


def _flat(count: int, side: float) -> Array:
    x, y = np.meshgrid(*2 * [np.linspace(0.0, side, 4)], indexing="ij")
    return np.broadcast_to(np.stack([x, y, 0.0 * x], axis=-1), (count, 4, 4, 3)).copy()
