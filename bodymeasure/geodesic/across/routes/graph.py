"""A graph over an atlas whose shortest ways are roughly the distances between its points."""

from bisect import bisect_left
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.prepared import prepared
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.across.routes.mesh import RouteMesh, whole_mesh
from bodymeasure.geodesic.numerics.grid_steps import SHORTEST, grid_steps
from bodymeasure.geodesic.numerics.shortest_ways import shortest_ways

# Steps along each patch edge: the first number that makes this many points, or else the last.
SEGMENTS, ENOUGH = (2, 4, 6, 8, 12, 16), 1000
# Where patches are many, they are small, and graphs of more points than this only take longer.
MOST = 20_000
# A point is joined to the grid points this many steps away, in u and v.
REACH = 1.5


class Reach(NamedTuple):
    """The rough distances of all vertices from a point, and how they are reached.

    Parameters
    ----------
    place : AtlasPoint
    distances : ndarray, shape (n,)
        Infinite on other parts.
    before : list of int
        The vertex from which each one is reached; n where that is the point itself.
    ways : dict
        The vertices on the ways to those vertices to which `PatchGraph.way` was asked for one.
    """

    place: AtlasPoint
    distances: Array
    before: list[int]
    ways: dict[int, list[int]]


@dataclass(frozen=True, eq=False)
class PatchGraph:
    """The points of a grid over each patch, and the steps between them.

    Parameters
    ----------
    mesh : RouteMesh
        The mesh with the same vertices.
    places : tuple of AtlasPoint
        A point of the atlas at each vertex.
    steps : sparse array, shape (n, n)
        The lengths of the steps, in both directions.
    grid : ndarray of int, shape (steps, 5)
        The patch of each step, and the lines of its grid on which it begins and ends: those of u,
        then of v.
    """

    mesh: RouteMesh
    places: tuple[AtlasPoint, ...]
    steps: "scipy.sparse.csr_array"
    grid: Ints

    @property
    def vertices(self) -> Array:
        """The positions of the vertices, shape (n, 3)."""
        return self.mesh.surface.vertices

    def distances(self, atlas: Atlas, place: AtlasPoint) -> Array:
        """Return the rough distances of all vertices from a point; infinite on other parts."""
        return self.reach(atlas, place).distances

    def reach(self, atlas: Atlas, place: AtlasPoint) -> Reach:
        """Return the rough distances of all vertices from a point, and how they are reached."""
        segments = self.mesh.segments
        grid = np.arange(segments + 1)
        near = np.abs(grid - segments * place.u) <= REACH
        beside = np.abs(grid - segments * place.v) <= REACH
        joined = np.unique(self.mesh.vertex[place.patch][np.ix_(near, beside)])
        joined = joined[joined >= 0]
        position = evaluate(atlas.control_points[place.patch], np.array(place[1:]))
        first = np.linalg.norm(self.vertices[joined] - position, axis=1)
        # The point is one more node, with steps to those beside it.
        count = len(self.vertices)
        lengths = np.concatenate([self.steps.data, np.maximum(first, SHORTEST)])
        heads = np.concatenate([self.steps.indices, joined])
        degrees = np.append(np.diff(self.steps.indptr), len(joined))
        distances, before = shortest_ways(degrees, heads[None], lengths[None])
        return Reach(place, distances[0, :count], before[0, :count].tolist(), {})

    def way(self, reach: Reach, vertex: int) -> list[int]:
        """Return the vertices of a shortest way from a point to a vertex, along the mesh's edges.

        The first one is a corner of the face that holds the point. Some follow on themselves.
        """
        ways, before, back = reach.ways, reach.before, [vertex]
        while back[-1] not in ways and before[back[-1]] < len(before):
            back.append(before[back[-1]])
        here = back.pop()
        if here not in ways:
            ways[here] = self._to_first(reach.place, here)
        for there in reversed(back):
            ways[there] = ways[here] + self.edges_between(here, there)
            here = there
        return ways[vertex]

    def edges_between(self, vertex: int, other: int) -> list[int]:
        """Return the vertices along edges of the mesh on which a step leads to another vertex."""
        known = self._edges.get((vertex, other))
        if known is None:
            begins, others = self._ends_of_steps
            step = bisect_left(others, other, begins[vertex], begins[vertex + 1])
            patch, i, to_i, j, to_j = self.grid[step].tolist()
            known = self._edges[vertex, other] = self.mesh.between(patch, (i, j), (to_i, to_j))
        return known

    @cached_property
    def _edges(self) -> dict[tuple[int, int], list[int]]:
        """What `edges_between` found, for at most every step of the graph."""
        return {}

    @cached_property
    def _ends_of_steps(self) -> tuple[list[int], list[int]]:
        """Where the steps of each vertex begin, and the vertices to which they lead, in order."""
        return self.steps.indptr.tolist(), self.steps.indices.tolist()

    def _to_first(self, place: AtlasPoint, vertex: int) -> list[int]:
        """The vertices from a corner of the face that holds a point to one that it is joined to."""
        face, weights = self.mesh.holding(place)
        corners = self.mesh.corners[face].tolist()
        if vertex in corners:
            return [vertex]
        corner = corners[int(np.argmax(weights))]
        grid = self.mesh.vertex[place.patch]
        here, there = (np.argwhere(grid == each)[0].tolist() for each in (corner, vertex))
        return self.mesh.between(place.patch, here, there)


