"""Limit positions of the body's Catmull-Clark surface as a fixed linear map of its vertices."""

from functools import cache

import numpy as np
from scipy.sparse import csr_matrix

from bodymeasure._typing import Ints
from bodymeasure.fit.model.space import body_model


@cache
def limit_matrix() -> csr_matrix:
    """Return the matrix, (13380, 13380), that takes the vertices to their limit positions."""
    return limit_weights(body_model().quads)


def limit_weights(quads: Ints) -> csr_matrix:
    """Return the matrix that takes the vertices of a closed quad mesh to their limit positions.

    Parameters
    ----------
    quads : ndarray of int, shape (m, 4)
        Numbers of the vertices 0 to n - 1; each edge belongs to two quads.

    Returns
    -------
    csr_matrix, shape (n, n)

    Notes
    -----
    The weights are those of `bodymeasure.subdivision.limit_positions`.
    """
    valence = np.bincount(quads.ravel()).astype(float)
    count = len(valence)
    corners = quads.ravel()
    # Each neighbor along an edge is the next corner of exactly one quad.
    rows = np.concatenate([corners, corners, np.arange(count)])
    beside, across = np.roll(quads, -1, axis=1).ravel(), np.roll(quads, 2, axis=1).ravel()
    columns = np.concatenate([beside, across, np.arange(count)])
    ones = np.ones(len(corners))
    weights = np.concatenate([4.0 * ones, ones, valence**2])
    weights /= (valence * (valence + 5.0))[rows]
    return csr_matrix((weights, (rows, columns)), shape=(count, count))
