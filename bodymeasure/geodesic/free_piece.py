"""A geodesic whose ends may slide along edges of the patch."""

from __future__ import annotations

from dataclasses import dataclass

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
    count = space.size + 1
    ends = space.matrices(np.array([0.0, 1.0]))[1]
    unknown = np.zeros((2, count), bool)
    unknown[:, 1:-1] = True
    for node, slide in zip((0, -1), slides, strict=True):
        if slide is not None:
            unknown[1 - slide.axis, node] = True
    columns = np.flatnonzero(unknown)
    values = guess.copy()
    for node, slide in zip((0, -1), slides, strict=True):
        if slide is not None:
            values[slide.axis, node] = slide.value

    def system(values: _Array) -> tuple[_Array, _Array]:
        residual, jacobian = residual_and_jacobian(surface, space, values[None], ends=True)
        rows = [residual.ravel()]
        matrix = [jacobian.reshape(-1, 2 * count)]
        for row, slide in zip(ends, slides, strict=True):
            if slide is not None:
                tangency = np.zeros((2, count))
                tangency[slide.axis] = row
                rows.append(np.array([tangency.ravel() @ values.ravel()]))
                matrix.append(tangency.reshape(1, -1))
        return np.concatenate(rows), np.concatenate(matrix)[:, columns]

    span = np.ptp(values, axis=1).max()
    residual, jacobian = system(values)
    for _ in range(MAX_ITERATIONS):
        try:
            direction = np.zeros(2 * count)
            direction[columns] = np.linalg.solve(jacobian, -residual)
        except np.linalg.LinAlgError:
            return None
        size = np.abs(direction).max()
        if not np.isfinite(size):
            return None
        moved = direction.reshape(2, count)
        if size < LAST_STEP * span:
            return np.asarray(values + moved)
        step = min(1.0, LONGEST_STEP / size)
        while True:
            trial = values + step * moved
            new_residual, new_jacobian = system(trial)
            if np.linalg.norm(new_residual) < np.linalg.norm(residual):
                break
            step /= 2.0
            if step < SMALLEST_STEP:
                return None
        values, residual, jacobian = trial, new_residual, new_jacobian
    return None
