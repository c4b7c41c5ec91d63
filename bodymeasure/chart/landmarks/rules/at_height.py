"""Landmarks where a geodesic passes a height."""

from typing import ClassVar

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.bezier import evaluate
from bodymeasure.chart.entry import Landmark
from bodymeasure.chart.landmarks.paths import path_between
from bodymeasure.chart.landmarks.rules.base import LandmarkRule, Landmarks
from bodymeasure.errors import InputError
from bodymeasure.geodesic import AtlasPath

# Steps on a piece of the path, so that it passes the height at most once in each.
STEPS = 24
# The height is passed within this fraction of a piece, which is its rounding.
ROOT_TOLERANCE = 1e-15
# Heights are the same within this part of the largest coordinate, which is their rounding: a path
# may begin or end at the height, with other parameters than those of the landmark.
ROUNDING = 1e-14


class AtHeight(LandmarkRule, frozen=True, kw_only=True, tag="at height"):
    """The point where the geodesic between two landmarks first passes the height of a third.

    Parameters
    ----------
    start, end : str
        The landmarks between which the geodesic runs.
    of : str
        The landmark at whose height the point lies.
    """

    example: ClassVar[str] = """
        start = "bust point left"
        end = "front waist point"
        of = "elbow point left"
    """

    start: Landmark
    end: Landmark
    of: Landmark

    @property
    def description(self) -> str:
        return f"on the way from {self.start} to {self.end} at the height of {self.of}"

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        path = path_between(atlas, self.start, self.end, landmarks)
        height = float(atlas.position(landmarks[self.of]) @ atlas.axes.up_vector)
        least = ROUNDING * float(np.abs(atlas.points[..., :3]).max())
        for number in range(len(path.pieces)):
            grid = np.arange(STEPS + 1) / STEPS
            above = _heights(path, number, grid) - height
            level = np.abs(above) <= least
            passed = np.flatnonzero((above[:-1] * above[1:] < 0.0) | level[:-1] | level[1:])
            if len(passed):
                ends = passed[0] + np.flatnonzero(level[passed[0] : passed[0] + 2])
                if len(ends):
                    return _point(path, number, grid[ends[0]])
                low, high = grid[passed[0]], grid[passed[0] + 1]
                fraction = scipy.optimize.brentq(
                    lambda t, number=number: _heights(path, number, np.array([t]))[0] - height,
                    low,
                    high,
                    xtol=ROOT_TOLERANCE,
                )
                return _point(path, number, fraction)
        raise InputError(
            f"the path from {self.start!r} to {self.end!r} does not pass the height of {self.of!r}"
        )


def _point(path: AtlasPath, number: int, fraction: float) -> AtlasPoint:
    u, v = _parameters(path, number, np.array([fraction]))[0].tolist()
    return AtlasPoint(path.pieces[number].patch, u, v)


def _parameters(path: AtlasPath, number: int, fraction: Array) -> Array:
    """Return (u, v) at fractions (k,) of a piece, shape (k, 2)."""
    piece = path.pieces[number]
    return np.clip(piece.space.functions.values(fraction) @ piece.values.T, 0.0, 1.0)


def _heights(path: AtlasPath, number: int, fraction: Array) -> Array:
    """Return the heights at fractions (k,) of a piece, shape (k,)."""
    net = path.atlas.control_points[path.pieces[number].patch]
    positions = evaluate(net, _parameters(path, number, fraction))
    return np.asarray(positions @ path.atlas.axes.up_vector)
