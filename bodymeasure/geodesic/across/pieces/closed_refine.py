"""Refinement of loops: the shortest one along a closed route, as far as a trial space goes."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.geodesic.across.pieces.closed_length import ClosedProblem
from bodymeasure.geodesic.across.pieces.route_refine import piece_lengths
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.numerics.box_newton import BoxMinimum, minimize_in_box
from bodymeasure.geodesic.spaces.polynomials import polynomial_space


@dataclass(frozen=True, eq=False)
class RefinedLoop:
    """A loop along a route.

    Parameters
    ----------
    problem : ClosedProblem
    minimum : BoxMinimum
    values : ndarray, shape (pieces, 2, n + 1)
        (u, v) at the nodes of all pieces.
    lengths : ndarray, shape (pieces,)
        Of the pieces, in parts of the problem's size.
    """

    problem: ClosedProblem
    minimum: BoxMinimum
    values: Array
    lengths: Array

    @property
    def length(self) -> float:
        """Of the whole loop, in the atlas's unit."""
        return float(self.lengths.sum()) * self.problem.size

    @property
    def route(self) -> Route:
        """With its crossings where the loop has them."""
        return self.problem.at(self.minimum.unknowns)

    @property
    def held_nodes(self) -> NDArray[np.bool_]:
        """Inner nodes that an edge of their patch holds, by coordinate: (pieces, 2, n - 1)."""
        held = self.minimum.held[self.problem.rows[:, 1:-1]]
        return np.asarray(held.reshape(self.problem.pieces, 2, -1))

    @property
    def held_joints(self) -> NDArray[np.bool_]:
        """Crossings that an end of their seam holds, shape (pieces,)."""
        return self.minimum.held[self.problem.joints]


def refine_loop(
    atlas: Atlas, route: Route, degree: int, size: float, before: RefinedLoop | None = None
) -> RefinedLoop:
    """The shortest loop along a route.

    Parameters
    ----------
    atlas : Atlas
    route : Route
    degree : int
        Of the polynomial on each patch, at least 2.
    size : float
        About the length of the loop.
    before : RefinedLoop, optional
        A loop along the same route to start from; straight lines in (u, v) if not given.
    """
    problem = ClosedProblem(atlas, route, polynomial_space(degree), size)
    start = problem.straight()
    if before is not None:
        place = before.problem.space.functions.values(problem.space.nodes[1:-1])
        start = problem.unknowns(np.array(before.route.along), before.values @ place.T)
    minimum = minimize_in_box(problem.expand, start, np.zeros(problem.count, bool))
    values = problem.values(minimum.unknowns)
    return RefinedLoop(
        problem, minimum, values, piece_lengths(problem.surface, problem.space, values)
    )
