"""Shortest ways over grids of patches, from both ends of each problem, by Dijkstra's algorithm."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.lengths.equations import dot
from bodymeasure.geodesic.numerics.grid_steps import SHORTEST, grid_steps
from bodymeasure.geodesic.numerics.shortest_ways import shortest_ways
from bodymeasure.geodesic.surfaces.protocol import Surface

# Grid lines a side. Coarser grids missed paths round a bump that finer ones found.
LINES = 13
# Ends are joined to the grid points that are at most this far, in u and v, of a window of so many
# lines each way that it holds them all.
REACH = 2.5 / (LINES - 1)
WINDOW = 6


class Trees(NamedTuple):
    """Shortest ways from both ends of each problem to all points of the grid.

    Parameters
    ----------
    distance : ndarray, shape (2, problems, LINES^2)
    before : ndarray of int, shape (2, problems, LINES^2)
        The previous point on the way; LINES^2 for the end itself.
    roughness : ndarray, shape (problems,)
        The part by which steps of the grid get longer when each is measured over its middle, on
        average: how much the grid misses of the surface.
    """

    distance: Array
    before: Ints
    roughness: Array


def shortest_trees(surface: Surface, ends: Array) -> Trees:
    """Return the shortest ways for all problems, by one call of Dijkstra's algorithm.

    Parameters
    ----------
    surface : Surface
        Ways do not lead over points where it is not finite.
    ends : ndarray, shape (2, problems, 2)
        Starts and ends.
    """
    problems, nodes = ends.shape[1], LINES * LINES
    grid = _grid()
    halfway = np.broadcast_to(grid.halfway, (problems, *grid.halfway.shape))
    # The problems along the last axis, where most of them are.
    positions = np.ascontiguousarray(surface.jet(halfway, 0)[0].swapaxes(1, 2))
    begin, middle, last = positions[:, grid.steps].swapaxes(0, 1)
    length = _lengths(begin, middle, last)
    steps = length[grid.edges].T
    joined = _window(ends)
    joints = np.stack(
        [_joint_lengths(surface, *end, positions) for end in zip(ends, joined, strict=True)]
    )
    both = (2, problems, len(grid.edges))
    weights = np.concatenate([np.broadcast_to(steps, both), joints], axis=2)
    heads = np.concatenate([np.broadcast_to(grid.heads, both), joined], axis=2)
    roughness = _roughness(length, np.sqrt(dot(last - begin, last - begin)))
    distance, before = shortest_ways(
        np.append(grid.degrees, WINDOW * WINDOW),
        heads.reshape(2 * problems, -1),
        weights.reshape(2 * problems, -1),
    )
    shape = (2, problems, nodes + 1)
    return Trees(
        distance.reshape(shape)[..., :nodes], before.reshape(shape)[..., :nodes], roughness
    )


def _roughness(length: Array, chord: Array) -> Array:
    """Compare steps over their middles with their chords, both of shape (steps, problems)."""
    finite = np.isfinite(length)
    whole, straight = (np.where(finite, each, 0.0).sum(axis=0) for each in (length, chord))
    return np.asarray(whole / np.maximum(straight, SHORTEST) - 1.0)


def grid_points() -> Array:
    """Return the grid's points (u, v), shape (LINES^2, 2)."""
    return _grid().halfway[_grid().on_halfway]


class _Grid(NamedTuple):
    """The grid and the edges of its graph.

    Parameters
    ----------
    halfway : ndarray, shape (k, 2)
        Points (u, v) of a grid of half the spacing.
    on_halfway : ndarray of int, shape (LINES^2,)
        The numbers of the grid's own points among them.
    steps : ndarray of int, shape (3, steps)
        The first point, the middle and the last point of each step, as numbers among `halfway`.
    edges, heads : ndarray of int, shape (2 steps,)
        The step of each directed edge, sorted by its tail, and the grid point to which it leads.
    degrees : ndarray of int, shape (LINES^2,)
        The number of edges that leave each point.
    """

    halfway: Array
    on_halfway: Ints
    steps: Ints
    edges: Ints
    heads: Ints
    degrees: Ints


@lru_cache(maxsize=1)
def _grid() -> _Grid:
    places = _lattice(LINES)
    pairs = []
    for step in grid_steps():
        there = places + np.array(step)
        inside = ((there >= 0) & (there < LINES)).all(axis=1)
        pairs.append(np.stack([places[inside], there[inside]]))
    ends = np.concatenate(pairs, axis=1)
    number = LINES * ends[..., 0] + ends[..., 1]
    tails, heads = number.ravel(), number[::-1].ravel()
    order = np.lexsort((heads, tails))
    fine = 2 * LINES - 1
    steps = np.stack([2 * ends[0], ends[0] + ends[1], 2 * ends[1]])
    return _Grid(
        halfway=_lattice(fine) / (fine - 1),
        on_halfway=2 * (fine * places[:, 0] + places[:, 1]),
        steps=fine * steps[..., 0] + steps[..., 1],
        edges=order % number.shape[1],
        heads=heads[order],
        degrees=np.bincount(tails),
    )


def _lattice(lines: int) -> Ints:
    line = np.arange(lines)
    return np.stack(np.meshgrid(line, line, indexing="ij"), axis=-1).reshape(-1, 2)


def _window(places: Array) -> Ints:
    """The numbers of the grid points round places (u, v), shape (..., WINDOW^2)."""
    low = np.floor(places * (LINES - 1)).astype(np.int64) - (WINDOW // 2 - 1)
    low = np.clip(low, 0, LINES - WINDOW)[..., None] + np.arange(WINDOW)
    numbers = LINES * low[..., 0, :, None] + low[..., 1, None, :]
    return numbers.reshape(*places.shape[:-1], -1)


def _joint_lengths(surface: Surface, places: Array, joined: Ints, positions: Array) -> Array:
    """Lengths of the steps from one end of each problem to grid points; infinite if too far."""
    grid = _grid()
    numbers = grid.on_halfway[joined]
    middles = (places[:, None] + grid.halfway[numbers]) / 2.0
    too_far = (np.abs(places[:, None] - grid.halfway[numbers]) > REACH).any(axis=2)
    own = surface.jet(np.concatenate([places[:, None], middles], axis=1), 0)[0]
    there = positions[:, numbers, np.arange(len(places))[:, None]]
    return np.where(too_far, np.inf, _lengths(own[:, :, :1], own[:, :, 1:], there))


def _lengths(begin: Array, middle: Array, end: Array) -> Array:
    """The lengths of polygons of two edges, components along axis 0; infinite if not finite."""
    first, last = middle - begin, end - middle
    result: Array = np.sqrt(dot(first, first)) + np.sqrt(dot(last, last))
    return np.where(np.isfinite(result), result, np.inf)
