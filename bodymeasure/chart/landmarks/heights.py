"""Landmarks where a geodesic passes a height."""

import numpy as np
import scipy

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.bezier import evaluate
from bodymeasure.chart.landmarks.paths import path_between
from bodymeasure.chart.landmarks.rules import AtHeight
from bodymeasure.errors import InputError
from bodymeasure.geodesic import AtlasPath

# Steps a piece of the path in which it passes the height once at most.
STEPS = 24
# Of a piece: the height is passed there to rounding.
ROOT_TOLERANCE = 1e-15


def at_height_point(atlas: Atlas, rule: AtHeight, landmarks: dict[str, AtlasPoint]) -> AtlasPoint:
    """The point that an `AtHeight` rule gives.

    Raises
    ------
    InputError
        If no seams join the places, no geodesic between them can be trusted, or it does not pass
        the height.
    MissingExtraError
        If the package for routes is not installed.
    """
    path = path_between(atlas, rule.start, rule.end, landmarks)
    height = float(atlas.position(landmarks[rule.of]) @ atlas.axes.up_vector)
    for number in range(len(path.pieces)):
        grid = np.arange(STEPS + 1) / STEPS
        above = np.array([_above(path, number, t, height) for t in grid.tolist()])
        passed = np.flatnonzero(above[:-1] * above[1:] <= 0.0)
        if len(passed):
            low, high = grid[passed[0]], grid[passed[0] + 1]
            fraction = scipy.optimize.brentq(
                lambda t, number=number: _above(path, number, t, height),
                low,
                high,
                xtol=ROOT_TOLERANCE,
            )
            return _point(path, number, fraction)
    raise InputError(
        f"the path from {rule.start!r} to {rule.end!r} does not pass the height of {rule.of!r}"
    )


def _point(path: AtlasPath, number: int, fraction: float) -> AtlasPoint:
    piece = path.pieces[number]
    values = piece.space.functions.values(np.array([fraction]))[0] @ piece.values.T
    u, v = np.clip(values, 0.0, 1.0).tolist()
    return AtlasPoint(piece.patch, u, v)


def _above(path: AtlasPath, number: int, fraction: float, height: float) -> float:
    point = _point(path, number, fraction)
    position = evaluate(path.atlas.control_points[point.patch], (point.u, point.v))
    return float(position @ path.atlas.axes.up_vector) - height
