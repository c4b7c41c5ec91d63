"""A geodesic over several patches whose ends may move along edges, which it joins tangentially.

Its length is stationary in all that is free. Where it joins an edge that holds it from there on,
that says nothing of the place (see `free_piece`); the tangency there is the equation.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.seams import EDGES
from bodymeasure.geodesic.across.pieces.problem import RouteProblem
from bodymeasure.geodesic.across.pieces.refine import RefinedPath, measured
from bodymeasure.geodesic.numerics.box_newton import BoxMinimum
from bodymeasure.geodesic.numerics.damped_newton import damped_newton


def solve_leg(problem: RouteProblem, guess: Array) -> RefinedPath | None:
    """The geodesic along a route that is tangential to edges where its ends slide along them.

    Parameters
    ----------
    problem : RouteProblem
    guess : ndarray, shape (unknowns,)

    Returns
    -------
    RefinedPath or None
        Its ends then in place. It may leave its patches. None if Newton's method failed.
    """
    system = _System(problem)
    solved = damped_newton(system.at, system.direction, guess)
    return None if solved is None else _in_place(problem, *solved)


@dataclass(frozen=True)
class _System:
    problem: RouteProblem

    @cached_property
    def _tangencies(self) -> list[tuple[int, Array, float]]:
        """The row of each end that slides, its equation's factors, and what is added."""
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
            # What no unknown moves: told by the values where all of them are zero.
            fixed = problem.values(np.zeros(problem.count))[end]
            result.append((unknowns[end], factors, float((by_value * fixed).sum())))
        return result

    def at(self, unknowns: Array) -> tuple[Array, Array]:
        """The equations' left sides and their derivatives."""
        here = self.problem.expand(unknowns)
        count = self.problem.count
        matrix = np.zeros((count, count))
        for row in range(min(len(here.bands), count)):
            below = np.arange(count - row)
            matrix[below + row, below] = matrix[below, below + row] = here.bands[row, : count - row]
        residual = here.gradient.copy()
        for row, factors, added in self._tangencies:
            residual[row], matrix[row] = factors @ unknowns + added, factors
        idle = self.problem.idle
        residual[idle], matrix[idle] = 0.0, np.eye(count)[idle]
        return residual, matrix

    def direction(self, residual: Array, matrix: Array) -> Array:
        """Newton's direction; NaN if the system is singular."""
        try:
            return np.asarray(np.linalg.solve(matrix, -residual))
        except np.linalg.LinAlgError:
            return np.full_like(residual, np.nan)


def _in_place(problem: RouteProblem, unknowns: Array, iterations: int) -> RefinedPath:
    """The path with its ends fixed where they have come to."""
    fixed = RouteProblem(problem.atlas, problem.at(unknowns), problem.space, problem.size)
    here = fixed.expand(unknowns)
    held = np.zeros(fixed.count, bool)
    return measured(fixed, BoxMinimum(unknowns, here.value, held, True, iterations, here.bands))
