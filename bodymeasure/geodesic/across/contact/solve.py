"""Paths over several patches that edges hold for a part: free legs and arcs along the edges.

This works as on one patch (`geodesic.contact`): where a free leg joins an edge follows from its
tangency there, and an arc runs between the ends of the legs beside it. An edge of the atlas holds a
path that would leave the atlas; a seam holds one that would be longer on either side of it.
"""

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Neighbors, on_side
from bodymeasure.geodesic.across.contact.arc import on_edge, pressed_arc
from bodymeasure.geodesic.across.contact.free_leg import free_leg
from bodymeasure.geodesic.across.contact.pattern import (
    FreePart,
    HeldPart,
    place_at,
    read_pattern,
)
from bodymeasure.geodesic.across.pieces.budget import Budget
from bodymeasure.geodesic.across.pieces.part import PathPart, PathPiece
from bodymeasure.geodesic.across.pieces.problem import RouteProblem
from bodymeasure.geodesic.across.pieces.refine import RefinedPath, measured, resampled
from bodymeasure.geodesic.contact.legs import Contact
from bodymeasure.geodesic.spaces.polygons import polygon_space

# The number of edges, on each patch, of the polygon whose pattern is read.
EDGE_COUNT = 32
# A polygon that starts from a path nearly at rest takes some three steps to come to rest. Where it
# may slide along itself it never does, but which edges hold it is clear all the same.
MOST_STEPS = 8
# No path is shorter than the shortest polygon, except for rounding.
ROUNDING = 1e-12


def held_path(
    atlas: Atlas, neighbors: Neighbors, refined: RefinedPath, tolerance: float, budget: Budget
) -> PathPart | None:
    """Return the path along a route that edges hold for a part.

    Parameters
    ----------
    atlas : Atlas
    neighbors : Neighbors
    refined : RefinedPath
        The best path of polynomials on whole patches.
    tolerance : float
        The relative error that is wanted for the length of each leg.
    budget : Budget
        The work is counted, and no leg is solved once nothing is left.

    Returns
    -------
    PathPart or None
        None if a leg has no solution or leaves its patches, an edge does not hold its arc, or the
        budget has run out.
    """
    budget.spend_on_pattern(refined)
    if not _held_from_all_sides(atlas, neighbors, refined):
        return None
    polygon = _polygon(refined)
    parts = read_pattern(polygon)
    legs: dict[int, PathPart] = {}
    for number, part in enumerate(parts):
        if isinstance(part, FreePart):
            leg = free_leg(atlas, polygon, part, tolerance, budget)
            if leg is None:
                return None
            legs[number] = leg
    solved: list[PathPart] = []
    pressed = False
    for number, part in enumerate(parts):
        if isinstance(part, FreePart):
            solved.append(legs[number])
            continue
        beside = legs.get(number - 1), legs.get(number + 1)
        arc = _arc(atlas, neighbors, polygon, part, beside)
        if arc is None:
            return None
        solved.append(arc[0])
        pressed |= arc[1]
    # Edges that are geodesics themselves hold nothing, and the path along them need be no minimum.
    if not pressed:
        return None
    path = PathPart.joined(solved)
    return path if path.length.corrected <= polygon.length * (1.0 + ROUNDING) else None


def _polygon(refined: RefinedPath) -> RefinedPath:
    """The polygon at rest near a path."""
    before = refined.problem
    space, size = polygon_space(EDGE_COUNT), before.size
    problem = RouteProblem(before.atlas, refined.route, space, size, epsilon=before.epsilon)
    start = resampled(refined, problem)
    return measured(problem, problem.minimized(start, most_steps=MOST_STEPS))


def _held_from_all_sides(atlas: Atlas, neighbors: Neighbors, refined: RefinedPath) -> bool:
    """Return whether the edges that hold a path seem to hold it on all patches beside them."""
    held, route = refined.held_nodes, refined.problem.route
    inner = refined.values[:, :, 1:-1]
    for piece, patch in enumerate(route.patches):
        for side, edge in enumerate(EDGES):
            axis, value = edge.fixed_axis, edge.fixed_value
            on = np.flatnonzero(held[piece, axis] & (inner[piece, axis] == value))
            for run in np.split(on, np.flatnonzero(np.diff(on) > 1) + 1):
                if len(run) < 2:
                    continue
                begin, end = (
                    AtlasPoint(patch, *on_side(side, float(inner[piece, 1 - axis, node])))
                    for node in run[[0, -1]]
                )
                contact, size = Contact(axis, value), refined.problem.size
                if begin != end and not pressed_arc(atlas, neighbors, contact, (begin, end), size):
                    return False
    return bool(held.any())


def _arc(
    atlas: Atlas,
    neighbors: Neighbors,
    polygon: RefinedPath,
    part: HeldPart,
    beside: tuple[PathPart | None, PathPart | None],
) -> tuple[PathPart, bool] | None:
    """An arc between where the legs beside it meet its edge, and whether it is pressed there.

    None if it would be shorter off the edge.
    """
    patch, axis = polygon.route.patches[part.piece], 1 - part.contact.axis
    before, after = beside
    begin, end = (
        on_edge(neighbors, point, patch, part.contact)
        for point in (
            before.pieces[-1].end(-1) if before else place_at(polygon, part.piece, part.first),
            after.pieces[0].end(0) if after else place_at(polygon, part.piece, part.last),
        )
    )
    # The direction is that of the nodes beside the arc, since an arc of a single node has none.
    last = polygon.values.shape[2] - 1
    nodes = polygon.values[part.piece, axis, [max(part.first - 1, 0), min(part.last + 1, last)]]
    if (end[1 + axis] - begin[1 + axis]) * (nodes[1] - nodes[0]) < 0.0:
        return None
    size = polygon.problem.size
    arc = pressed_arc(atlas, neighbors, part.contact, (begin, end), size)
    if arc is None:
        return None
    space, values, known = arc.solved
    length = known.mapped(lambda array: array[0]).scaled(size)
    piece = PathPiece(patch, space, values, float(length.raw))
    return PathPart((piece,), (), length), not arc.is_geodesic
