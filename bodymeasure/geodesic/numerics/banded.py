"""Symmetric banded matrices, one or many, and the minima of quadratic models with them in a box.

A matrix is given by its lower bands: ``bands[..., i, j]`` is its entry at (i + j, j). For many
matrices the batch runs along the first axis.
"""

from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.native import box_steps, is_compiled

# The most sets of held unknowns that are tried: nearly always a few are enough, and any step that
# lowers the value is a good one.
MOST_SETS = 20


def banded_product(bands: Array, vectors: Array) -> Array:
    """Return the products of matrices, shape (..., bands, n), with vectors, shape (..., n)."""
    result: Array = bands[..., 0, :] * vectors
    for row in range(1, bands.shape[-2]):
        part = bands[..., row, :-row]
        result[..., row:] += part * vectors[..., :-row]
        result[..., :-row] += part * vectors[..., row:]
    return result


def restricted(bands: Array, free: Bools) -> Array:
    """Return the matrices with the rows and columns of unknowns that are not free made identity."""
    count, size = bands.shape[-2:]
    padded = np.concatenate([free, np.zeros((*free.shape[:-1], count - 1), bool)], axis=-1)
    rows = np.arange(count)[:, None] + np.arange(size)
    result: Array = bands * (free[..., None, :] & padded[..., rows])
    result[..., 0, :][~free] = 1.0
    return result


def solve_free(bands: Array, right: Array, free: Bools) -> Array | None:
    """Solve one system for what is free; the rest of the right side stays.

    Returns
    -------
    ndarray, shape (n,), or None
        None if the matrix is not positive definite in what is free.
    """
    _, solution, failed = scipy.linalg.lapack.dpbsv(restricted(bands, free), right, lower=1)
    return solution if failed == 0 and np.isfinite(solution).all() else None


class BoxModels(NamedTuple):
    """Quadratic models of functions on the box [0, 1]^n, each about a place in the box.

    Parameters
    ----------
    bands : ndarray, shape (models, bands, n)
        The lower bands of the Hessians.
    gradient, place : ndarray, shape (models, n)
    idle : ndarray of bool, shape (models, n)
        Unknowns that stay where they are.
    """

    bands: Array
    gradient: Array
    place: Array
    idle: Bools

    def take(self, rows: Ints) -> "BoxModels":
        """Return some of the models."""
        if len(rows) == len(self.place):
            return self
        return BoxModels(self.bands[rows], self.gradient[rows], self.place[rows], self.idle[rows])

    def steps(self) -> tuple[Array, Bools]:
        """Return the steps to the minima in the box, and which models have one.

        The steps are found by a primal-dual active set: what would leave the box is put on its
        bound, and what is on a bound and not pressed there is let go, until nothing changes (M.
        Hintermueller, K. Ito, K. Kunisch, SIAM J. Optim. 13 (2002) 865-888). A path that comes to
        lie along an edge does so in one step, not point by point.

        Returns
        -------
        step : ndarray, shape (models, n)
        definite : ndarray of bool, shape (models,)
            False where a Hessian is not positive definite in what is free: more damping is called
            for, and the step is zero.
        """
        if is_compiled():
            return box_steps(*self)
        step, definite = np.zeros_like(self.gradient), np.ones(len(self.place), bool)
        # What the gradient presses to its bound stays there: free, it might leave no minimum.
        bound = np.where(self.pressed() | self.idle, self.place, np.nan)
        rows = np.arange(len(self.place))
        for _ in range(MOST_SETS):
            part = self.take(rows)
            step[rows], definite[rows] = part._minimum(bound[rows])
            now = part._next_bounds(bound[rows], step[rows])
            same = (now == bound[rows]) | (np.isnan(now) & np.isnan(bound[rows]))
            bound[rows] = now
            rows = rows[definite[rows] & ~same.all(axis=1)]
            if len(rows) == 0:
                break
        step[~definite] = 0.0
        return step, definite

    def pressed(self) -> Bools:
        """Return which unknowns are on a bound and pressed outwards by the gradient."""
        outwards = np.where(self.place < 0.5, self.gradient, -self.gradient) > 0.0
        return np.asarray(outwards & ((self.place == 0.0) | (self.place == 1.0)))

    def decrease(self, step: Array) -> Array:
        """Return by how much steps lower the models' values, shape (models,)."""
        slope = self.gradient + 0.5 * banded_product(self.bands, step)
        return np.asarray(-(slope * step).sum(axis=1))

    def _minimum(self, bound: Array) -> tuple[Array, Bools]:
        """The minima where unknowns with a bound are held on it, and those without (NaN) free."""
        free = np.isnan(bound)
        held = np.where(free, 0.0, bound - self.place)
        right = np.where(free, -self.gradient - banded_product(self.bands, held), held)
        matrices = restricted(self.bands, free)
        step, definite = np.empty_like(right), np.empty(len(right), bool)
        solve = scipy.linalg.lapack.dpbsv
        for number in range(len(right)):
            _, step[number], failed = solve(matrices[number], right[number], lower=1)
            definite[number] = failed == 0
        return step, definite & np.isfinite(step).all(axis=1)

    def _next_bounds(self, bound: Array, step: Array) -> Array:
        """The bounds of what is pressed to one, or would leave the box; NaN for the rest."""
        slope, there = self.gradient + banded_product(self.bands, step), self.place + step
        # A product with NaN compares as false.
        pressed = ((1.0 - 2.0 * bound) * slope > 0.0) | self.idle
        outside = np.isnan(bound) & ((there < 0.0) | (there > 1.0))
        nearest = np.where(there < 0.5, 0.0, 1.0)
        return np.where(pressed, bound, np.where(outside, nearest, np.nan))