@prepared
def patch_graph(atlas: Atlas) -> PatchGraph:
    """Return the graph of an atlas, which is kept for the next path."""
    enough = (k for k in SEGMENTS if len(atlas) * k * k >= ENOUGH)
    segments = next(enough, SEGMENTS[-1])
    if len(atlas) * segments**2 > MOST:
        segments = 1
    mesh = whole_mesh(atlas, segments)
    vertices, number = mesh.surface.vertices, mesh.vertex
    first, last, grid = _steps(number)
    count = len(vertices)
    # Steps along a seam are found on both its patches.
    _, once = np.unique(
        np.minimum(first, last) * count + np.maximum(first, last), return_index=True
    )
    first, last, grid = first[once], last[once], grid[once]
    back = grid[:, [0, 2, 1, 4, 3]]
    first, last = np.concatenate([first, last]), np.concatenate([last, first])
    order = np.lexsort((last, first))
    first, last = first[order], last[order]
    length = np.linalg.norm(vertices[first] - vertices[last], axis=1)
    begins = np.searchsorted(first, np.arange(count + 1))
    steps = scipy.sparse.csr_array(
        (np.maximum(length, SHORTEST), last, begins), shape=(count, count)
    )
    places: list[AtlasPoint] = [AtlasPoint(0, 0.0, 0.0)] * count
    for patch, i, j in np.argwhere(number >= 0).tolist():
        places[number[patch, i, j]] = AtlasPoint(patch, i / segments, j / segments)
    return PatchGraph(mesh, tuple(places), steps, np.concatenate([grid, back])[order])


def _steps(number: Ints) -> tuple[Ints, Ints, Ints]:
    """The first and the last vertex of every step within a patch, and its place in the grid."""
    lines = number.shape[1]
    first, last, grid = [], [], []
    place = np.indices(number.shape)
    for i, j in grid_steps():
        if max(abs(i), abs(j)) >= lines:
            continue
        low, high = max(0, -j), lines - max(0, j)
        first.append(number[:, : lines - i, low:high].ravel())
        last.append(number[:, i:, low + j : high + j].ravel())
        a, b, c = place[:, :, : lines - i, low:high].reshape(3, -1)
        grid.append(np.stack([a, b, b + i, c, c + j], axis=1))
    a, b = np.concatenate(first), np.concatenate(last)
    proper = (a >= 0) & (b >= 0) & (a != b)
    return a[proper], b[proper], np.concatenate(grid)[proper]
