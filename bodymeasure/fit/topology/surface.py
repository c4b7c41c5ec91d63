"""Our surface through given points, at the vertices of the quad mesh and in its quads' middles."""

from functools import cache
from typing import Any

import numpy as np
from scipy.sparse import csr_matrix, vstack
from scipy.sparse.linalg import splu

from bodymeasure._typing import Array
from bodymeasure.fit.model import body_model, limit_matrix


@cache
def sample_matrix() -> csr_matrix:
    """Return the matrix, (26758, 13380), from the vertices to points of the limit surface.

    First the limits of the vertices, then the points in the middle of the quads: there, after one
    step of subdivision, the valence is 4, and the limit of the new vertex F with its four edge
    points E and the four moved corners V is ``(16 F + 4 sum E + sum V) / 36``.
    """
    quads, count = body_model().quads, len(body_model().mean)
    number = np.arange(len(quads))
    of_quad, corners = np.repeat(number, 4), quads.ravel()
    following = np.roll(quads, -1, axis=1).ravel()

    def matrix(weights: Any, rows: Any, columns: Any, shape: tuple[int, int]) -> csr_matrix:
        return csr_matrix((np.broadcast_to(weights, len(rows)), (rows, columns)), shape=shape)

    middles = matrix(0.25, of_quad, corners, (len(quads), count))
    valence = np.bincount(corners).astype(float)
    # Every edge belongs to two quads, one for each direction.
    mean_of_neighbors = matrix(1.0 / valence[corners], corners, following, (count, count))
    mean_of_quads = matrix(1.0 / valence[corners], corners, of_quad, (count, len(quads))) @ middles
    own = csr_matrix((1.0 - 2.0 / valence, (np.arange(count), np.arange(count))))
    # (quads + 2 midpoints + (n - 3) own) / n, where a midpoint is half own and half neighbor.
    ends = csr_matrix((1.0 / valence, (np.arange(count), np.arange(count))))
    moved = ends @ mean_of_quads + ends @ mean_of_neighbors + own
    # An edge point is the mean of the edge's ends and of the middles of its two quads.
    key = dict(zip((corners * count + following).tolist(), of_quad.tolist(), strict=True))
    across = np.array([key[one] for one in (following * count + corners).tolist()])
    halves = np.concatenate([of_quad, of_quad])
    edges = matrix(0.25, halves, np.concatenate([corners, following]), (len(quads), count))
    beside = matrix(0.25, halves, np.concatenate([of_quad, across]), (len(quads), len(quads)))
    edge_sums = edges + beside @ middles
    corner_sums = matrix(1.0, of_quad, corners, (len(quads), count)) @ moved
    limits = (16.0 * middles + 4.0 * edge_sums + corner_sums) / 36.0
    return vstack([limit_matrix(), limits]).tocsr()


def close_to_samples(places: Array) -> Array:
    """Return the control vertices whose surface is closest to places, shape (26758, 3).

    Least squares, so that the facets of a mesh on which the places lie average out.
    """
    return np.asarray(_squares().solve(sample_matrix().T @ places))


@cache
def _squares() -> Any:
    normal = (sample_matrix().T @ sample_matrix()).tocsc()
    return splu(normal, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})
