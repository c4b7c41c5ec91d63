"""What a flat piece has to keep: lengths of sides and lines, and places that depend on others."""

from dataclasses import dataclass

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.pattern.flat.level_line import LevelLine


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
    lines : tuple of LevelLine
        Lines whose lengths are given, of which there are q.
    """

    pairs: Ints
    lengths: Array
    linear: scipy.sparse.csr_array
    right: Array
    lines: tuple[LevelLine, ...] = ()

    @property
    def count(self) -> int:
        """The number of equations: first the pairs, then the linear ones, then the lines."""
        return len(self.lengths) + len(self.right) + len(self.lines)

    def values(self, flat: Array) -> Array:
        """Return by how much the equations are missed, all of them lengths, shape (m + p + q,)."""
        way = flat[self.pairs[:, 1]] - flat[self.pairs[:, 0]]
        stretched = ((way**2).sum(axis=1) - self.lengths**2) / (2.0 * self.lengths)
        longer = [line.measured(flat) - line.length for line in self.lines]
        return np.concatenate([stretched, self.linear @ flat.ravel() - self.right, longer])

    def jacobian(self, flat: Array) -> scipy.sparse.csr_array:
        """Return the derivatives of the values, shape (m + p + q, 2 n)."""
        way = (flat[self.pairs[:, 1]] - flat[self.pairs[:, 0]]) / self.lengths[:, None]
        start, stop = self.pairs.T
        columns = np.stack([2 * start, 2 * start + 1, 2 * stop, 2 * stop + 1], axis=1)
        weights = np.concatenate([-way, way], axis=1)
        rows = np.repeat(np.arange(len(self.pairs)), 4)
        shape = (len(self.pairs), flat.size)
        own = scipy.sparse.coo_array((weights.ravel(), (rows, columns.ravel())), shape=shape)
        rest = [_by_vertices(line, flat) for line in self.lines]
        return scipy.sparse.vstack([own.tocsr(), self.linear, *rest]).tocsr()

    def curvature(self, multipliers: Array, flat: Array) -> scipy.sparse.csr_array:
        """Return the second derivatives of the values, times their multipliers."""
        count = len(flat)
        weight = multipliers[: len(self.pairs)] / self.lengths
        start, stop = self.pairs.T
        rows = np.concatenate([start, stop, start, stop])
        columns = np.concatenate([start, stop, stop, start])
        weights = np.concatenate([weight, weight, -weight, -weight])
        links = scipy.sparse.coo_array((weights, (rows, columns)), shape=(count, count))
        result = scipy.sparse.kron(links.tocsr(), scipy.sparse.eye_array(2)).tocsr()
        own = multipliers[len(self.lengths) + len(self.right) :]
        for line, multiplier in zip(self.lines, own.tolist(), strict=True):
            result = result + multiplier * _bend(line, flat)
        return result.tocsr()


def _by_vertices(line: LevelLine, flat: Array) -> scipy.sparse.csr_array:
    """The derivative of a line's length by all coordinates, shape (1, 2 n)."""
    ways = line.ways(flat)
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    weights = line.weights[:, :, None] * ways[:, None]
    columns = 2 * line.vertices[:, :, None] + np.arange(2)
    rows = np.zeros(columns.size, np.int64)
    entries = (weights.ravel(), (rows, columns.ravel()))
    return scipy.sparse.coo_array(entries, shape=(1, flat.size)).tocsr()


def _bend(line: LevelLine, flat: Array) -> scipy.sparse.csr_array:
    """The second derivative of a line's length by all coordinates, shape (2 n, 2 n)."""
    ways = line.ways(flat)
    size = np.linalg.norm(ways, axis=1)
    across = np.stack([-ways[:, 1], ways[:, 0]], axis=1) / size[:, None]
    # Each segment turns: the gradient of how far its end moves across it, over its length.
    turn = (line.weights[:, :, None] * across[:, None]).reshape(len(size), -1)
    columns = (2 * line.vertices[:, :, None] + np.arange(2)).reshape(len(size), -1)
    rows = np.repeat(np.arange(len(size)), turn.shape[1])
    turns = scipy.sparse.coo_array(
        ((turn / np.sqrt(size)[:, None]).ravel(), (rows, columns.ravel())),
        shape=(len(size), flat.size),
    ).tocsr()
    return (turns.T @ turns).tocsr()
