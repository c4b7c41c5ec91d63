"""The free legs of a path that edges hold for a part, each in the smallest space that serves."""

from dataclasses import replace

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.seams import EDGES
from bodymeasure.geodesic.across.contact.pattern import FreePart, free_route, nodes_of
from bodymeasure.geodesic.across.contact.sliding_leg import solve_leg
from bodymeasure.geodesic.across.pieces.budget import Budget
from bodymeasure.geodesic.across.pieces.error import route_length
from bodymeasure.geodesic.across.pieces.part import PathPart
from bodymeasure.geodesic.across.pieces.problem import RouteProblem
from bodymeasure.geodesic.across.pieces.refine import RefinedPath
from bodymeasure.geodesic.contact.degrees import DEGREES, OVERSHOOT
from bodymeasure.geodesic.contact.legs import Contact, Ends
from bodymeasure.geodesic.contact.tangency import tangency_errors
from bodymeasure.geodesic.spaces.polynomials import polynomial_space

# Where Newton's method fails at this many degrees, there is no such leg, and it fails at the others
# too, whose systems are far larger.
MOST_FAILURES = 2
# From this degree on errors fall as they will at higher ones.
FIRST_JUDGED = 32


def free_leg(
    atlas: Atlas, polygon: RefinedPath, part: FreePart, tolerance: float, budget: Budget
) -> PathPart | None:
    """Return the geodesic that a free part of a polygon stands for.

    Its error includes that of its joints with edges. None if Newton's method failed, if the leg
    is not accurate enough or leaves its patches, or if the budget has run out.
    """
    size, route = polygon.problem.size, free_route(polygon, part)
    epsilon = polygon.problem.epsilon
    failures, before = 0, (0, np.inf)
    for degree in DEGREES:
        if budget.has_run_out():
            return None
        space = polynomial_space(degree)
        problem = RouteProblem(atlas, route, space, size, part.slides, epsilon)
        leg = solve_leg(problem, _guess(polygon, part, problem), budget)
        if leg is None:
            failures += 1
            if failures == MOST_FAILURES:
                return None
            continue
        length, _ = route_length(leg)
        length = replace(length, error=length.error + size * _joint_error(leg, part))
        if not length.is_known_to(tolerance):
            now = degree, float(length.error)
            if degree >= FIRST_JUDGED and _falls_too_slowly(before, now, tolerance * length.raw):
                return None
            before = now
            continue
        along = np.array(leg.problem.route.along)
        inside = not space.leaves_patch(leg.values, OVERSHOOT).any()
        if inside and ((along >= 0.0) & (along <= 1.0)).all():
            return PathPart.of(leg, length)
    return None


def _falls_too_slowly(before: tuple[int, float], now: tuple[int, float], wanted: Array) -> bool:
    """Return whether an error will be too large at the last degree, too.

    It falls geometrically with the degree where a leg is smooth. Over patches that bend sharply it
    does not, and each degree takes several times as long as the one before.
    """
    degree, error = now
    if not np.isfinite(error):
        return True
    rate = np.log(before[1] / error) / (degree - before[0])
    return not error * np.exp(-rate * (DEGREES[-1] - degree)) <= wanted


def _guess(polygon: RefinedPath, part: FreePart, problem: RouteProblem) -> Array:
    """The unknowns of a leg whose nodes lie on the polygon."""
    inner = []
    for piece in range(part.first[0], part.last[0] + 1):
        nodes = nodes_of(polygon, part, piece)
        surface = polygon.problem.surface.take(np.array([piece]))
        steps = np.linalg.norm(np.diff(surface.positions(nodes.T[None])[0], axis=0), axis=1)
        way = np.concatenate([[0.0], np.cumsum(steps)])
        times = way / way[-1] if way[-1] > 0.0 else np.linspace(0.0, 1.0, len(way))
        inner.append([np.interp(problem.space.nodes[1:-1], times, axis) for axis in nodes])
    return problem.unknowns(np.array(inner))


def _joint_error(leg: RefinedPath, part: FreePart) -> float:
    """The error of a leg's length that its joints with edges make, in parts of the size."""
    error = 0.0
    for number, side in enumerate(part.slides):
        if side is not None:
            piece = number * (len(leg.lengths) - 1)
            contact = Contact(EDGES[side].fixed_axis, EDGES[side].fixed_value)
            ends: Ends = (None, contact) if number else (contact, None)
            surface = leg.problem.surface.take(np.array([piece]))
            values = leg.values[piece][None]
            error += tangency_errors(surface, leg.problem.space, values, [ends])[0]
    return error
