"""A graph over an atlas whose shortest ways are roughly the distances between its points."""

from dataclasses import dataclass
from functools import cached_property
from math import ceil, floor
from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.prepared import prepared
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.across.routes.faces import OnFace
from bodymeasure.geodesic.across.routes.mesh import RouteMesh, unit_steps, whole_mesh
from bodymeasure.geodesic.numerics.grid_steps import SHORTEST, grid_steps
from bodymeasure.geodesic.numerics.shortest_ways import shortest_ways
from bodymeasure.native import GraphArrays, JoinedEnd

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
    before : ndarray of int, shape (n + 1,)
        The vertex from which each one is reached; n where that is the point itself, and for it.
    """

    place: AtlasPoint
    distances: Array
    before: Ints


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
    along : ndarray of int, shape (steps + 1, k)
        The vertices after the first, along edges of the mesh, on which each step leads; -1 for
        none, as everywhere in the last row.
    """

    mesh: RouteMesh
    places: tuple[AtlasPoint, ...]
    steps: "scipy.sparse.csr_array"
    along: Ints

    @property
    def vertices(self) -> Array:
        """The positions of the vertices, shape (n, 3)."""
        return self.mesh.surface.vertices

    def distances(self, atlas: Atlas, place: AtlasPoint) -> Array:
        """Return the rough distances of all vertices from a point; infinite on other parts."""
        return self.reach(atlas, place).distances

    def reach(self, atlas: Atlas, place: AtlasPoint) -> Reach:
        """Return the rough distances of all vertices from a point, and how they are reached."""
        joined, first = self.joined(atlas, place)
        # The point is one more node, with steps to those beside it.
        count = len(self.vertices)
        lengths = np.concatenate([self.steps.data, first])
        heads = np.concatenate([self.steps.indices, joined])
        degrees = np.append(np.diff(self.steps.indptr), len(joined))
        distances, (before,) = shortest_ways(degrees, heads[None], lengths[None])
        before[count] = count
        return Reach(place, distances[0, :count], before)

    def joined(self, atlas: Atlas, place: AtlasPoint) -> tuple[Ints, Array]:
        """Return the vertices to which a point is joined, and their distances."""
        at = [self.mesh.segments * each for each in place[1:]]
        near = tuple(slice(max(ceil(each - REACH), 0), floor(each + REACH) + 1) for each in at)
        joined = np.unique(self.mesh.vertex[place.patch][near])
        joined = joined[joined >= 0]
        position = evaluate(atlas.control_points[place.patch], np.array(place[1:]))
        distances = np.linalg.norm(self.vertices[joined] - position, axis=1)
        return joined, np.maximum(distances, SHORTEST)

    def joined_end(self, atlas: Atlas, place: AtlasPoint) -> JoinedEnd:
        """Return a point as an end of ways, for compiled kernels."""
        vertices, distances = self.joined(atlas, place)
        on = self.mesh.holding(place)
        ways = [self._to_first(place.patch, on, vertex) for vertex in vertices.tolist()]
        along = np.full((len(ways), max(map(len, ways))), -1)
        for row, way in zip(along, ways, strict=True):
            row[: len(way)] = way
        return JoinedEnd(*on, vertices, distances, along)

    @cached_property
    def arrays(self) -> GraphArrays:
        """The steps, for compiled kernels."""
        begins, heads = (
            np.ascontiguousarray(each, np.int64) for each in (self.steps.indptr, self.steps.indices)
        )
        return GraphArrays(begins, heads, self.steps.data, self.along)

    def ways(self, reach: Reach, vertices: Ints) -> list[Ints]:
        """Return the vertices of shortest ways from a point to vertices, along the mesh's edges.

        The first one is a corner of the face that holds the point. Some follow on themselves.
        """
        back = [vertices]
        while (back[-1] < len(self.vertices)).any():
            back.append(reach.before[back[-1]])
        nodes = np.array(back[::-1])
        here, there = nodes[:-1], nodes[1:]
        begun = here < len(self.vertices)
        on = self.mesh.holding(reach.place)
        first = {
            vertex: self._to_first(reach.place.patch, on, vertex)
            for vertex in set(there[~begun & (there < len(self.vertices))].tolist())
        }
        # No step leads from the point itself, nor to it.
        steps = np.where(begun, self.step(np.where(begun, here, 0), there), -1)
        along = self.along[steps].swapaxes(0, 1).reshape(len(vertices), -1)
        heads = there[np.argmax(there < len(self.vertices), axis=0), np.arange(len(vertices))]
        return [
            np.concatenate([first[head], row[row >= 0]])
            for head, row in zip(heads.tolist(), along, strict=True)
        ]

    def step(self, vertices: Ints, others: Ints) -> Ints:
        """Return the numbers of the steps from vertices to others, to which steps lead."""
        result: Ints = np.searchsorted(self._pairs, vertices * len(self.vertices) + others)
        return result

    @cached_property
    def _pairs(self) -> Ints:
        """A number for the ends of each step, in order."""
        count = len(self.vertices)
        first: Ints = np.repeat(np.arange(count), np.diff(self.steps.indptr))
        return first * count + np.asarray(self.steps.indices, np.int64)

    def _to_first(self, patch: int, on: OnFace, vertex: int) -> list[int]:
        """The vertices from a corner of the face that holds a point to one that it is joined to."""
        corners = self.mesh.corners[on.face].tolist()
        if vertex in corners:
            return [vertex]
        corner = corners[int(np.argmax(on.weights))]
        here, there = (self.mesh.on_grid(patch, each) for each in (corner, vertex))
        return self.mesh.between(patch, here, there)


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
    along = _along_edges(number, np.concatenate([grid, back])[order])
    return PatchGraph(mesh, tuple(places), steps, along)


def _along_edges(number: Ints, grid: Ints) -> Ints:
    """The vertices on which steps lead along edges, as in `PatchGraph.along`.

    Parameters
    ----------
    number : ndarray of int, shape (patches, k + 1, k + 1)
        The vertex at each point of the patches' grids; or -1.
    grid : ndarray of int, shape (steps, 5)
        The patch of each step, and the lines of its grid on which it begins and ends: those of u,
        then of v.
    """
    patch, i, to_i, j, to_j = grid.T
    lines = number.shape[1]
    kinds = (to_i - i + lines) * 2 * lines + (to_j - j + lines)
    ways = {
        kind: unit_steps(kind // (2 * lines) - lines, kind % (2 * lines) - lines)[1:]
        for kind in np.unique(kinds).tolist()
    }
    result = np.full((len(grid) + 1, max(map(len, ways.values()), default=0)), -1)
    for kind, way in ways.items():
        rows = np.flatnonzero(kinds == kind)
        for place, (a, b) in enumerate(way):
            result[rows, place] = number[patch[rows], i[rows] + a, j[rows] + b]
    return result


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
