"""A graph over an atlas whose shortest ways are roughly the distances between its points."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.across.routes.mesh import whole_mesh
from bodymeasure.geodesic.numerics.grid_steps import SHORTEST, grid_steps

# Steps along each patch edge: the first number that makes this many points, or else the last.
SEGMENTS, ENOUGH = (4, 6, 8, 12, 16), 2000
# A point is joined to the grid points this many steps away, in u and v.
REACH = 1.5


@dataclass(frozen=True, eq=False)
class PatchGraph:
    """The points of a grid over each patch, and the steps between them.

    Parameters
    ----------
    number : ndarray of int, shape (patches, k + 1, k + 1)
        The number of the vertex at each grid point; -1 where there is none.
    vertices : ndarray, shape (n, 3)
    places : tuple of AtlasPoint
        A point of the atlas at each vertex.
    steps : sparse array, shape (n, n)
        The lengths of the steps, in both directions.
    """

    number: Ints
    vertices: Array
    places: tuple[AtlasPoint, ...]
    steps: scipy.sparse.csr_array

    def distances(self, atlas: Atlas, place: AtlasPoint) -> Array:
        """Return the rough distances of all vertices from a point; infinite on other parts."""
        segments = self.number.shape[1] - 1
        grid = np.arange(segments + 1)
        near = np.abs(grid - segments * place.u) <= REACH
        beside = np.abs(grid - segments * place.v) <= REACH
        joined = np.unique(self.number[place.patch][np.ix_(near, beside)])
        joined = joined[joined >= 0]
        position = evaluate(atlas.control_points[place.patch], np.array(place[1:]))
        first = np.linalg.norm(self.vertices[joined] - position, axis=1)
        # The point is one more node, with steps to those beside it.
        count = len(self.vertices)
        graph = scipy.sparse.csr_array(
            (
                np.concatenate([self.steps.data, np.maximum(first, SHORTEST)]),
                np.concatenate([self.steps.indices, joined]),
                np.append(self.steps.indptr, self.steps.nnz + len(joined)),
            ),
            shape=(count + 1, count + 1),
        )
        return np.asarray(scipy.sparse.csgraph.dijkstra(graph, indices=count)[:count])


@lru_cache(maxsize=4)
def patch_graph(atlas: Atlas) -> PatchGraph:
    """Return the graph of an atlas, which is kept for the next path."""
    enough = (k for k in SEGMENTS if len(atlas) * k * k >= ENOUGH)
    segments = next(enough, SEGMENTS[-1])
    mesh = whole_mesh(atlas, segments)
    number = np.full((len(atlas), segments + 1, segments + 1), -1)
    row, column = np.moveaxis(np.rint(segments * mesh.face_parameters).astype(np.int64), -1, 0)
    number[mesh.face_patch[:, None], row, column] = mesh.faces
    first, last = _steps(number)
    count = len(mesh.vertices)
    # Steps along a seam are found on both its patches; a sparse matrix would add them up.
    _, once = np.unique(
        np.minimum(first, last) * count + np.maximum(first, last), return_index=True
    )
    first, last = first[once], last[once]
    length = np.linalg.norm(mesh.vertices[first] - mesh.vertices[last], axis=1)
    steps = scipy.sparse.csr_array((length, (first, last)), shape=(count, count))
    places: list[AtlasPoint] = [AtlasPoint(0, 0.0, 0.0)] * count
    for patch, i, j in np.argwhere(number >= 0).tolist():
        places[number[patch, i, j]] = AtlasPoint(patch, i / segments, j / segments)
    return PatchGraph(number, mesh.vertices, tuple(places), (steps + steps.T).tocsr())


def _steps(number: Ints) -> tuple[Ints, Ints]:
    """The first and the last vertex of every step within a patch, in one direction."""
    lines = number.shape[1]
    first, last = [], []
    for i, j in grid_steps():
        low, high = max(0, -j), lines - max(0, j)
        first.append(number[:, : lines - i, low:high].ravel())
        last.append(number[:, i:, low + j : high + j].ravel())
    a, b = np.concatenate(first), np.concatenate(last)
    proper = (a >= 0) & (b >= 0) & (a != b)
    return a[proper], b[proper]
