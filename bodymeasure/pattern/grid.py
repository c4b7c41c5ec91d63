"""A mesh of all patches of an atlas whose vertices on sides are shared by the atlas's own edges."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import EDGES, Atlas, edge_table

# Cells along the side of a patch. The mesh only serves to lay the piece out roughly and to say
# where on the skin its points are.
CELLS = 8


@dataclass(frozen=True, eq=False)
class Grid:
    """The vertices of the regular mesh of an atlas.

    Parameters
    ----------
    vertex : ndarray of int, shape (patches, CELLS + 1, CELLS + 1)
        The number of each vertex; axis 1 runs with u, axis 2 with v.
    count : int
    """

    vertex: Ints
    count: int


@lru_cache(maxsize=4)
def regular_grid(atlas: Atlas) -> Grid:
    """Return the regular mesh of an atlas, which is kept for the next piece."""
    table = edge_table(atlas.index)
    patches = len(atlas)
    vertex = np.full((patches, CELLS + 1, CELLS + 1), -1, dtype=np.int64)
    corners = atlas.index[:, [0, 0, -1, -1], [0, -1, 0, -1]]
    _, corner = np.unique(corners, return_inverse=True)
    corner = corner.reshape(patches, 4)
    count = int(corner.max()) + 1
    along = np.arange(1, CELLS)
    for number, side in enumerate(EDGES):
        places = count + table.edge[:, number, None] * (CELLS - 1) + along - 1
        places = np.where(table.reversed[:, number, None], places[:, ::-1], places)
        fixed = -1 if side.fixed_value else 0
        if side.fixed_axis == 0:
            vertex[:, fixed, 1:-1] = places
        else:
            vertex[:, 1:-1, fixed] = places
    count += int(table.edge.max() + 1) * (CELLS - 1)
    inner = np.arange(patches * (CELLS - 1) ** 2).reshape(patches, CELLS - 1, CELLS - 1)
    vertex[:, 1:-1, 1:-1] = count + inner
    count += inner.size
    vertex[:, [0, 0, -1, -1], [0, -1, 0, -1]] = corner
    # A collapsed side is one point.
    for number, side in enumerate(EDGES):
        rows = np.flatnonzero(table.collapsed[:, number])
        fixed = -1 if side.fixed_value else 0
        if side.fixed_axis == 0:
            vertex[rows, fixed, :] = vertex[rows, fixed, :1]
        else:
            vertex[rows, :, fixed] = vertex[rows, :1, fixed]
    return Grid(vertex, count)


def cell_triangles() -> tuple[Ints, Array]:
    """Return the triangles of one patch: grid places (k, 3, 2), and their parameters (k, 3, 2)."""
    i, j = (axis.ravel() for axis in np.meshgrid(*(2 * [np.arange(CELLS)]), indexing="ij"))
    lower = np.stack([[i, j], [i + 1, j], [i + 1, j + 1]], axis=0)
    upper = np.stack([[i, j], [i + 1, j + 1], [i, j + 1]], axis=0)
    places = np.concatenate([lower.transpose(2, 0, 1), upper.transpose(2, 0, 1)])
    return places, places / CELLS
