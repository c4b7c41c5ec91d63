"""Derivatives of places that are the farthest of a surface, of an edge or of a level loop."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import AtlasPoint
from bodymeasure.bezier import derivatives
from bodymeasure.make.gradient.pull import Pull

# A slope below this part of the surface's own says that a place is extreme in that direction.
FLAT = 1e-6
# A place on the side of its patch.
ON_SIDE = 1e-9


def pull_extreme(pull: Pull, point: AtlasPoint, direction: Array, vector: Array) -> None:
    """Add the derivatives of a place where a coordinate is extreme, or has a saddle.

    Parameters
    ----------
    pull : Pull
    point : AtlasPoint
        Inside a patch, on a side of it along which the coordinate is extreme, or at a corner.
    direction : ndarray, shape (3,)
        The direction of the coordinate.
    vector : ndarray, shape (3,)
        The derivative of the value with respect to the place.
    """
    jet = _jet(pull, point)
    slopes = np.stack([jet[1, 0], jet[0, 1]])
    hessian = np.array(
        [
            [jet[2, 0] @ direction, jet[1, 1] @ direction],
            [jet[1, 1] @ direction, jet[0, 2] @ direction],
        ]
    )
    pull.point(point, vector)
    free = np.flatnonzero(np.abs(slopes @ direction) < FLAT * np.linalg.norm(slopes, axis=1))
    at = np.array([point.u, point.v])
    inside = np.minimum(at, 1.0 - at) > ON_SIDE
    # Off the sides both parameters are free, whatever rounding leaves of their slopes.
    free = np.array([0, 1]) if inside.all() else free
    if not len(free):
        return
    shares = np.linalg.lstsq(hessian[np.ix_(free, free)], slopes[free] @ vector, rcond=None)[0]
    for axis, share in zip(free.tolist(), shares.tolist(), strict=True):
        pull.point(point, -share * direction, (1, 0) if axis == 0 else (0, 1))


def pull_on_lines(
    pull: Pull,
    point: AtlasPoint,
    lines: tuple[tuple[Array, str], tuple[Array, str]],
    vector: Array,
) -> None:
    """Add the derivatives of a place that has two coordinates in common with landmarks."""
    jet = _jet(pull, point)
    slopes = np.stack([jet[1, 0], jet[0, 1]])
    matrix = np.stack([slopes @ direction for direction, _ in lines])
    shares = np.linalg.solve(matrix.T, slopes @ vector)
    moved = vector.copy()
    for share, (direction, name) in zip(shares.tolist(), lines, strict=True):
        pull.at(name, share * direction)
        moved -= share * direction
    pull.point(point, moved)


def pull_outermost(
    pull: Pull, point: AtlasPoint, direction: Array, level: str, vector: Array
) -> None:
    """Add the derivatives of the outermost place of the loop at a landmark's height."""
    up = pull.atlas.axes.up_vector
    jet = _jet(pull, point)
    by_u, by_v = jet[1, 0], jet[0, 1]
    side = np.cross(up, direction)
    # There the skin has no slope along the loop: (S_u x S_v) . side is 0.
    turned = np.array(
        [
            (np.cross(jet[2, 0], by_v) + np.cross(by_u, jet[1, 1])) @ side,
            (np.cross(jet[1, 1], by_v) + np.cross(by_u, jet[0, 2])) @ side,
        ]
    )
    matrix = np.stack([np.array([by_u @ up, by_v @ up]), turned])
    height, turn = np.linalg.solve(matrix.T, np.array([by_u @ vector, by_v @ vector])).tolist()
    pull.at(level, height * up)
    pull.point(point, vector - height * up)
    pull.point(point, -turn * np.cross(by_v, side), (1, 0))
    pull.point(point, -turn * np.cross(side, by_u), (0, 1))


def _jet(pull: Pull, point: AtlasPoint) -> Array:
    return derivatives(pull.atlas.control_points[point.patch], (point.u, point.v), order=2)
