"""What lengths must satisfy whatever the surface: oracles that need no reference.

A shortest path is no longer than the way over a third point, as long from its other end, as long as
its parts, and the same wherever the surface stands. Each holds within the estimates of the lengths.
"""

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from helpers.surfaces.near_boundaries import Triple
from scipy.spatial.transform import Rotation

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint


class Contradiction(NamedTuple):
    """Lengths that cannot all be right, or one that is missing.

    Parameters
    ----------
    oracle : {"refused", "triangle", "swapped", "split", "moved"}
    points : tuple of AtlasPoint
    beyond : float
        By how much the estimates are exceeded, as a part of the longest length; NaN if refused.
    """

    oracle: str
    points: tuple[AtlasPoint, ...]
    beyond: float


class _Lengths:
    """Lengths and errors of paths of an atlas, each measured once."""

    def __init__(self, atlas: Atlas) -> None:
        self.atlas = atlas
        self.paths: dict[tuple[AtlasPoint, AtlasPoint], bm.AtlasPath] = {}

    def __call__(self, start: AtlasPoint, end: AtlasPoint) -> bm.AtlasPath:
        if (start, end) not in self.paths:
            path = bm.geodesic_between(self.atlas, start, end, on_failure="status")
            self.paths[start, end] = path
        return self.paths[start, end]


def contradictions(
    atlas: Atlas, points: Triple, turned: Atlas | None = None, *, whole: bool = True
) -> Iterator[Contradiction]:
    """Yield what is contradicted by the paths between three points.

    Parameters
    ----------
    atlas : Atlas
    points : tuple of AtlasPoint
    turned : Atlas, optional
        The atlas after a rigid motion.
    whole : bool
        Whether to go beyond the triangle: swap the ends of the first side, split it and move it.
    """
    lengths = _Lengths(atlas)
    sides = [lengths(*ends) for ends in pairwise((*points, points[0]))]
    if not whole:
        yield from _judged("triangle", points, sides, _excess_of_triangle(sides))
        return
    first, ends = sides[0], points[:2]
    others = [("swapped", lengths(*ends[::-1]))]
    if turned is not None:
        others.append(("moved", bm.geodesic_between(turned, *ends, on_failure="status")))
    yield from _judged("triangle", points, sides, _excess_of_triangle(sides))
    for oracle, other in others:
        yield from _judged(oracle, ends, [first, other], abs(other.length - first.length))
    if first.converged and first.length > 0.0:
        (patch,), ((u, v),) = first.path([0.5])
        middle = AtlasPoint(int(patch), *np.clip([u, v], 0.0, 1.0).tolist())
        parts = [lengths(ends[0], middle), lengths(middle, ends[1])]
        # The middle of the computed path, which is longer than the geodesic, is beside that.
        away = abs(first.raw_length - first.length)
        excess = abs(sum(part.length for part in parts) - first.length) - away
        yield from _judged("split", (*ends, middle), [first, *parts], excess)


def _excess_of_triangle(sides: list[bm.AtlasPath]) -> float:
    shorter, middle, longer = sorted(side.length for side in sides)
    return longer - shorter - middle


def _judged(
    oracle: str, points: tuple[AtlasPoint, ...], paths: list[bm.AtlasPath], excess: float
) -> Iterator[Contradiction]:
    if not all(path.converged for path in paths):
        yield Contradiction("refused", points, np.nan)
        return
    beyond = excess - sum(path.error_estimate for path in paths)
    if beyond > 0.0:
        yield Contradiction(oracle, points, beyond / max(path.length for path in paths))


def moved(atlas: Atlas, seed: int) -> Atlas:
    """The atlas turned and moved by about its size."""
    rng = np.random.default_rng(seed)
    size = float(np.ptp(atlas.points, axis=0).max())
    points: Array = Rotation.random(random_state=rng).apply(atlas.points.copy())
    return Atlas(
        points + size * rng.standard_normal(3), atlas.index, atlas.unit, weights=atlas.weights
    )
