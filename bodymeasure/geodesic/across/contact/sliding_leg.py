"""A geodesic over several patches whose ends may move along edges, which it joins tangentially.

The length of such a leg is stationary in all its unknowns. That does not determine the place where
it joins an edge that holds the path from there on (see `geodesic.contact.free_leg`), so that the
tangency at the edge takes the place of that equation.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas.seams import EDGES
from bodymeasure.geodesic.across.pieces.budget import Budget
from bodymeasure.geodesic.across.pieces.problem import RouteProblem
from bodymeasure.geodesic.across.pieces.refine import RefinedPath, measured
from bodymeasure.geodesic.numerics.box_newton import BoxMinimum
from bodymeasure.geodesic.numerics.damped_newton import damped_newton


def solve_leg(problem: RouteProblem, guess: Array, budget: Budget) -> RefinedPath | None:
    """Return the geodesic along a route that is tangential to the edges along which its ends slide.

    Parameters
    ----------
    problem : RouteProblem
    guess : ndarray, shape (unknowns,)
    budget : Budget
        The work is counted.

    Returns
    -------
    RefinedPath or None
        The path with its ends fixed, which may leave its patches. None if Newton's method failed.
    """
    system = _System(problem, budget)
    solved = damped_newton(system.at, system.direction, guess)
    return None if solved is None else _in_place(problem, *solved)


@dataclass(frozen=True)
class _System:
    problem: RouteProblem
    budget: Budget

    @cached_property
    def _tangencies(self) -> list[tuple[int, Array, float]]:
        """The row of each end that slides, with the factors and the constant of its equation."""
        problem, result = self.problem, []
        slopes = problem.space.matrices([0.0, 1.0])[1]
        nodes = len(problem.space.nodes)
        for end, side in zip((0, -1), problem.slides, strict=True):
            if side is None:
                continue
            by_value = np.zeros((2, nodes))
            by_value[EDGES[side].fixed_axis] = slopes[end]
            factors, unknowns = np.zeros(problem.count), problem.rows[end]
            np.add.at(
                factors,
                unknowns,
                by_value.ravel()[problem.local[end]] * problem.sign[end],
            )
            # The constant comes from the values that no unknown moves.
            fixed = problem.values(np.zeros(problem.count))[end]
            result.append((unknowns[end], factors, float((by_value * fixed).sum())))
        return result

    def at(self, unknowns: Array) -> tuple[Array, Array]:
        """Return the residuals of the equations and their derivatives, by diagonals.

        Entry (b + i - j, j) is the derivative of equation i by the unknown j, where b is the number
        of diagonals on either side: the form of `scipy.linalg.solve_banded`.
        """
        self.budget.spend_steps(self.problem, 1)
        here = self.problem.expand(unknowns)
        beside, count = min(len(here.bands), self.problem.count) - 1, self.problem.count
        diagonals = np.zeros((2 * beside + 1, count))
        for row in range(beside + 1):
            part = here.bands[row, : count - row]
            diagonals[beside + row, : count - row] = part
            diagonals[beside - row, row:] = part
        residual = here.gradient.copy()
        for row, factors, added in self._tangencies:
            residual[row] = factors @ unknowns + added
            _set_row(diagonals, row, factors)
        for row in np.flatnonzero(self.problem.idle).tolist():
            residual[row] = 0.0
            _set_row(diagonals, row, np.arange(count) == row)
        return residual, diagonals

    def direction(self, residual: Array, diagonals: Array) -> Array:
        """Return Newton's direction; NaN if the system is singular."""
        beside = len(diagonals) // 2
        try:
            way = scipy.linalg.solve_banded(
                (beside, beside), diagonals, -residual, check_finite=False
            )
        except np.linalg.LinAlgError:
            return np.full_like(residual, np.nan)
        return np.asarray(way)


def _set_row(diagonals: Array, row: int, values: Array | Bools) -> None:
    """Replace a row of a matrix that is kept by its diagonals."""
    beside = len(diagonals) // 2
    column = np.arange(max(row - beside, 0), min(row + beside + 1, diagonals.shape[1]))
    diagonals[beside + row - column, column] = values[column]


def _in_place(problem: RouteProblem, unknowns: Array, iterations: int) -> RefinedPath:
    """The path with its ends fixed where they are."""
    route, epsilon = problem.at(unknowns), problem.epsilon
    fixed = RouteProblem(problem.atlas, route, problem.space, problem.size, epsilon=epsilon)
    here = fixed.expand(unknowns)
    held = np.zeros(fixed.count, bool)
    return measured(fixed, BoxMinimum(unknowns, here.value, held, True, iterations, here.bands))
