"""Landmarks in the hollow between two others."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.queries.outside import outward_sign
from bodymeasure.bezier import derivatives
from bodymeasure.chart.entry import Fault, Landmark
from bodymeasure.chart.landmarks.paths import on_the_left, path_between, point_at
from bodymeasure.chart.landmarks.rules.base import LandmarkRule, Landmarks
from bodymeasure.errors import InputError
from bodymeasure.geodesic import AtlasPath
from bodymeasure.section.places import roots_between

# Steps on a piece of the path, so that its distance from the chord has at most one extreme in each.
STEPS = 24
ROOT_TOLERANCE = 1e-15
# A path that runs below its chord by at most this fraction of it is straight.
STRAIGHT = 1e-9


class Hollow(LandmarkRule, frozen=True, kw_only=True, tag="hollow"):
    """The point of the geodesic between two landmarks that lies deepest below its chord.

    A point is below the chord where the surface's outer side faces the chord.

    Parameters
    ----------
    start, end : str
        The two landmarks.
    least : float
        The least depth of a hollow, as a part of the chord; a dent that is shallower is none.
    otherwise : float, optional
        The fraction of the geodesic's length at which the point lies on bodies without a hollow;
        if not given, they have no such landmark.
    """

    example: ClassVar[str] = 'start = "bust point left"\nend = "front waist point"'

    start: Landmark
    end: Landmark
    least: float = 0.0
    otherwise: float | None = None

    @property
    def description(self) -> str:
        deepest = f"deepest below the chord from {self.start} to {self.end}"
        if self.otherwise is None:
            return deepest
        return f"{deepest}; without a hollow, {self.otherwise:.4g} of the way"

    def faults(self) -> Iterator[Fault]:
        for member, value in (("least", self.least), ("otherwise", self.otherwise)):
            if value is not None and not 0.0 <= value <= 1.0:
                yield Fault(self, member, f"{member} is {value}; expected 0 to 1")

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        path = path_between(atlas, self.start, self.end, landmarks)
        ends = np.stack([atlas.position(landmarks[name]) for name in (self.start, self.end)])
        length = float(np.linalg.norm(ends[1] - ends[0]))
        if length == 0.0:
            raise InputError(f"{self.start!r} and {self.end!r} are one place, without a chord")
        axis = (ends[1] - ends[0]) / length
        found: list[tuple[float, AtlasPoint]] = []
        sign = outward_sign(atlas)
        for number, fraction in _turns(path, ends[0], axis):
            place, offset, _, normal = (
                each[0] for each in _state(path, number, np.array([fraction]), ends[0], axis)
            )
            depth = float(np.linalg.norm(offset))
            if depth > max(self.least, STRAIGHT) * length and sign * float(offset @ normal) < 0.0:
                found.append((depth, AtlasPoint(path.pieces[number].patch, *place.tolist())))
        if found:
            return on_the_left(path, max(found, key=lambda candidate: candidate[0])[1])
        if self.otherwise is None:
            raise InputError(
                f"the path from {self.start!r} to {self.end!r} nowhere runs below its chord, so "
                "it has no hollow"
            )
        return point_at(path, self.otherwise)


def _turns(path: AtlasPath, start: Array, axis: Array) -> list[tuple[int, float]]:
    """Return places (piece, fraction of it) where the distance from the chord is extreme.

    These are the places where ``x . x' = 0`` for the offset x from the chord.
    """
    result = []
    for number, piece in enumerate(path.pieces):
        if piece.length == 0.0:
            continue

        def slope(fraction: Array, _rows: Ints, number: int = number) -> Array:
            return _state(path, number, fraction, start, axis)[2]

        grid = np.arange(STEPS + 1) / STEPS
        values = slope(grid, np.arange(len(grid)))
        k = np.flatnonzero(values[:-1] * values[1:] < 0.0)
        brackets = grid[k], grid[k + 1], values[k], values[k + 1]
        result += [
            (number, root) for root in roots_between(slope, *brackets, ROOT_TOLERANCE).tolist()
        ]
        # The slope may jump over zero at seams, where the path may have a kink in space.
        result += [(number, 0.0), (number, 1.0)]
    return result


def _state(
    path: AtlasPath, number: int, fraction: Array, start: Array, axis: Array
) -> tuple[Array, Array, Array, Array]:
    """Return (u, v), offsets from the chord, half the slopes of their squares, and normals.

    They are those at fractions (k,) of a piece, one each a row.
    """
    piece = path.pieces[number]
    place, slope = piece.space.matrices(fraction)[:2] @ piece.values.T
    place = np.clip(place, 0.0, 1.0)
    net = path.atlas.control_points[piece.patch]
    jet = derivatives(net, place, order=1)
    by_u, by_v = jet[:, 1, 0], jet[:, 0, 1]
    offset = jet[:, 0, 0] - start
    offset -= (offset @ axis)[:, None] * axis
    velocity = slope[:, :1] * by_u + slope[:, 1:] * by_v
    return place, offset, (offset * velocity).sum(axis=1), np.cross(by_u, by_v)
