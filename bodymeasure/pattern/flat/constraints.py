"""What a flat piece has to keep: lengths of sides, and places that depend linearly on others."""

from dataclasses import dataclass

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints


@dataclass(frozen=True, eq=False)
class Constraints:
    """Equations for the vertices of a flat piece.

    Parameters
    ----------
    pairs : ndarray of int, shape (m, 2)
        Vertices whose distance is given.
    lengths : ndarray, shape (m,)
    linear : csr_array, shape (p, 2 n)
        Rows of linear equations for the coordinates.
    right : ndarray, shape (p,)
        Their right sides.
    """

    pairs: Ints
    lengths: Array
    linear: scipy.sparse.csr_array
    right: Array

    def values(self, flat: Array) -> Array:
        """Return by how much the equations are missed, all of them lengths, shape (m + p,)."""
        way = flat[self.pairs[:, 1]] - flat[self.pairs[:, 0]]
        stretched = ((way**2).sum(axis=1) - self.lengths**2) / (2.0 * self.lengths)
        return np.concatenate([stretched, self.linear @ flat.ravel() - self.right])

    def jacobian(self, flat: Array) -> scipy.sparse.csr_array:
        """Return the derivatives of the values, shape (m + p, 2 n)."""
        way = (flat[self.pairs[:, 1]] - flat[self.pairs[:, 0]]) / self.lengths[:, None]
        start, stop = self.pairs.T
        columns = np.stack([2 * start, 2 * start + 1, 2 * stop, 2 * stop + 1], axis=1)
        weights = np.concatenate([-way, way], axis=1)
        rows = np.repeat(np.arange(len(self.pairs)), 4)
        shape = (len(self.pairs), flat.size)
        own = scipy.sparse.coo_array((weights.ravel(), (rows, columns.ravel())), shape=shape)
        return scipy.sparse.vstack([own.tocsr(), self.linear]).tocsr()

    def curvature(self, multipliers: Array, count: int) -> scipy.sparse.csr_array:
        """Return the second derivatives of the values, times their multipliers."""
        weight = multipliers[: len(self.pairs)] / self.lengths
        start, stop = self.pairs.T
        rows = np.concatenate([start, stop, start, stop])
        columns = np.concatenate([start, stop, stop, start])
        weights = np.concatenate([weight, weight, -weight, -weight])
        links = scipy.sparse.coo_array((weights, (rows, columns)), shape=(count, count))
        return scipy.sparse.kron(links.tocsr(), scipy.sparse.eye_array(2)).tocsr()
