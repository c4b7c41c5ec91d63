"""A geodesic whose ends may slide along edges of the patch."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from bodymeasure.geodesic.equations import residual_and_jacobian
from bodymeasure.geodesic.newton import LAST_STEP, LONGEST_STEP, MAX_ITERATIONS, SMALLEST_STEP
from bodymeasure.geodesic.surface import Surface
from bodymeasure.geodesic.trial_space import TrialSpace

_Array = NDArray[np.float64]


@dataclass(frozen=True)
class Contact:
    """One edge of the patch, as a shortest path touches it.

    Parameters
    ----------
    axis : int
        The coordinate that is fixed on the edge: 0 for u, 1 for v.
    value : float
        0 or 1.
    """

    axis: int
    value: float

    @property
    def name(self) -> str:
        """The edge's name, as in `bodymeasure.atlas.EDGES`."""
        return f"{'uv'[self.axis]} = {self.value:g}"


def solve_free_piece(
    surface: Surface,
    space: TrialSpace,
    guess: _Array,
    slides: tuple[Contact | None, Contact | None],
) -> _Array | None:
    """A geodesic between two ends, each fixed or sliding along an edge that it meets tangentially.

    Where a shortest path in the patch joins its boundary, it does so tangentially: the fixed
    coordinate's derivative is zero there. That is the equation for the place on the edge. (That
    the length is stationary in it says nothing new: its derivative is cos(angle) - 1.)

    Parameters
    ----------
    surface : Surface
        Of one problem.
    space : TrialSpace
        With n + 1 nodes.
    guess : ndarray, shape (2, n + 1)
    slides : pair of Contact or None
        On which edge the first and the last point slide; None for a fixed end.

    Returns
    -------
    ndarray, shape (2, n + 1), or None
        u and v at the nodes; None if Newton's method failed.
    """
    problem = _Sliding(surface, space, slides)
    values = guess.copy()
    for node, slide in zip((0, -1), slides, strict=True):
        if slide is not None:
            values[slide.axis, node] = slide.value
    span = np.ptp(values, axis=1).max()
    residual, jacobian = problem.system(values)
    for _ in range(MAX_ITERATIONS):
        direction = problem.direction(residual, jacobian)
        size = np.abs(direction).max()
        if not np.isfinite(size):
            return None
        if size < LAST_STEP * span:
            return np.asarray(values + direction)
        step = min(1.0, LONGEST_STEP / size)
        norm = np.linalg.norm(residual)
        while True:
            trial = values + step * direction
            residual, jacobian = problem.system(trial)
            if np.linalg.norm(residual) < norm:
                break
            step /= 2.0
            if step < SMALLEST_STEP:
                return None
        values = trial
    return None


@dataclass(frozen=True)
class _Sliding:
    """The collocation equations, and a tangency for each end that slides."""

    surface: Surface
    space: TrialSpace
    slides: tuple[Contact | None, Contact | None]

    @cached_property
    def unknowns(self) -> NDArray[np.int64]:
        """Which of u and v at the nodes, one after the other, are to be found."""
        unknown = np.zeros((2, self.space.size + 1), bool)
        unknown[:, 1:-1] = True
        for node, slide in zip((0, -1), self.slides, strict=True):
            if slide is not None:
                unknown[1 - slide.axis, node] = True
        return np.flatnonzero(unknown)

    @cached_property
    def tangencies(self) -> _Array:
        """One row an end that slides: the derivative of the coordinate that its edge fixes."""
        slopes = self.space.matrices(np.array([0.0, 1.0]))[1]
        rows = np.zeros((2, 2, self.space.size + 1))
        for row, slope, slide in zip(rows, slopes, self.slides, strict=True):
            if slide is not None:
                row[slide.axis] = slope
        sliding = [slide is not None for slide in self.slides]
        return rows.reshape(2, -1)[sliding]

    def system(self, values: _Array) -> tuple[_Array, _Array]:
        """The equations' left sides, and their derivatives by the unknowns."""
        residual, jacobian = residual_and_jacobian(
            self.surface, self.space, values[None], ends=True
        )
        matrix = np.concatenate([jacobian.reshape(residual.size, -1), self.tangencies])
        sides = np.concatenate([residual.ravel(), self.tangencies @ values.ravel()])
        return sides, matrix[:, self.unknowns]

    def direction(self, residual: _Array, jacobian: _Array) -> _Array:
        """Newton's direction, of the shape of the values; NaN if the system is singular."""
        direction = np.zeros(2 * (self.space.size + 1))
        try:
            direction[self.unknowns] = np.linalg.solve(jacobian, -residual)
        except np.linalg.LinAlgError:
            direction[:] = np.nan
        return direction.reshape(2, -1)
