"""Shortest paths that touch the boundary of their patch: free legs and contact arcs.

The legs do not depend on one another: a free leg joins the boundary where it is tangential to it,
and an arc runs between the ends of its neighbors. The pattern of legs is read off a polygon at
rest, and read again from the legs themselves if one of them leaves the patch.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.contact.degrees import (
    LOWER_DEGREES,
    OVERSHOOT,
    degrees_wanted,
    leave_for_certain,
)
from bodymeasure.geodesic.contact.edge_arc import edge_arc
from bodymeasure.geodesic.contact.free_leg import solve_free_piece
from bodymeasure.geodesic.contact.joined import ContactPath, SolvedLeg, join
from bodymeasure.geodesic.contact.legs import End, Leg, read_legs
from bodymeasure.geodesic.contact.tangency import tangency_error
from bodymeasure.geodesic.lengths.measure import measure_length
from bodymeasure.geodesic.solving.protocol import EdgeContact
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface

# A polygon with more legs than this is not at rest; no path on wild patches had more than five.
MOST_LEGS = 12
# How often the pattern is read at most.
MOST_PATTERNS = 6


class _FreeLeg(NamedTuple):
    """A leg, and whether it stays in the patch."""

    solved: SolvedLeg
    inside: bool


def solve_contact_path(
    surface: Surface, polygon: Array, poles: tuple[End, End], tolerance: float
) -> ContactPath | None:
    """Solve for a path, each free leg by collocation and each contact arc by quadrature.

    Parameters
    ----------
    surface : Surface
        The surface of one problem.
    polygon : ndarray, shape (m + 1, 2)
        The polygon to start from, at rest.
    poles : pair of End
        The collapsed edges, `legs.Pole`, on which the path's ends lie.
    tolerance : float
        The relative error of the length that is asked for.

    Returns
    -------
    ContactPath or None
        None if a leg has no solution, or no pattern was found whose free legs stay in the patch and
        whose arcs are pressed against their edges.
    """
    points = polygon.copy()
    # All parameters along a collapsed edge are the same place.
    for place, beside, pole in ((0, 1, poles[0]), (-1, -2, poles[1])):
        if pole is not None:
            points[place, 1 - pole.axis] = points[beside, 1 - pole.axis]
    for _ in range(MOST_PATTERNS):
        legs = read_legs(points, poles)
        if len(legs) > MOST_LEGS:
            return None
        free: list[_FreeLeg | None] = []
        for leg in legs:
            free.append(_solve_free(surface, points, leg, tolerance))
            if leg.contact is None and free[-1] is None:
                return None
        backwards = [_runs_backwards(points, legs, free, number) for number in range(len(legs))]
        if not any(backwards) and all(found is None or found.inside for found in free):
            return _put_together(surface, points, legs, free)
        points = _read_anew(points, legs, free, backwards)
    return None


def _solve_free(surface: Surface, points: Array, leg: Leg, tolerance: float) -> _FreeLeg | None:
    if leg.contact is not None:
        return None
    polygon = points[leg.first : leg.last + 1]
    steps = np.diff(surface.jet(polygon[None], 0)[0, :, 0], axis=1)
    way = np.concatenate([[0.0], np.cumsum(np.sqrt((steps * steps).sum(axis=0)))])
    if not way[-1] > 0.0:
        return None
    times = way / way[-1]
    wanted, outside = 0.0, None
    for degree in LOWER_DEGREES:
        if degree < wanted:
            continue
        space = polynomial_space(degree)
        start = np.stack([np.interp(space.nodes, times, polygon[:, axis]) for axis in (0, 1)])
        values = solve_free_piece(surface, space, start, leg.ends)
        if values is None:
            continue
        length = measure_length(surface, space, values[None])
        # The error of a joint hardly depends on the degree.
        wanted = degrees_wanted(degree, length, tolerance)[0]
        joints = tangency_error(surface, space, values, leg.ends)
        length = replace(length, error=length.error + joints)
        if not length.is_known_to(tolerance)[0]:
            continue
        solved = SolvedLeg(space, values, length)
        if not space.leaves_patch(values[None], OVERSHOOT)[0]:
            return _FreeLeg(solved, inside=True)
        outside = _FreeLeg(solved, inside=False)
        if leave_for_certain(space, values[None], length)[0]:
            break
    return outside


def _arc_ends(
    points: Array, legs: Sequence[Leg], free: Sequence[_FreeLeg | None], number: int
) -> tuple[Array, Array]:
    """The ends of an arc: those of its neighbors, or fixed points."""
    leg = legs[number]
    before = free[number - 1] if number > 0 else None
    after = free[number + 1] if number + 1 < len(legs) else None
    begin = points[leg.first] if before is None else before.solved.values[:, -1]
    end = points[leg.last] if after is None else after.solved.values[:, 0]
    return begin, end


def _runs_backwards(
    points: Array, legs: Sequence[Leg], free: Sequence[_FreeLeg | None], number: int
) -> bool:
    leg = legs[number]
    if leg.contact is None:
        return False
    begin, end = _arc_ends(points, legs, free, number)
    along = 1 - leg.contact.axis
    # The direction is that of the points beside the arc, since a single point has none itself.
    beside = (max(leg.first - 1, 0), min(leg.last + 1, len(points) - 1))
    forward = points[beside[1], along] - points[beside[0], along]
    return bool((end[along] - begin[along]) * forward < 0.0)


def _read_anew(
    points: Array,
    legs: Sequence[Leg],
    free: Sequence[_FreeLeg | None],
    backwards: Sequence[bool],
) -> Array:
    """A polygon along the legs, put into the box; without the arcs that run backwards."""
    parts: list[Array] = []
    for number, found in enumerate(free):
        if found is not None:
            # Points between the nodes show even short parts outside.
            path = found.solved.values @ found.solved.space.between_nodes.T
            part = np.clip(path, 0.0, 1.0).T
            # Where it meets an arc that is left out, its end is no contact.
            first = 1 if number > 0 and backwards[number - 1] else 0
            last = -1 if number + 1 < len(legs) and backwards[number + 1] else None
            parts.append(part[first:last])
        elif not backwards[number]:
            begin, end = _arc_ends(points, legs, free, number)
            parts.append(np.stack([begin, (begin + end) / 2.0, end]))
    result = np.concatenate(parts)
    result[0], result[-1] = points[0], points[-1]
    moves = (np.diff(result, axis=0) != 0.0).any(axis=1)
    return np.asarray(result[np.append(True, moves)])


def _put_together(
    surface: Surface, points: Array, legs: Sequence[Leg], free: Sequence[_FreeLeg | None]
) -> ContactPath | None:
    parts, contacts = [], []
    for number, (leg, found) in enumerate(zip(legs, free, strict=True)):
        if found is not None:
            parts.append(found.solved)
            continue
        assert leg.contact is not None
        begin, end = _arc_ends(points, legs, free, number)
        arc = edge_arc(surface, leg.contact, begin, end)
        if not arc.is_pressed:
            return None
        parts.append(arc.solved)
        along = 1 - leg.contact.axis
        contacts.append(EdgeContact(leg.contact.name, float(begin[along]), float(end[along])))
    return join(parts, tuple(contacts))
