"""Meshes of a single patch in which given points are vertices at every level."""

from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.tessellation import grid_faces
from bodymeasure.bezier import evaluate

Scalar = TypeVar("Scalar", bound=np.generic)

# Cells along v for each cell along u. On square cells the diagonals, and paths near them, run
# along mesh edges for long stretches, and the error then does not fall smoothly: extrapolated
# lengths were five times worse. 8/5 is far from the ratios of small whole numbers.
CELLS_V_PER_U = 1.6

# Grid lines nearer than this are one line: thinner cells exhaust libigl's tolerances (from 1e-7
# on it ran out of memory). End points may be moved that much; the uncertainty counts it.
SAME_LINE = 1e-6


@dataclass(frozen=True, eq=False)
class PatchGrid:
    """Grid lines of one level over a patch's parameter square.

    Parameters
    ----------
    u, v : ndarray, shape (k,) and (l,)
        Where the lines lie, ascending from 0 to 1.
    """

    u: Array
    v: Array

    def vertex(self, point: Array) -> int:
        """Number of the vertex at (u, v), before collapsed edges are joined."""
        i = int(np.argmin(np.abs(self.u - point[0])))
        j = int(np.argmin(np.abs(self.v - point[1])))
        return i * len(self.v) + j

    def mesh(self, control_points: Array) -> tuple[Array, Ints, Ints]:
        """Triangles on a patch.

        Parameters
        ----------
        control_points : ndarray, shape (m + 1, n + 1, 3)

        Returns
        -------
        vertices : ndarray, shape (n, 3)
        faces : ndarray of int, shape (f, 3)
        number : ndarray of int, shape (k l,)
            The mesh's number for each vertex of the grid: the same for all those on an edge that
            is collapsed into one point.
        """
        collapsed = tuple(bool((net == net[0]).all()) for net in _sides(control_points))
        used, faces, number = _topology((len(self.u), len(self.v)), collapsed)
        parameters = np.stack(np.meshgrid(self.u, self.v, indexing="ij"), axis=-1)
        return evaluate(control_points, parameters.reshape(-1, 2)[used]), faces, number


# Nearly all patches of a body have the same few meshes.
@lru_cache(maxsize=16)
def _topology(shape: tuple[int, int], collapsed: tuple[bool, ...]) -> tuple[Ints, Ints, Ints]:
    """The points of a grid that are used, its triangles, and the number of each of its points."""
    grid = np.arange(shape[0] * shape[1]).reshape(shape)
    for edge, is_point in zip(_sides(grid), collapsed, strict=True):
        if is_point:
            edge[:] = edge[0]
    used, number = np.unique(grid, return_inverse=True)
    number = number.reshape(-1).astype(np.int64)
    faces = grid_faces(number.reshape(shape))
    return used, faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)], number


def grid_lines(points: Array) -> tuple[Array, Array]:
    """The u and the v through which lines must run so that all the points are vertices.

    Parameters
    ----------
    points : ndarray, shape (k, 2)
        (u, v) in [0, 1].

    Returns
    -------
    lines_u, lines_v : ndarray
        Ascending from 0 to 1.
    """
    return _distinct(points[:, 0]), _distinct(points[:, 1])


def refined_grid(lines_u: Array, lines_v: Array, coarsest: int, refinement: int) -> PatchGrid:
    """Return a grid through the given lines that refines the coarsest such grid.

    Between neighboring lines the steps are even, and each refinement divides those of the
    coarsest grid, so that the error has one expansion in powers of the step.

    Parameters
    ----------
    lines_u, lines_v : ndarray
        As `grid_lines` gives them.
    coarsest : int
        About how many segments the coarsest grid has along the whole of u; it has `CELLS_V_PER_U`
        times as many along v. Each strip has at least one.
    refinement : int
        The number of parts into which each of those is divided.
    """
    return PatchGrid(
        _subdivided(lines_u, coarsest, refinement),
        _subdivided(lines_v, coarsest * CELLS_V_PER_U, refinement),
    )


def _distinct(values: Array) -> Array:
    """0, the values and 1 in order, without those within `SAME_LINE` of the one before."""
    inner = np.unique(values[(values > SAME_LINE) & (values < 1.0 - SAME_LINE)])
    apart = inner[np.diff(inner, prepend=0.0) > SAME_LINE]
    return np.concatenate([[0.0], apart, [1.0]])


def _subdivided(lines: Array, density: float, refinement: int) -> Array:
    pieces = [
        np.linspace(low, high, refinement * max(1, round((high - low) * density)), endpoint=False)
        for low, high in pairwise(lines.tolist())
    ]
    return np.concatenate([*pieces, [1.0]])


def _sides(array: NDArray[Scalar]) -> list[NDArray[Scalar]]:
    """Views of the four sides of a grid."""
    return [array[0], array[-1], array[:, 0], array[:, -1]]
