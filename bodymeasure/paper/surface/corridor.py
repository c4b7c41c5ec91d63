"""Corridors: parts of a surface around a path that a shorter path cannot leave."""

from collections.abc import Iterator

import numpy as np
import scipy
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.paper.surface.fine_surface import FineSurface
from bodymeasure.subdivision import QuadMesh, children, fill_pinches, part, quads_within


class Corridors:
    """The corridors of one surface, by the quads of its coarsest mesh."""

    def __init__(self, surface: FineSurface) -> None:
        self.surface = surface
        self.tree = scipy.spatial.KDTree(surface.meshes[0].vertices)

    def around(self, path: Array, half_width: float) -> Bools:
        """Return the quads of the coarsest mesh within a distance of a path's points (k, 3).

        They form one piece, on which the first point of the path lies, and a manifold.
        """
        coarse = self.surface.meshes[0]
        near = np.unique(np.concatenate(self.tree.query_ball_point(path, half_width)))
        _, first = self.tree.query(path[0])
        chosen = quads_within(coarse, np.append(near, first).astype(np.int64), 1)
        chosen = fill_pinches(coarse, chosen)
        label = np.full(len(chosen), -1)
        label[chosen] = _pieces(coarse, chosen)
        home = label[(coarse.quads == first).any(axis=1) & chosen][0]
        return np.asarray(label == home)

    def meshes(self, chosen: Bools) -> Iterator[QuadMesh]:
        """Yield the same part of each mesh of the surface, from coarse to fine."""
        for step, mesh in enumerate(self.surface.meshes):
            yield part(mesh, children(chosen, step))[0]


def shortest_way_out(mesh: QuadMesh, start: Array, end: Array) -> float:
    """Return a lower bound of the lengths of all paths between two points that leave a part.

    Parameters
    ----------
    mesh : QuadMesh
        The part of the surface.
    start, end : ndarray, shape (3,)

    Returns
    -------
    float
        The least sum of distances from the ends to a vertex of the part's boundary, which such a
        path crosses, less the length of the longest edge, by which the sum can be smaller between
        vertices.
    """
    ends = mesh.vertices[mesh.edges.ends[mesh.edges.boundary]]
    if not len(ends):
        return np.inf
    sums = np.linalg.norm(ends - start, axis=-1) + np.linalg.norm(ends - end, axis=-1)
    longest = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=-1).max()
    return float(sums.min() - longest)


def _pieces(mesh: QuadMesh, chosen: Bools) -> Ints:
    """Return the number of the piece to which each chosen quad belongs; quads meet at edges."""
    count = int(chosen.sum())
    edges = mesh.edges.of_side[chosen]
    quads = np.repeat(np.arange(count), 4)
    incidence = coo_array(
        (np.ones(4 * count), (quads, edges.ravel())), shape=(count, len(mesh.edges.ends))
    ).tocsr()
    _, label = connected_components(incidence @ incidence.T, directed=False)
    return np.asarray(label)
