"""Paths as splines: cubic over a smooth surface, and straight from point to point otherwise."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.atlas import Unit
from bodymeasure.bezier import evaluate
from bodymeasure.errors import InputError
from bodymeasure.geodesic import AtlasPath
from bodymeasure.mesh.path import MeshPath
from bodymeasure.mesh.points import points_of
from bodymeasure.wording import counted

# How far a spline may be from its path, as a part of the path's length. A millionth of a meter is
# far less than what a CAD program takes for a gap.
TOLERANCE = 1e-7
# Cubic segments on a piece of a path between two seams.
MOST_SEGMENTS = 256
# The step of the differences that give derivatives, in segments: their own error is its square.
STEP = 1e-3
# Places in each segment at which a spline is compared with its path.
BETWEEN = np.array([0.2, 0.4, 0.6, 0.8])


@dataclass(frozen=True, eq=False)
class Curve:
    """A spline that passes through its control points' ends.

    Parameters
    ----------
    name : str
    degree : int
        3, or 1 for a chain of straight pieces.
    control_points : ndarray, shape (degree * segments + 1, 3)
        Those of the Bezier segments one after the other, which share their ends.
    breaks : ndarray, shape (segments + 1,)
        The parameters of the ends of the segments, from 0 to 1.
    facts : dict
        The length, its error estimate and the unit, as far as they are known.
    """

    name: str
    degree: int
    control_points: Array
    breaks: Array
    facts: dict[str, Any] = field(default_factory=dict)

    @property
    def multiplicities(self) -> list[int]:
        """How often each of the breaks is a knot."""
        inner = [self.degree] * (len(self.breaks) - 2)
        return [self.degree + 1, *inner, self.degree + 1]

    def points(self, per_segment: int) -> Array:
        """Return points along the curve, so many for each segment, and the last one."""
        if self.degree == 1:
            return self.control_points
        t = np.arange(per_segment) / per_segment
        nets = _segments(self.control_points)
        inside = _bezier(nets, t).reshape(-1, 3)
        return np.concatenate([inside, self.control_points[-1:]])


def curve_of(name: str, given: AtlasPath | MeshPath | ArrayLike, unit: Unit | None = None) -> Curve:
    """Return a path as a curve.

    Parameters
    ----------
    name : str
    given : AtlasPath, MeshPath or array_like of shape (k, 3)
    unit : Unit, optional
        Unit of the points; a path in another one is refused.

    Raises
    ------
    InputError
        If it is no path.
    """
    points, facts = points_of(repr(name), given, unit)
    if len(points) < 2:
        raise InputError(f"path {name!r} has {counted(len(points), 'point')}; expected two or more")
    if isinstance(given, AtlasPath):
        facts = {**facts, "status": given.status.name.lower()}
        bounds = np.cumsum([0.0, *(piece.length for piece in given.pieces)])
        return smooth_curve(name, given.position, bounds / (bounds[-1] or 1.0), facts)
    step = np.linalg.norm(np.diff(points, axis=0), axis=1)
    kept = np.concatenate([[True], step > 0.0])
    along = np.concatenate([[0.0], np.cumsum(step)])[kept]
    return Curve(name, 1, points[kept], along / (along[-1] or 1.0), facts)


def smooth_curve(
    name: str,
    position: Callable[[Array], Array],
    bounds: Sequence[float] | Array,
    facts: dict[str, Any],
) -> Curve:
    """Return a cubic spline near a curve, within `TOLERANCE`.

    Parameters
    ----------
    name : str
    position : callable
        Takes parameters (k,) from 0 to 1 and returns points (k, 3).
    bounds : sequence of float
        Increasing, from 0 to 1: the curve is smooth between each two of them.
    facts : dict
    """
    pairs = [(a, b) for a, b in pairwise(bounds) if b - a > 1e-12]
    parts = [_fitted(position, low, high) for low, high in pairs]
    chains = [parts[0][0], *(net[1:] for net, _ in parts[1:])]
    breaks = [parts[0][1], *(inner[1:] for _, inner in parts[1:])]
    return Curve(name, 3, np.concatenate(chains), np.concatenate(breaks), facts)


def _fitted(position: Callable[[Array], Array], low: float, high: float) -> tuple[Array, Array]:
    """Return control points and breaks of a spline on one smooth part of a curve."""
    count = 2
    while True:
        breaks = np.linspace(low, high, count + 1)
        net = _hermite(position, breaks)
        width = np.diff(breaks)[:, None]
        places = np.clip(breaks[:-1, None] + width * BETWEEN, low, high)
        found = _bezier(_segments(net), BETWEEN).reshape(-1, 3)
        off = np.linalg.norm(found - position(places.ravel()), axis=1).max()
        size = float(np.linalg.norm(np.diff(net[::3], axis=0), axis=1).sum()) / (high - low)
        if off <= TOLERANCE * size or count >= MOST_SEGMENTS:
            return net, breaks
        count *= 2


def _hermite(position: Callable[[Array], Array], breaks: Array) -> Array:
    """Return the control points of cubics with a curve's points and derivatives at breaks."""
    width = float(breaks[1] - breaks[0])
    h = STEP * width
    inner = breaks[1:-1]
    ends = np.array([breaks[0], breaks[0] + h, breaks[0] + 2 * h])
    back = np.array([breaks[-1], breaks[-1] - h, breaks[-1] - 2 * h])
    points = position(breaks)
    first, last = position(ends), position(back)
    slopes = np.concatenate(
        [
            (-3.0 * first[0] + 4.0 * first[1] - first[2])[None] / (2.0 * h),
            (position(inner + h) - position(inner - h)) / (2.0 * h),
            (3.0 * last[0] - 4.0 * last[1] + last[2])[None] / (2.0 * h),
        ]
    )
    third = width / 3.0 * slopes
    rows = np.stack([points[:-1], points[:-1] + third[:-1], points[1:] - third[1:]], axis=1)
    return np.concatenate([rows.reshape(-1, 3), points[-1:]])


def _segments(control_points: Array) -> Array:
    """Return the control points of each cubic segment, shape (segments, 4, 3)."""
    first = np.arange(0, len(control_points) - 1, 3)
    return np.asarray(control_points[first[:, None] + np.arange(4)])


def _bezier(nets: Array, t: Array) -> Array:
    """Return points of cubic segments (m, 4, 3) at parameters (k,), shape (m, k, 3)."""
    # A curve is a patch that does not depend on v.
    patches = np.repeat(nets[:, :, None], 2, axis=2)
    parameters = np.stack([t, np.zeros_like(t)], axis=-1)
    return evaluate(patches, np.broadcast_to(parameters, (len(nets), len(t), 2)))
