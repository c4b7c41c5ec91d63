"""Landmarks on the geodesic between two others: at a fraction of it, or where it is deepest."""

from functools import lru_cache

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.atlas.queries.outside import outward_sign
from bodymeasure.bezier import derivatives
from bodymeasure.chart.landmarks.choice import TIE, atlas_size
from bodymeasure.chart.landmarks.rules import Between, Hollow
from bodymeasure.errors import InputError
from bodymeasure.geodesic import AtlasPath, geodesic_between

# Steps a piece of the path in which its distance from the chord has one extreme at most.
STEPS = 24
ROOT_TOLERANCE = 1e-15
# Of the chord: a path that runs below it by no more is straight.
STRAIGHT = 1e-9


def between_point(atlas: Atlas, rule: Between, landmarks: dict[str, AtlasPoint]) -> AtlasPoint:
    """The point that a `Between` rule gives; of mirror images, the one on the wearer's left.

    Raises
    ------
    InputError
        If the fraction is not in [0, 1], no seams join the places, or no geodesic between them can
        be trusted.
    MissingExtraError
        If the package for routes is not installed.
    """
    if not 0.0 <= rule.fraction <= 1.0:
        raise InputError(f"the fraction is {rule.fraction}; expected a number from 0 to 1")
    path = path_between(atlas, rule.start, rule.end, landmarks)
    patch, (u, v) = path.path(rule.fraction)
    return _on_the_left(atlas, path, AtlasPoint(int(patch), float(u), float(v)))


def hollow_point(atlas: Atlas, rule: Hollow, landmarks: dict[str, AtlasPoint]) -> AtlasPoint:
    """The point that a `Hollow` rule gives; of mirror images, the one on the wearer's left.

    Raises
    ------
    InputError
        If no seams join the places, no geodesic between them can be trusted, or it nowhere runs
        below its chord.
    MissingExtraError
        If the package for routes is not installed.

    Notes
    -----
    Below the chord is where the surface's outer side faces the chord. There, the distance x from
    the chord is largest where ``x . x' = 0``.
    """
    path = path_between(atlas, rule.start, rule.end, landmarks)
    ends = np.stack([atlas.position(landmarks[name]) for name in (rule.start, rule.end)])
    length = float(np.linalg.norm(ends[1] - ends[0]))
    if length == 0.0:
        raise InputError(f"{rule.start!r} and {rule.end!r} are one place, without a chord")
    axis = (ends[1] - ends[0]) / length
    found: list[tuple[float, AtlasPoint]] = []
    sign = outward_sign(atlas)
    for number, fraction in _turns(path, ends[0], axis):
        point, offset, _, normal = _state(path, number, fraction, ends[0], axis)
        depth = float(np.linalg.norm(offset))
        if depth > STRAIGHT * length and sign * float(offset @ normal) < 0.0:
            found.append((depth, point))
    if not found:
        raise InputError(
            f"the path from {rule.start!r} to {rule.end!r} nowhere runs below its chord, so it has "
            "no hollow"
        )
    return _on_the_left(atlas, path, max(found, key=lambda candidate: candidate[0])[1])


def _on_the_left(atlas: Atlas, path: AtlasPath, point: AtlasPoint) -> AtlasPoint:
    """The point of a path, or its mirror image if that is a point of the body on the left.

    Along the ridge of a symmetric body a shortest path leaves the middle to one side, and another,
    as short, to the other one; which of them is found is an accident.
    """
    start, end = (atlas.position(place) for place in (path.points[0], path.points[-1]))
    left, near = atlas.axes.left_vector, TIE * atlas_size(atlas)
    aside = float((atlas.position(point) - start) @ left)
    if aside >= 0.0 or abs(float((end - start) @ left)) > near:
        return point
    mirrored = atlas.position(point) - 2.0 * aside * left
    (twin,), (apart,) = closest_points(atlas, mirrored[None])
    return twin if apart <= near else point


# As many paths as a large set of measurements of a body needs; each takes some kilobytes.
@lru_cache(maxsize=512)
def leg_between(atlas: Atlas, start: AtlasPoint, end: AtlasPoint) -> AtlasPath:
    """Return the geodesic between two points, which rules and measurements share.

    It is found once; whether its length can be trusted is in its status.
    """
    return geodesic_between(atlas, start, end, on_failure="status")


def path_between(atlas: Atlas, start: str, end: str, landmarks: dict[str, AtlasPoint]) -> AtlasPath:
    """The geodesic between two landmarks, refused if it cannot be trusted."""
    path = leg_between(atlas, landmarks[start], landmarks[end])
    if not path.converged:
        raise InputError(
            f"the geodesic from {start!r} to {end!r} cannot be trusted ({path.status.name}); pick "
            "the landmark, or derive it from others"
        )
    return path


def _turns(path: AtlasPath, start: Array, axis: Array) -> list[tuple[int, float]]:
    """Places (number of a piece, fraction of it) where the distance from the chord is extreme."""
    result = []
    for number, piece in enumerate(path.pieces):
        if piece.length == 0.0:
            continue

        def slope(fraction: float, number: int = number) -> float:
            return _state(path, number, fraction, start, axis)[2]

        grid = np.arange(STEPS + 1) / STEPS
        values = np.array([slope(float(t)) for t in grid])
        for k in np.flatnonzero(values[:-1] * values[1:] < 0.0):
            root = scipy.optimize.brentq(slope, grid[k], grid[k + 1], xtol=ROOT_TOLERANCE)
            result.append((number, float(root)))
        # At seams, where the path may have a kink in space, the slope may jump over zero.
        result += [(number, 0.0), (number, 1.0)]
    return result


def _state(
    path: AtlasPath, number: int, fraction: float, start: Array, axis: Array
) -> tuple[AtlasPoint, Array, float, Array]:
    """Point, offset from the chord, half the slope of the offset's square, and the normal."""
    piece = path.pieces[number]
    matrices = piece.space.matrices(fraction)[:2, 0]
    (u, v), (u_slope, v_slope) = (matrices @ piece.values.T).tolist()
    u, v = min(max(u, 0.0), 1.0), min(max(v, 0.0), 1.0)
    net = path.atlas.control_points[piece.patch]
    jet = derivatives(net, (u, v), order=1)
    offset = jet[0, 0] - start
    offset -= (offset @ axis) * axis
    velocity = u_slope * jet[1, 0] + v_slope * jet[0, 1]
    normal = np.cross(jet[1, 0], jet[0, 1])
    return AtlasPoint(piece.patch, u, v), offset, float(offset @ velocity), normal
