"""Refinement: the shortest path or loop along a route, as far as a trial space goes."""

from copy import copy
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.geodesic.across.pieces.problem import RouteProblem, Slides
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.routes.topology import topology
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.lengths.measure import measure_length
from bodymeasure.geodesic.numerics.box_newton import FIRST, NEAR, BoxMinimum
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.spaces.trial_space import TrialSpace

# A piece this near to a corner, in (u, v), is tried in the corner itself.
IN_CORNER = 1e-3
# What smooths the length does nothing to pieces longer than this many times its root: such a piece
# counts for a part of 5e-5 less than its length.
SMOOTHED = 100.0
# The length that smoothing may add to a tiny piece is multiplied by this before it is relied on.
SMOOTHING_SAFETY = 2.0
# The factor by which its root is made smaller at a time, and where that ends: the parameters of
# shorter pieces have hardly a digit.
SHARPER, LEAST_EPSILON = 0.01, 1e-26


@dataclass(frozen=True, eq=False)
class RefinedPath:
    """A path or loop along a route.

    Parameters
    ----------
    problem : RouteProblem
    minimum : BoxMinimum
    route : Route
        The route, with its crossings where the path has them.
    values : ndarray, shape (pieces, 2, n + 1)
        (u, v) at the nodes of all pieces.
    by_piece : Length
        The length of each piece, with its ends fixed, as a part of the problem's size.
    steps : int
        Newton's steps in all.
    """

    problem: RouteProblem
    minimum: BoxMinimum
    route: Route
    values: Array
    by_piece: Length
    steps: int

    @property
    def length(self) -> float:
        """The length of the whole path, in the atlas's unit."""
        return float(self.lengths.sum()) * self.problem.size

    @property
    def lengths(self) -> Array:
        """The length of each piece, as a part of the problem's size: (pieces,)."""
        return self.by_piece.raw

    @cached_property
    def at_ends(self) -> Array:
        """The jets of the first order where each piece begins and ends, (3, 3, pieces, 2)."""
        ends = self.values[:, :, [0, -1]].transpose(0, 2, 1)
        return self.problem.surface.jet(ends, 1)

    @property
    def smoothed(self) -> Bools:
        """The pieces that are so short that they count for less than their length: (pieces,)."""
        most = SMOOTHED * np.sqrt(self.problem.epsilon)
        return np.asarray((self.lengths > 0.0) & (self.lengths < most))

    @cached_property
    def held_nodes(self) -> Bools:
        """Inner nodes that an edge of their patch holds, by coordinate: (pieces, 2, n - 1)."""
        held = self.minimum.held[self.problem.rows[:, 1:-1]].reshape(len(self.lengths), 2, -1)
        # A piece that stays in a corner runs along no edge.
        return np.asarray(held & (self.lengths > 0.0)[:, None, None])


def refine(
    atlas: Atlas,
    route: Route,
    space: int | TrialSpace,
    size: float,
    before: RefinedPath | None = None,
    *,
    sharp: bool = True,
    most: float = np.inf,
) -> RefinedPath:
    """Return the shortest path or loop along a route.

    Parameters
    ----------
    atlas : Atlas
    route : Route
    space : int or TrialSpace
        The trial space on each patch, or the degree of polynomials, at least 2.
    size : float
        About the length of the path.
    before : RefinedPath, optional
        A path with this very route to start from; straight lines in (u, v) if not given.
    sharp : bool
        Whether lengths are to be exact: tiny pieces count with theirs, and no points of quadrature
        are saved. It takes longer.
    most : float
        What is longer than this, in the atlas's unit, need not be exact.
    """
    space = polynomial_space(space) if isinstance(space, int) else space
    space = space if sharp else _with_fewer_points(space)
    slides: Slides = (None, None)
    if route.ends is not None:
        # A path may leave a pole in any direction.
        start, end = map(topology(atlas).neighbors.pole_side, route.ends)
        slides = start, end
    problem = RouteProblem(atlas, route, space, size, slides)
    guess = problem.unknowns() if before is None else resampled(before, problem)
    minimum = problem.minimized(guess, damping=FIRST if before is None else NEAR)
    refined = measured(problem, minimum)
    if not sharp:
        return refined
    corners = _corners(refined)
    if not corners.any():
        return sharpened(refined, problem.idle, most)
    place = np.where(corners, np.round(minimum.unknowns), minimum.unknowns)
    pinned = problem.minimized(place, problem.idle | corners)
    through = measured(problem, replace(pinned, held=pinned.held | corners))
    steps = refined.steps + through.steps
    pinned_is_shorter = through.length < refined.length
    if pinned_is_shorter and refined.smoothed[[0, -1]].any():
        # Where an end is right beside the corner, what smooths pieces hides which path is shorter.
        through = sharpened(through, problem.idle | corners, most)
        refined = sharpened(refined, problem.idle, most)
        shorter = through if through.length < refined.length else refined
        return replace(shorter, steps=refined.steps + through.steps)
    if pinned_is_shorter:
        return sharpened(replace(through, steps=steps), problem.idle | corners, most)
    return sharpened(replace(refined, steps=steps), problem.idle, most)


