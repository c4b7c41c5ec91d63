"""Shortest paths that touch the boundary of their patch: free legs and contact arcs.

The legs do not depend on one another: a free leg joins the boundary where it is tangential to it,
and an arc runs between the ends of its neighbors. The pattern of legs is read off a polygon at
rest, and read again from the legs themselves if one of them leaves the patch.
"""

from collections.abc import Sequence

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.contact.edge_arc import edge_arc
from bodymeasure.geodesic.contact.free_legs import FreeLeg, solve_free_legs
from bodymeasure.geodesic.contact.joined import ContactPath, join
from bodymeasure.geodesic.contact.legs import Ends, Leg, read_legs
from bodymeasure.geodesic.solving.protocol import EdgeContact
from bodymeasure.geodesic.surfaces.protocol import Surface

# A polygon with more legs than this is not at rest; no path on wild patches had more than five.
MOST_LEGS = 12
# How often the pattern is read at most.
MOST_PATTERNS = 6


def solve_contact_paths(
    surface: Surface, polygons: Sequence[Array], poles: Sequence[Ends], tolerance: float
) -> list[ContactPath | None]:
    """Solve for paths, each free leg by collocation and each contact arc by quadrature.

    Parameters
    ----------
    surface : Surface
        The patch of each path.
    polygons : sequence of ndarray, shape (m + 1, 2)
        The polygons to start from, at rest.
    poles : sequence of pairs of End
        The collapsed edges, `legs.Pole`, on which the paths' ends lie.
    tolerance : float
        The relative error of the length that is asked for.

    Returns
    -------
    list of ContactPath or None
        None if a leg has no solution, or no pattern was found whose free legs stay in the patch and
        whose arcs are pressed against their edges.
    """
    result: list[ContactPath | None] = [None] * len(polygons)
    points = {
        row: _put_on_poles(*each) for row, each in enumerate(zip(polygons, poles, strict=True))
    }
    for _ in range(MOST_PATTERNS):
        patterns = {row: read_legs(each, poles[row]) for row, each in points.items()}
        patterns = {row: legs for row, legs in patterns.items() if len(legs) <= MOST_LEGS}
        solved = _solve_legs(surface, points, patterns, tolerance)
        again = {}
        for row, free in solved.items():
            here, legs = points[row], patterns[row]
            backwards = [_runs_backwards(here, legs, free, number) for number in range(len(legs))]
            if any(backwards) or not all(found is None or found.inside for found in free):
                again[row] = _read_anew(here, legs, free, backwards)
            else:
                result[row] = _put_together(surface.take(np.array([row])), here, legs, free)
        points = again
        if not points:
            break
    return result


def _put_on_poles(polygon: Array, poles: Ends) -> Array:
    """The polygon; all parameters along a collapsed edge are the same place."""
    points = polygon.copy()
    for place, beside, pole in ((0, 1, poles[0]), (-1, -2, poles[1])):
        if pole is not None:
            points[place, 1 - pole.axis] = points[beside, 1 - pole.axis]
    return points


def _solve_legs(
    surface: Surface, points: dict[int, Array], patterns: dict[int, list[Leg]], tolerance: float
) -> dict[int, list[FreeLeg | None]]:
    """The free legs of all paths, in their order, with None for arcs; without paths that fail."""
    parts = [(row, leg) for row, legs in patterns.items() for leg in legs if leg.contact is None]
    found = iter(
        solve_free_legs(
            surface.take(np.array([row for row, _ in parts], np.int64)),
            [points[row][leg.first : leg.last + 1] for row, leg in parts],
            [leg.ends for _, leg in parts],
            tolerance,
        )
    )
    solved = {
        row: [next(found) if leg.contact is None else None for leg in legs]
        for row, legs in patterns.items()
    }
    return {
        row: free
        for row, free in solved.items()
        if all(
            each is not None or leg.contact is not None
            for each, leg in zip(free, patterns[row], strict=True)
        )
    }


def _arc_ends(
    points: Array, legs: Sequence[Leg], free: Sequence[FreeLeg | None], number: int
) -> tuple[Array, Array]:
    """The ends of an arc: those of its neighbors, or fixed points."""
    leg = legs[number]
    before = free[number - 1] if number > 0 else None
    after = free[number + 1] if number + 1 < len(legs) else None
    begin = points[leg.first] if before is None else before.solved.values[:, -1]
    end = points[leg.last] if after is None else after.solved.values[:, 0]
    return begin, end


def _runs_backwards(
    points: Array, legs: Sequence[Leg], free: Sequence[FreeLeg | None], number: int
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
    free: Sequence[FreeLeg | None],
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
    surface: Surface, points: Array, legs: Sequence[Leg], free: Sequence[FreeLeg | None]
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
