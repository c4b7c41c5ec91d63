"""Edges of pieces along smooth curves through landmarks."""

from collections.abc import Sequence

import numpy as np
import scipy

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.errors import InputError
from bodymeasure.pattern.curves.geodesics import geodesic_curve
from bodymeasure.pattern.curves.skin_curve import SkinCurve

# In meters: the distance of points of the curve that are put on the skin. The curve on the skin is
# a chain of shortest paths between them, which turn by a few degrees where it bends most.
STEP = 0.008
# A curve on the skin that is longer than the one in space by more than this goes round something.
LONGEST = 1.5


def smooth_curve(atlas: Atlas, points: Sequence[AtlasPoint]) -> SkinCurve:
    """Return a smooth curve through points, put on the skin.

    Notes
    -----
    A cubic spline in space, whose parameter grows with the square root of the distance from point
    to point, so that it does not swing where they lie unevenly. What it has between them is put on
    the skin by the closest points.

    Raises
    ------
    InputError
        If the closest points lie on different parts of the body.
    ConvergenceError
        If a length cannot be trusted.
    """
    positions = np.array([atlas.position(point) for point in points])
    gaps = np.linalg.norm(np.diff(positions, axis=0), axis=1)
    knots = np.concatenate([[0.0], np.cumsum(np.sqrt(gaps))])
    spline = scipy.interpolate.CubicSpline(knots, positions, bc_type="natural")
    chain, run = [points[0]], 0.0
    for row, gap in enumerate(gaps.tolist()):
        count = max(1, round(gap * atlas.unit.meters / STEP))
        between = spline(np.linspace(knots[row], knots[row + 1], count + 1))
        run += float(np.linalg.norm(np.diff(between, axis=0), axis=1).sum())
        if count > 1:
            chain += closest_points(atlas, between[1:-1])[0]
        chain.append(points[row + 1])
    curve = geodesic_curve(atlas, chain)
    if curve.length > LONGEST * run:
        raise InputError(
            "the curve between its landmarks leaves the skin, and comes back to it elsewhere; name "
            "more landmarks on its way"
        )
    return curve
