"""Starts of searches for feet near poles, the edges of patches that are collapsed to a point."""

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.seams import AXIS, VALUE
from bodymeasure.bezier.power_form import jets

# The number of directions, on each patch, in which the surface leaves a pole.
DIRECTIONS = 33
# A foot is near a pole if its parameter is this close to that of the collapsed edge. There, the
# parameters are polar coordinates, and Newton's method from another direction ends at the pole.
NEAR = 0.25
# The least distance from the pole, in the parameter, at which a search starts.
LEAST = 1e-9
# The distance from the pole, in the parameter, of places beside it.
BESIDE = 1e-4
# Poles that lie closer together than this part of the atlas's size are one.
SAME = 1e-9


class Poles:
    """The poles of an atlas, and the directions in which its patches leave them.

    Parameters
    ----------
    coefficients : ndarray
        The patches' coefficients of powers.
    collapsed : ndarray of bool, shape (patches, 4)
    size : float
        The atlas's size.
    """

    def __init__(self, coefficients: Array, collapsed: Bools, size: float) -> None:
        self.coefficients, self.collapsed = coefficients, collapsed
        patch, side = np.nonzero(collapsed)
        self.pole = np.full(collapsed.shape, -1, dtype=np.int64)
        self.patch, self.side = patch, side
        self.first = np.empty(0, dtype=np.int64)
        if not len(patch):
            return
        along = np.linspace(0.0, 1.0, DIRECTIONS)
        x = np.empty((len(patch), DIRECTIONS, 2))
        x[np.arange(len(patch)), :, AXIS[side]] = VALUE[side][:, None]
        x[np.arange(len(patch)), :, 1 - AXIS[side]] = along
        s = jets(coefficients[patch.repeat(DIRECTIONS)], x.reshape(-1, 2))
        off = np.where((AXIS[side] == 0).repeat(DIRECTIONS)[:, None], s[:, 1, 0], s[:, 0, 1])
        off *= np.where(VALUE[side] == 0.0, 1.0, -1.0).repeat(DIRECTIONS)[:, None]
        speed = np.linalg.norm(off, axis=1)
        self.speed = np.maximum(speed, np.finfo(np.float64).tiny).reshape(len(patch), DIRECTIONS)
        self.direction = off.reshape(len(patch), DIRECTIONS, 3) / self.speed[..., None]
        self.position = s[:, 0, 0].reshape(len(patch), DIRECTIONS, 3)[:, 0]
        # Each side is numbered by the first of those at the same place.
        near = scipy.spatial.KDTree(self.position).query_ball_point(self.position, SAME * size)
        self.first = np.array([min(rows) for rows in near])
        self.pole[patch, side] = self.first

    def beside(self) -> tuple[Ints, Ints, Array]:
        """Return places round the poles: the row of the collapsed side, the patch, and (u, v)."""
        row = np.arange(len(self.patch)).repeat(DIRECTIONS)
        patch, side = self.patch[row], self.side[row]
        x = np.empty((len(row), 2))
        value = VALUE[side]
        x[np.arange(len(row)), AXIS[side]] = np.where(value == 0.0, BESIDE, 1.0 - BESIDE)
        x[np.arange(len(row)), 1 - AXIS[side]] = np.tile(
            np.linspace(0.0, 1.0, DIRECTIONS), len(self.patch)
        )
        return row, patch, x

    def starts(self, positions: Array, patch: Ints, x: Array) -> tuple[Ints, Ints, Array]:
        """Return better starts for the feet of positions that were found near poles.

        They lie in the direction, among those in which the surface leaves the pole, that leads
        closest to the position.

        Parameters
        ----------
        positions : ndarray, shape (k, 3)
        patch : ndarray of int, shape (k,)
        x : ndarray, shape (k, 2)
            The feet that were found.

        Returns
        -------
        row : ndarray of int, shape (m,)
            The positions that have such a start.
        patch : ndarray of int, shape (m,)
        x : ndarray, shape (m, 2)
        """
        near = self.collapsed[patch] & (np.abs(x[:, AXIS] - VALUE) < NEAR)
        row, side = np.nonzero(near)
        to_patch, start = np.empty(len(row), dtype=np.int64), np.empty((len(row), 2))
        found = self.pole[patch[row], side]
        for pole in np.unique(found):
            rows = np.flatnonzero(found == pole)
            sides = np.flatnonzero(self.first == pole)
            offset = positions[row[rows]] - self.position[pole]
            way = np.einsum("sdc,kc->ksd", self.direction[sides], offset)
            best, along = np.divmod(way.reshape(len(rows), -1).argmax(axis=1), DIRECTIONS)
            chosen = sides[best]
            step = way[np.arange(len(rows)), best, along] / self.speed[chosen, along]
            step = np.clip(step, LEAST, NEAR)
            value = VALUE[self.side[chosen]]
            to_patch[rows] = self.patch[chosen]
            start[rows, AXIS[self.side[chosen]]] = np.where(value == 0.0, step, 1.0 - step)
            start[rows, 1 - AXIS[self.side[chosen]]] = along / (DIRECTIONS - 1)
        return row, to_patch, start
