"""Rough shortest paths over a grid of the patch, to start a search from."""

from __future__ import annotations

from functools import lru_cache
from math import gcd

import numpy as np
import scipy
from numpy.typing import NDArray

from bodymeasure.geodesic.surface import Surface

_Array = NDArray[np.float64]

# Grid lines a side, and the longest step in them: steps in 16 directions, all coprime pairs up to
# 3. Coarser grids missed paths round a bump that finer ones found.
LINES = 13
LONGEST = 3
# Ends that are no grid points are joined to those within this distance in u and v.
REACH = 2.5 / (LINES - 1)
# A second path is worth a try if it is at most this much longer than the first, and passes this
# far, in (u, v), from all taken before it.
WORTH = 1.1
APART = 0.2
MOST_PATHS = 4


def rough_paths(surface: Surface, start: _Array, end: _Array, count: int) -> list[_Array]:
    """Some different paths that may lead to the shortest, the shortest first.

    Every grid point stands for the shortest path through it, by way of the graph. They are taken in
    order of length, those that pass near one taken before left out.

    Parameters
    ----------
    surface : Surface
        Of one problem.
    start, end : ndarray, shape (2,)
    count : int
        Number of edges of the polygons returned.

    Returns
    -------
    list of ndarray, shape (count + 1, 2)
        At most `MOST_PATHS`.
    """
    points = np.concatenate([_grid_points(), start[None], end[None]])
    pairs = _pairs(start, end, points)
    first, last = len(points) - 2, len(points) - 1
    middle = (points[pairs[:, 0]] + points[pairs[:, 1]]) / 2.0
    positions = np.moveaxis(surface.jet(np.concatenate([points, middle])[None], 0)[0, :, 0], 0, -1)
    halfway = positions[len(points) :]
    weights = sum(np.linalg.norm(positions[pairs[:, side]] - halfway, axis=1) for side in (0, 1))
    if not np.isfinite(weights).all():
        return []
    # A zero would read as "no edge": collapsed edges of a patch have such steps.
    weights = np.maximum(weights, 1e-300)
    size = len(points)
    graph = scipy.sparse.csr_array((weights, (pairs[:, 0], pairs[:, 1])), shape=(size, size))
    distance, before = scipy.sparse.csgraph.dijkstra(
        graph, directed=False, indices=[first, last], return_predecessors=True
    )
    through = distance.sum(axis=0)
    # Points halfway between the ends tell the paths apart best.
    balance = np.abs(distance[0] - distance[1])
    step = distance[0, last] / (LINES - 1)
    candidates = np.flatnonzero(balance <= 2.0 * step)
    taken: list[NDArray[np.int64]] = []
    for point in candidates[np.argsort(through[candidates], kind="stable")]:
        if len(taken) == MOST_PATHS or through[point] > WORTH * distance[0, last]:
            break
        gaps = [np.linalg.norm(points[path] - points[point], axis=1).min() for path in taken]
        if all(gap > APART for gap in gaps):
            there = _walk(before[0], int(point), first)
            back = _walk(before[1], int(point), last)
            taken.append(np.array([*there[::-1], *back[1:]]))
    return [_resampled(points[path], positions[path], count) for path in taken]


@lru_cache(maxsize=1)
def _grid_points() -> _Array:
    line = np.linspace(0.0, 1.0, LINES)
    return np.stack(np.meshgrid(line, line, indexing="ij"), axis=-1).reshape(-1, 2)


@lru_cache(maxsize=1)
def _grid_pairs() -> NDArray[np.int64]:
    number = np.arange(LINES * LINES).reshape(LINES, LINES)
    pairs = []
    for i in range(LONGEST + 1):
        for j in range(-LONGEST, LONGEST + 1):
            if gcd(i, j) != 1 or (i == 0 and j < 0):
                continue
            low, high = max(0, -j), LINES - max(0, j)
            pairs.append(
                np.stack([number[: LINES - i, low:high], number[i:, low + j : high + j]], -1)
            )
    return np.concatenate([part.reshape(-1, 2) for part in pairs])


def _pairs(start: _Array, end: _Array, points: _Array) -> NDArray[np.int64]:
    pairs = [_grid_pairs()]
    grid = points[:-2]
    for number, place in ((len(points) - 2, start), (len(points) - 1, end)):
        near = np.flatnonzero((np.abs(grid - place) <= REACH).all(axis=1))
        pairs.append(np.stack([np.full(len(near), number), near], axis=1))
    return np.concatenate(pairs)


def _walk(before: NDArray[np.int32], point: int, goal: int) -> list[int]:
    path = [point]
    while path[-1] != goal:
        path.append(int(before[path[-1]]))
    return path


def _resampled(points: _Array, positions: _Array, count: int) -> _Array:
    """The polygon with edges of equal length on the surface."""
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(positions, axis=0), axis=1))])
    times = np.linspace(0.0, along[-1], count + 1)
    return np.stack([np.interp(times, along, points[:, axis]) for axis in (0, 1)], axis=1)
