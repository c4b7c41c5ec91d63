"""Several different rough paths between two points of a patch, from which a search starts."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.numerics.grid_steps import SHORTEST
from bodymeasure.geodesic.shortest.grid_graph import LINES, grid_points, shortest_trees
from bodymeasure.geodesic.surfaces.protocol import Surface

# A second path is worth a try if it is at most this much longer than the first, and passes this
# far, in (u, v), from all taken before it. On rough patches the lengths of the graph are too long
# by different parts, of some times the patch's roughness: on one with heights of eleven times its
# side and a roughness of 0.04, the way that leads to the shortest path was 14 % longer than the
# first.
WORTH, WORTH_BY_ROUGHNESS, MOST_WORTH = 1.1, 5.0, 1.5
APART = 0.2
MOST_PATHS = 6
# Paths are distinguished best by points halfway between the ends, within so many steps of the grid.
HALFWAY = 2.0


class RoughPaths(NamedTuple):
    """Polygons over grids of patches.

    Parameters
    ----------
    problems : ndarray of int, shape (paths,)
        The problems of the polygons.
    points : ndarray, shape (paths, m + 1, 2)
        Points (u, v); all edges are of about the same length on the surface.
    """

    problems: Ints
    points: Array


def rough_paths(surface: Surface, ends: Array, edges: int) -> RoughPaths:
    """Return paths that may lead to the shortest, at most `MOST_PATHS` for each problem.

    Every grid point stands for the shortest path of the graph through it. Paths are taken in order
    of length, except those that pass near one that was taken before.

    Parameters
    ----------
    surface : Surface
    ends : ndarray, shape (2, problems, 2)
        Starts and ends.
    edges : int
        The number of edges of the polygons returned.
    """
    trees = shortest_trees(surface, ends)
    through = trees.distance.sum(axis=0)
    shortest = through.min(axis=1, keepdims=True)
    # Points that cannot be reached are infinitely far from both ends.
    with np.errstate(invalid="ignore"):
        balance = np.abs(trees.distance[0] - trees.distance[1])
    worth = np.minimum(WORTH + WORTH_BY_ROUGHNESS * trees.roughness, MOST_WORTH)[:, None]
    in_question = (balance <= HALFWAY / (LINES - 1) * shortest) & (through <= worth * shortest)
    through[~in_question] = np.inf
    owners, polygons = [], []
    for _ in range(MOST_PATHS):
        problems = np.flatnonzero(np.isfinite(through).any(axis=1))
        middle = through[problems].argmin(axis=1)
        halves = [_walk(before, problems, middle) for before in trees.before]
        through[problems] = np.where(_passed(halves), np.inf, through[problems])
        owners.append(problems)
        points = np.concatenate(
            [
                _places(halves[0], ends[0, problems])[:, ::-1],
                _places(halves[1], ends[1, problems])[:, 1:],
            ],
            axis=1,
        )
        polygons.append(evenly(surface.take(problems), points, edges))
    return RoughPaths(np.concatenate(owners), np.concatenate(polygons))


def _walk(before: Ints, problems: Ints, point: Ints) -> Ints:
    """The ways from grid points back to an end, shape (problems, k); short ones stay at the end."""
    end = before.shape[1]
    way = [point]
    while (way[-1] < end).any():
        last = way[-1]
        way.append(np.where(last < end, before[problems, np.minimum(last, end - 1)], end))
    return np.stack(way, axis=1)


def _passed(halves: list[Ints]) -> Bools:
    """Which grid points lie near ways, shape (problems, points)."""
    near = _near()
    return np.asarray(near[np.concatenate(halves, axis=1)].any(axis=1))


@lru_cache(maxsize=1)
def _near() -> Bools:
    """Which grid points are near which; an end, the last row, is near none."""
    points = grid_points()
    gaps = np.linalg.norm(points[:, None] - points, axis=2)
    return np.concatenate([gaps <= APART, np.zeros((1, len(points)), bool)])


def _places(way: Ints, end: Array) -> Array:
    """The points (u, v) along ways over the grid to an end."""
    points = grid_points()
    at_end = (way == len(points))[..., None]
    return np.where(at_end, end[:, None], points[np.minimum(way, len(points) - 1)])


def evenly(surface: Surface, points: Array, edges: int) -> Array:
    """Return polygons, shape (polygons, k, 2), with vertices at equal distances on the surface."""
    steps = np.linalg.norm(np.diff(surface.jet(points, 0)[0], axis=-1), axis=0)
    along = np.concatenate([np.zeros((len(steps), 1)), np.cumsum(steps, axis=1)], axis=1)
    wanted = along[:, -1:] * np.linspace(0.0, 1.0, edges + 1)[1:-1]
    rows = np.arange(len(points))[:, None]
    edge = (along[:, None, 1:-1] <= wanted[..., None]).sum(axis=-1)
    # A path that stays in one place, as on a collapsed edge, has no distances.
    whole = np.maximum(steps[rows, edge], SHORTEST)
    part = ((wanted - along[rows, edge]) / whole)[..., None]
    inner = points[rows, edge] * (1.0 - part) + points[rows, edge + 1] * part
    return np.concatenate([points[:, :1], inner, points[:, -1:]], axis=1)
