"""Meshes of quadrilaterals, open or closed, with vertices of any valence."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.errors import InputError


class Edges(NamedTuple):
    """The edges of a quad mesh.

    Parameters
    ----------
    ends : ndarray of int, shape (edges, 2)
        Vertex numbers, the lower first.
    of_side : ndarray of int, shape (quads, 4)
        The edge of each quad from its corner k to the next.
    quads : ndarray of int, shape (edges,)
        How many quads have it: 2, or 1 on the boundary.
    """

    ends: Ints
    of_side: Ints
    quads: Ints

    @property
    def boundary(self) -> Bools:
        """Which edges lie on the boundary, shape (edges,)."""
        return np.asarray(self.quads == 1)


@dataclass(frozen=True, eq=False)
class QuadMesh:
    """A manifold mesh of quadrilaterals.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    quads : ndarray of int, shape (m, 4)
        Vertex numbers round each quad; every vertex belongs to one.

    Raises
    ------
    InputError
        If a shape or number is not what is said above. Whether the mesh is a manifold is seen when
        its edges are asked for.
    """

    vertices: Array
    quads: Ints

    def __post_init__(self) -> None:
        vertices, quads = self.vertices, self.quads
        if vertices.ndim != 2 or vertices.shape[1] != 3:
            raise InputError(f"mesh vertices have shape {vertices.shape}; expected (n, 3)")
        if quads.ndim != 2 or quads.shape[1] != 4 or len(quads) == 0:
            raise InputError(f"quads have shape {quads.shape}; expected (m, 4), at least one")
        if quads.min() < 0 or quads.max() >= len(vertices):
            raise InputError(
                f"quads refer to vertices {quads.min()} to {quads.max()}, but they are numbered "
                f"0 to {len(vertices) - 1}"
            )
        unused = np.flatnonzero(np.bincount(quads.ravel(), minlength=len(vertices)) == 0)
        if len(unused):
            raise InputError(f"mesh vertex {unused[0]} belongs to no quad; remove it")

    @cached_property
    def edges(self) -> Edges:
        """The edges.

        Raises
        ------
        InputError
            If more than two quads meet at one.
        """
        tail, head = self.quads, np.roll(self.quads, -1, axis=1)
        key = np.minimum(tail, head) * len(self.vertices) + np.maximum(tail, head)
        unique, of_side, quads = np.unique(key, return_inverse=True, return_counts=True)
        ends = np.stack(np.divmod(unique, len(self.vertices)), axis=-1)
        crowded = np.flatnonzero(quads > 2)
        if len(crowded):
            raise InputError(
                f"mesh edge {tuple(ends[crowded[0]].tolist())} belongs to {quads[crowded[0]]} "
                "quads; expected at most 2 (a manifold)"
            )
        return Edges(ends, of_side.reshape(self.quads.shape), quads)


def triangles(quads: Ints) -> Ints:
    """Two triangles for each quad, cut from its first corner to its third; shape (2 m, 3)."""
    return quads[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)
