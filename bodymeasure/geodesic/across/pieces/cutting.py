r"""Paths whose pieces are cut where a single polynomial on each patch does not serve.

A polynomial has to follow the sharpest bend of its piece with the whole of it, so that on a patch
with a sharp fold, as below a breast, its degree hardly helps. Pieces that make most of the error
are cut instead, at lines on which u or v is constant; where the path crosses such a line is an
unknown, as on a seam. The parts are short beside a fold and long elsewhere.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.topology.neighbors import Crossing
from bodymeasure.geodesic.across.pieces.budget import Budget
from bodymeasure.geodesic.across.pieces.error import joint_jumps, piece_errors, route_length
from bodymeasure.geodesic.across.pieces.problem import RouteProblem
from bodymeasure.geodesic.across.pieces.refine import RefinedPath, measured, sharpened
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.spaces.polynomials import polynomial_space

# The degree of the polynomial on each part.
DEGREE = 12
# The most parts, and the most times that a path is cut.
MOST_PARTS, MOST_ROUNDS = 80, 12
# Only pieces with more than this part of the largest error are cut at a time.
WORST = 1e-3
# If the joints make most of it, those pieces are cut that are beside one with this part of the
# largest angle.
SHARP = 0.1
# No cut is nearer to the ends of a piece than this part of it.
NEAREST = 0.15


def cut_until_known(
    atlas: Atlas, refined: RefinedPath, tolerance: float, budget: Budget
) -> tuple[RefinedPath, Length]:
    """Return a path with its pieces cut until its length is known, or the budget is used up.

    In that case it is the one of those with the least error.

    Parameters
    ----------
    atlas : Atlas
    refined : RefinedPath
        A path with two ends.
    tolerance : float
        The relative error that is wanted.
    budget : Budget
    """
    path = _resolved(atlas, refined, [()] * len(refined.lengths))
    budget.spend(path)
    found = [(path, route_length(path)[0])]
    for _ in range(MOST_ROUNDS):
        path, length = found[-1]
        errors = piece_errors(path)
        if length.error <= tolerance * length.raw or len(errors) >= MOST_PARTS:
            break
        if budget.is_overdrawn():
            # The length may be good enough.
            break
        least = max(tolerance / (2.0 * len(errors)), WORST * _largest(errors))
        worst = errors > least
        if not worst.any():
            # What is left comes from the joints.
            jumps = joint_jumps(path)
            joints = np.flatnonzero(jumps >= SHARP * jumps.max(initial=0.0))
            worst[joints] = worst[joints + 1] = True
        cuts = [(_middle(path, piece),) if worst[piece] else () for piece in range(len(errors))]
        path = _resolved(atlas, path, cuts)
        budget.spend(path)
        found.append((path, route_length(path)[0]))
    return min(found, key=lambda one: float(one[1].error))


def _largest(errors: Array) -> float:
    return float(errors[np.isfinite(errors)].max(initial=0.0))


def _middle(refined: RefinedPath, piece: int) -> float:
    """Return the parameter that halves the bend of a piece, but not too near to its ends."""
    space = refined.problem.space
    place, slopes, bends = space.at_quadrature
    values = refined.values[piece]
    (u, v), (du, dv), (ddu, ddv) = (values @ rows.T for rows in (place, slopes, bends))
    surface = refined.problem.surface.take(np.array([piece]))
    jet = surface.jet(np.stack([u, v], axis=-1)[None], 2)
    s_u, s_v, s_uu, s_uv, s_vv = (term[..., 0, :] for term in jet[1:])
    acceleration = s_u * ddu + s_v * ddv + s_uu * du**2 + 2.0 * s_uv * du * dv + s_vv * dv**2
    bend = np.cumsum(np.linalg.norm(acceleration, axis=0) * space.quadrature.weights)
    middle = 0.5
    if np.isfinite(bend[-1]) and bend[-1] > 0.0:
        middle = float(np.interp(0.5 * bend[-1], bend, space.quadrature.points))
    return min(max(middle, NEAREST), 1.0 - NEAREST)


def _resolved(atlas: Atlas, before: RefinedPath, cuts: Sequence[tuple[float, ...]]) -> RefinedPath:
    """Return the shortest path near another one, with its pieces cut at parameters."""
    route, old = before.route, before.problem.space
    assert route.ends is not None
    space = polynomial_space(DEGREE)
    crossings: list[Crossing] = []
    along: list[float] = []
    inner: list[Array] = []
    for piece, places in enumerate(cuts):
        if piece:
            crossings.append(route.crossings[piece - 1])
            along.append(route.along[piece - 1])
        values = before.values[piece]
        bounds = (0.0, *places, 1.0)
        for place in places:
            (u, v), (du, dv) = old.matrices(place)[:2, 0] @ values.T
            axis = _steeper(before, piece, np.array([u, v]), (float(du), float(dv)))
            line, cross = (float(u), float(v))[:: 1 if axis == 0 else -1]
            crossings.append(Crossing(-1, 2 * axis, 2 * axis, route.patches[piece], False, line))
            along.append(min(max(cross, 0.0), 1.0))
        for first, last in pairwise(bounds):
            times = first + (last - first) * space.nodes[1:-1]
            inner.append(values @ old.functions.values(times).T)
    cut = Route(route.ends, tuple(crossings), tuple(along))
    problem = RouteProblem(atlas, cut, space, before.problem.size, before.problem.slides)
    guess = problem.unknowns(np.array(inner))
    minimum = problem.minimized(guess)
    return sharpened(measured(problem, minimum), problem.idle)


def _steeper(refined: RefinedPath, piece: int, place: Array, velocity: tuple[float, float]) -> int:
    """Return the parameter (0: u, 1: v) in which a piece moves farther over the surface."""
    surface = refined.problem.surface.take(np.array([piece]))
    _, s_u, s_v = surface.jet(place[None, None], 1)
    du, dv = velocity
    return int(abs(dv) * np.linalg.norm(s_v) > abs(du) * np.linalg.norm(s_u))
