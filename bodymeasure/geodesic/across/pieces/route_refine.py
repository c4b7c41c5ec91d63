"""Refinement: the shortest path along a route, and how long its pieces are."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES, sides_of
from bodymeasure.geodesic.across.pieces.route_length import RouteProblem
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.numerics.box_newton import BoxMinimum, minimize_in_box
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

# Pieces this near to a corner, in (u, v), are tried in the corner itself.
IN_CORNER = 1e-3


@dataclass(frozen=True, eq=False)
class Refined:
    """The shortest path along one route, as far as its trial space goes.

    Parameters
    ----------
    problem : RouteProblem
    minimum : BoxMinimum
    values : ndarray, shape (pieces, 2, n + 1)
        (u, v) at the nodes of all pieces.
    lengths : ndarray, shape (pieces,)
        Of the pieces, in parts of the problem's size.
    """

    problem: RouteProblem
    minimum: BoxMinimum
    values: Array
    lengths: Array

    @property
    def length(self) -> float:
        """Of the whole path, in the atlas's unit."""
        return float(self.lengths.sum()) * self.problem.size

    @property
    def route(self) -> Route:
        """With its crossings where the path has them."""
        return self.problem.at(self.minimum.unknowns)

    @property
    def held_nodes(self) -> NDArray[np.bool_]:
        """Inner nodes that an edge of their patch holds, by coordinate: (pieces, 2, n - 1)."""
        rows = self.problem.joints[:-1, None] + 1 + np.arange(self.problem.inner)
        held = self.minimum.held[rows].reshape(len(rows), 2, -1)
        # A piece that stays in a corner runs along no edge.
        return np.asarray(held & (self.lengths > 0.0)[:, None, None])


def refine(
    atlas: Atlas, route: Route, space: int | TrialSpace, size: float, before: Refined | None = None
) -> Refined:
    """The shortest path along a route.

    Parameters
    ----------
    atlas : Atlas
    route : Route
    space : int or TrialSpace
        Of the path on each patch, or the degree of polynomials, at least 2.
    size : float
        About the length of the path.
    before : Refined, optional
        A path along the same route to start from; straight lines in (u, v) if not given.
    """
    space = polynomial_space(space) if isinstance(space, int) else space
    slides = _pole_side(atlas, route.start), _pole_side(atlas, route.end)
    problem = RouteProblem(atlas, route, space, size, slides)
    start = problem.straight() if before is None else resampled(before, problem)
    minimum = minimize_in_box(problem.expand, start, problem.idle)
    refined = measured(problem, minimum)
    corners = _corners(refined)
    if not corners.any():
        return refined
    place = np.where(corners, np.round(minimum.unknowns), minimum.unknowns)
    pinned = minimize_in_box(problem.expand, place, problem.idle | corners)
    through = measured(problem, replace(pinned, held=pinned.held | corners))
    return through if through.length < refined.length else refined


def _pole_side(atlas: Atlas, place: AtlasPoint) -> int | None:
    """The collapsed side on which a path ends: it leaves the point there in any direction."""
    sides = sides_of(atlas.index[[place.patch]])[0]
    for side, (edge, row) in enumerate(zip(EDGES, sides, strict=True)):
        if place[1 + edge.fixed_axis] == edge.fixed_value and (row == row[0]).all():
            return side
    return None


def measured(problem: RouteProblem, minimum: BoxMinimum) -> Refined:
    """A path, and how long its pieces are."""
    values = problem.values(minimum.unknowns)
    return Refined(problem, minimum, values, piece_lengths(problem.surface, problem.space, values))


def _corners(refined: Refined) -> NDArray[np.bool_]:
    """The unknowns of pieces of hardly any length that seem to lie in a corner of their patch.

    What makes the length smooth there (`route_length.EPSILON`) keeps them a little away from it.
    """
    problem, values = refined.problem, refined.values
    result = np.zeros(problem.count, bool)
    nearest = np.round(values)
    inside = (np.abs(values - nearest) < IN_CORNER).all(axis=(1, 2))
    same = (nearest == nearest[:, :, :1]).all(axis=(1, 2))
    for piece in np.flatnonzero(inside & same):
        if 0 < piece < problem.pieces - 1:
            result[problem.joints[piece] : problem.joints[piece + 1] + 1] = True
    return result


def resampled(before: Refined, problem: RouteProblem) -> Array:
    """A path's unknowns in another space."""
    unknowns = problem.straight()
    place = before.problem.space.functions.values(problem.space.nodes[1:-1])
    inner = np.clip(before.values @ place.T, 0.0, 1.0)
    rows = problem.joints[:-1, None] + 1 + np.arange(problem.inner)
    unknowns[rows] = inner.reshape(len(rows), -1)
    for row, side, values in (
        (0, problem.slides[0], before.values[0, :, 0]),
        (-1, problem.slides[1], before.values[-1, :, -1]),
    ):
        if side is not None:
            unknowns[row] = values[1 - EDGES[side].fixed_axis]
    return unknowns


def piece_lengths(surface: Surface, space: TrialSpace, values: Array) -> Array:
    """Lengths of paths with nodal values (pieces, 2, n + 1), one on each surface."""
    place, slopes, _ = space.at_quadrature
    du, dv = ((values - values[:, :, :1]) @ slopes.T).transpose(1, 0, 2)
    _, s_u, s_v = surface.jet((values @ place.T).transpose(0, 2, 1), 1)
    speed = np.linalg.norm(s_u * du + s_v * dv, axis=0)
    return np.asarray(speed @ space.quadrature.weights)
