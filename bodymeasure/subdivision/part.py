"""Parts of a quad mesh, as masks of its quads."""

import numpy as np

from bodymeasure._typing import Bools, Ints
from bodymeasure.subdivision.quad_mesh import QuadMesh


def quads_within(mesh: QuadMesh, vertices: Ints | Bools, rings: int) -> Bools:
    """Return the quads of so many rings round given vertices.

    Parameters
    ----------
    mesh : QuadMesh
    vertices : ndarray of int or of bool
        Their numbers, or a mask.
    rings : int
        At least 1, which gives the quads that have one of the vertices.

    Returns
    -------
    ndarray of bool, shape (m,)
    """
    reached = np.zeros(len(mesh.vertices), dtype=np.bool_)
    reached[vertices] = True
    for _ in range(rings):
        chosen = np.asarray(reached[mesh.quads].any(axis=1))
        reached[mesh.quads[chosen]] = True
    return chosen


def part(mesh: QuadMesh, chosen: Bools) -> tuple[QuadMesh, Ints]:
    """Return the mesh of some of the quads.

    Returns
    -------
    mesh : QuadMesh
        Its quads and vertices in their old order.
    numbers : ndarray of int
        The old number of each of its vertices.
    """
    numbers, quads = np.unique(mesh.quads[chosen], return_inverse=True)
    return QuadMesh(mesh.vertices[numbers], quads.reshape(-1, 4)), numbers


def children(chosen: Bools, steps: int) -> Bools:
    """Return the quads that the chosen ones become by so many steps of `subdivide`."""
    return np.repeat(chosen, 4**steps)


def fill_pinches(mesh: QuadMesh, chosen: Bools) -> Bools:
    """Add quads to some quads until those round each vertex form one fan.

    Where a part of a mesh touches itself at a single vertex, it is not a manifold; there all quads
    round the vertex are added, until no such place is left.
    """
    chosen = chosen.copy()
    while True:
        used = np.unique(mesh.edges.of_side[chosen])
        quads = np.bincount(mesh.quads[chosen].ravel(), minlength=len(mesh.vertices))
        edges = np.bincount(mesh.edges.ends[used].ravel(), minlength=len(mesh.vertices))
        # An open fan has one edge more than quads, a closed one as many.
        pinched = edges - quads > 1
        if not pinched.any():
            return chosen
        chosen |= pinched[mesh.quads].any(axis=1)