@lru_cache(maxsize=8)
def _with_fewer_points(space: TrialSpace) -> TrialSpace:
    return replace(space, more_points=0)


def sharpened(refined: RefinedPath, idle: Bools, most: float = np.inf) -> RefinedPath:
    """Return a path whose tiny pieces count with their lengths.

    What smooths the length is made smaller, step by step, until it is small beside every piece, or
    the path is expected to stay longer than `most`.
    """
    problem, held = refined.problem, refined.minimum.held
    while problem.epsilon > LEAST_EPSILON and refined.smoothed.any():
        if _shortest_sharpened(refined) > most:
            break
        problem = copy(problem)
        problem.epsilon *= SHARPER**2
        minimum = problem.minimized(refined.minimum.unknowns, idle)
        steps = refined.steps + minimum.iterations
        if not minimum.converged:
            # The estimate of the error knows of pieces that are still smoothed.
            return replace(refined, steps=steps)
        sharper = measured(problem, replace(minimum, held=minimum.held | (held & idle)))
        refined = replace(sharper, steps=steps)
    return refined


def _shortest_sharpened(refined: RefinedPath) -> float:
    """Return a length below which sharpening is not expected to bring a path.

    No tiny piece counts for more than the root of what smooths it beyond its length. What else the
    minimized value has beyond the length may go, too: it is a sum of roots of energies, which
    are longer than their pieces where the speed varies, as at creases. A path that has not come to
    rest has no such bound.
    """
    problem, minimum = refined.problem, refined.minimum
    if not minimum.converged:
        return -np.inf
    length = refined.lengths.sum()
    smoothing = SMOOTHING_SAFETY * np.count_nonzero(refined.smoothed) * np.sqrt(problem.epsilon)
    return float(length - abs(minimum.value - length) - smoothing) * problem.size


def measured(problem: RouteProblem, minimum: BoxMinimum) -> RefinedPath:
    """Return a path with its nodal values and the lengths of its pieces."""
    values = problem.values(minimum.unknowns)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        by_piece = measure_length(problem.surface, problem.space, values)
    route, steps = problem.at(minimum.unknowns), minimum.iterations
    return RefinedPath(problem, minimum, route, values, by_piece, steps)


def _corners(refined: RefinedPath) -> Bools:
    """The unknowns of pieces of hardly any length that seem to lie in a corner of their patch.

    What makes the length smooth there (`problem.EPSILON`) keeps them a little away from it. A loop
    has none: it slides past corners, and the search gives it other routes round them.
    """
    problem, values = refined.problem, refined.values
    result = np.zeros(problem.count, bool)
    if problem.route.closed:
        return result
    nearest = np.round(values)
    inside = (np.abs(values - nearest) < IN_CORNER).all(axis=(1, 2))
    same = (nearest == nearest[:, :, :1]).all(axis=(1, 2))
    # The first and the last piece have an end that is given.
    for piece in np.flatnonzero(inside & same):
        if 0 < piece < len(values) - 1:
            result[problem.rows[piece]] = True
    return result


def resampled(before: RefinedPath, problem: RouteProblem) -> Array:
    """Return the unknowns of a path in another space along its route."""
    return problem.unknowns(before.values @ _at_inner_nodes(before.problem.space, problem.space))


@lru_cache(maxsize=64)
def _at_inner_nodes(space: TrialSpace, other: TrialSpace) -> Array:
    """The map from nodal values in a space to values at another one's inner nodes, transposed."""
    return space.functions.values(other.nodes[1:-1]).T
