"""Saddles of the height over an atlas: where horizontal loops merge."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import EDGES, Atlas, AtlasPoint, EdgeTable, edge_table
from bodymeasure.bezier import bernstein, derivatives

_Array = NDArray[np.float64]

# Newton's method starts from so many points a side of each patch.
STARTS = 5
STEPS = 30
# In (u, v): at rest. Newton's error is squared by each step, so only rounding is left.
REST = 1e-12
# In (u, v): so far outside its patch a stationary point may be by rounding.
OUTSIDE = 1e-9
# Of the patch's own range of heights: slopes that small have no sign.
LEVEL = 1e-9
# Of the atlas's size: saddles this close together are one.
SAME = 1e-7


def saddles_between(atlas: Atlas, low: float, high: float, near: _Array) -> list[AtlasPoint]:
    """Saddles of the height between two heights, the nearest to a position first.

    Parameters
    ----------
    atlas : Atlas
    low, high : float
        Along the atlas's way up.
    near : ndarray, shape (3,)

    Returns
    -------
    list of AtlasPoint
        Each once. Inside patches, or on seams; corners of patches between the two heights if there
        is neither.
    """
    heights = atlas.control_points @ atlas.axes.up_vector
    inside = (heights.min(axis=(1, 2)) <= high) & (heights.max(axis=(1, 2)) >= low)
    patches = np.flatnonzero(inside)
    found = [*_in_patches(heights, patches), *_on_seams(heights, patches, edge_table(atlas.index))]
    corners = [
        AtlasPoint(int(p), float(u), float(v)) for p in patches for u in (0, 1) for v in (0, 1)
    ]
    for candidates in (found, corners):
        positions = np.array([atlas.position(point) for point in candidates]).reshape(-1, 3)
        height = positions @ atlas.axes.up_vector
        rows = np.flatnonzero((height >= low) & (height <= high))
        rows = rows[np.argsort(np.linalg.norm(positions[rows] - near, axis=1), kind="stable")]
        # On a seam, each of its patches has the same saddle.
        apart = np.linalg.norm(positions[rows, None] - positions[rows], axis=-1)
        again = np.tril(apart <= SAME * float(np.abs(atlas.points).max()), -1).any(axis=1)
        if len(rows):
            return [candidates[row] for row in rows[~again]]
    return []


def _in_patches(heights: _Array, patches: NDArray[np.int64]) -> Iterator[AtlasPoint]:
    """Where a patch's height has no gradient and an indefinite Hessian."""
    side = (np.arange(STARTS) + 0.5) / STARTS
    grid = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2)
    row = np.repeat(patches, len(grid))
    place = np.tile(grid, (len(patches), 1))
    nets = heights[row][..., None]
    for _ in range(STEPS):
        slope, bend = _slopes(nets, place)
        determinant = bend[:, 0, 0] * bend[:, 1, 1] - bend[:, 0, 1] ** 2
        bend[determinant == 0.0] = np.eye(2)
        step = np.linalg.solve(bend, slope[..., None])[..., 0]
        # No further than a patch's width, so that none is lost for good.
        step *= np.minimum(1.0, 0.5 / np.maximum(np.abs(step).max(axis=1), 1e-300))[:, None]
        place = np.clip(place - step, -1.0, 2.0)
    slope, bend = _slopes(nets, place)
    rests = np.abs(step).max(axis=1) <= REST
    rests &= ((place >= -OUTSIDE) & (place <= 1.0 + OUTSIDE)).all(axis=1)
    rests &= np.linalg.det(bend) < 0.0
    for number in np.flatnonzero(rests):
        u, v = np.clip(place[number], 0.0, 1.0).tolist()
        yield AtlasPoint(int(row[number]), u, v)


def _slopes(nets: _Array, place: _Array) -> tuple[_Array, _Array]:
    s = derivatives(nets, place, order=2)[..., 0]
    bend = np.stack([s[:, 2, 0], s[:, 1, 1], s[:, 1, 1], s[:, 0, 2]], axis=1).reshape(-1, 2, 2)
    return np.stack([s[:, 1, 0], s[:, 0, 1]], axis=1), bend


def _on_seams(
    heights: _Array, patches: NDArray[np.int64], table: EdgeTable
) -> Iterator[AtlasPoint]:
    """Where the height is least along a seam and falls to both sides, or the other way round."""
    edges = table.edge[patches]
    for edge in np.unique(edges[table.sides[edges] == 2]).tolist():
        (first, side), (second, other) = np.argwhere(table.edge == edge).tolist()
        cubic = _along(heights[first], side)
        for t in _stationary(cubic):
            there = 1.0 - t if table.reversed[first, side] != table.reversed[second, other] else t
            slopes = (_inwards(heights[first], side, t), _inwards(heights[second], other, there))
            # Of a cubic in Bernstein form, the second derivative is 6 (b'' (1 - t) + ...).
            bend = np.diff(cubic, 2) @ (1.0 - t, t)
            least = LEVEL * float(np.ptp(heights[[first, second]]))
            falls = max(slopes) < -least and bend > 0.0
            rises = min(slopes) > least and bend < 0.0
            if falls or rises:
                fixed = EDGES[side]
                u, v = (fixed.fixed_value, t) if fixed.fixed_axis == 0 else (t, fixed.fixed_value)
                yield AtlasPoint(first, u, v)


def _along(net: _Array, side: int) -> _Array:
    edge = EDGES[side]
    return np.asarray(np.take(net, int(3 * edge.fixed_value), axis=edge.fixed_axis))


def _inwards(net: _Array, side: int, t: float) -> float:
    """Slope of the height away from a side, into the patch."""
    edge = EDGES[side]
    next_row = np.take(net, 1 + int(edge.fixed_value), axis=edge.fixed_axis)
    return float(3.0 * bernstein(3, t)[0] @ (next_row - _along(net, side)))


def _stationary(cubic: _Array) -> list[float]:
    """Where a cubic in Bernstein form has no slope inside (0, 1)."""
    first, middle, last = np.diff(cubic)
    roots = np.roots([first - 2.0 * middle + last, 2.0 * (middle - first), first])
    return [float(t.real) for t in roots if t.imag == 0.0 and 0.0 < t.real < 1.0]
