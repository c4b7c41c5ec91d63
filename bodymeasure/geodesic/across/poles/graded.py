"""Paths that are cut about the poles that they pass, in spaces of higher and higher degree."""

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.geodesic.across.pieces.budget import Budget
from bodymeasure.geodesic.across.pieces.error import route_length
from bodymeasure.geodesic.across.pieces.part import PathPart
from bodymeasure.geodesic.across.pieces.path import AtlasPath
from bodymeasure.geodesic.across.pieces.refine import RefinedPath
from bodymeasure.geodesic.across.poles.course import Course, course_along
from bodymeasure.geodesic.across.poles.cuts import FIRST, cut, refined_cut
from bodymeasure.geodesic.across.search.leg import Ends
from bodymeasure.geodesic.across.search.repair import TOLERANCE
from bodymeasure.geodesic.across.search.search import GOOD_ENOUGH
from bodymeasure.geodesic.status import Status

# Degrees of the polynomials on each part of a path that is cut, tried in turn. A path is cut anew
# at most this many times, as it comes nearer to the pole or farther from it.
DEGREES, MOST_CUTS = (8, 12, 16, 24), 8
# Where Newton's method does not come to rest at so many degrees, it hardly does at others.
MOST_FAILURES = 2
# A piece of less than this part of a path is in a corner.
CORNER = 1e-3


def graded_path(
    atlas: Atlas, neighbors: Neighbors, ends: Ends, course: Course, budget: Budget
) -> AtlasPath | None:
    """Return the shortest path along a course, cut about poles; None if it has no good length."""
    size, first = course.length(atlas), FIRST
    cuts = cut(neighbors, course, first)
    for _ in range(MOST_CUTS):
        if budget.has_run_out():
            return None
        refined = refined_cut(atlas, cuts, DEGREES[0], size)
        budget.spend(refined)
        course = course_along(refined)
        if cuts.hold(refined):
            first *= 2.0
        else:
            first = FIRST
            if cut(neighbors, course, first).fits(cuts):
                break
        cuts = cut(neighbors, course, first)
    else:
        return None
    failures = 0
    for degree in DEGREES:
        if degree > DEGREES[0]:
            if budget.is_overdrawn():
                # The length may be good enough.
                break
            refined = refined_cut(atlas, cuts, degree, size, refined)
            budget.spend(refined)
        length, _ = route_length(refined)
        failures += not refined.minimum.converged
        if length.error <= TOLERANCE * length.raw or failures == MOST_FAILURES:
            break
    held = (refined.minimum.held & ~refined.problem.idle).any()
    if held or cuts.hold(refined) or _runs_into_corner(neighbors, refined):
        return None
    if not (length.is_known_to(GOOD_ENOUGH) and refined.minimum.converged):
        return None
    status = Status.CONVERGED if length.minimal else Status.NOT_A_MINIMUM
    path = AtlasPath.of(atlas, ends, PathPart.of(refined, length), status)
    return path if path.converged else None


def _runs_into_corner(neighbors: Neighbors, refined: RefinedPath) -> bool:
    """Return whether a path crosses two seams at once, other than at a pole.

    It may be shorter on the other side of the corner where they meet.
    """
    route, lengths = refined.route, refined.lengths
    for number in range(1, len(lengths) - 1):
        seams = all(route.crossings[side].within is None for side in (number - 1, number))
        if seams and lengths[number] < CORNER * lengths.sum():
            patch, values = route.patches[number], refined.values[number]
            corner = AtlasPoint(patch, *np.round(values.mean(axis=1)).tolist())
            if neighbors.pole_side(corner) is None:
                return True
    return False
