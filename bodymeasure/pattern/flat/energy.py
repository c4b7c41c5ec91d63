"""The energy of a flat piece: how much its triangles are stretched, and how its edges ripple."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.pattern.flat.triangles import determinants, inverses, laid_out

# The weight of third differences along edges, against ripples between neighboring vertices that
# neither lengths nor triangles feel much.
SMOOTH = 0.3


@dataclass(frozen=True, eq=False)
class Stretch:
    """The deformation of triangles from their shape on the skin.

    Parameters
    ----------
    triangles : ndarray of int, shape (k, 3)
    sides : ndarray, shape (k, 3)
        The lengths on the skin from each corner to the next.
    """

    triangles: Ints
    sides: Array

    @cached_property
    def _gradients(self) -> Array:
        """The maps from corners to deformations, shape (k, 3, 2)."""
        rest = laid_out(self.sides).transpose(0, 2, 1)
        inverse = inverses(rest)
        return np.concatenate([-inverse.sum(axis=1, keepdims=True), inverse], axis=1)

    @cached_property
    def area(self) -> Array:
        """The areas on the skin, shape (k,)."""
        return np.asarray(0.5 * determinants(laid_out(self.sides)))

    def deformations(self, flat: Array) -> Array:
        """Return the deformation of each triangle, shape (k, 2, 2)."""
        return np.asarray(flat[self.triangles].transpose(0, 2, 1) @ self._gradients)

    def flipped(self, flat: Array) -> Bools:
        """Return which triangles lie on their faces, shape (k,)."""
        return np.asarray(determinants(self.deformations(flat)) <= 0.0)

    def strains(self, flat: Array) -> Array:
        """Return the principal strains of each triangle, the larger one first, shape (k, 2)."""
        return np.asarray(np.linalg.svd(self.deformations(flat), compute_uv=False) - 1.0)

    def residuals(self, flat: Array) -> Array:
        """Return three residuals a triangle, shape (k, 3).

        The sum of their squares is the area times ``|C - C^-1|^2 / 32`` with ``C = F^T F`` for a
        deformation F: half the sum of squares of the principal strains where these are small, the
        same for a stretch and its inverse, and infinite where a triangle flips.
        """
        f = self.deformations(flat)
        c = f.transpose(0, 2, 1) @ f
        return self._packed(c - inverses(c))

    def _packed(self, symmetric: Array) -> Array:
        root = np.sqrt(2.0)
        packed = np.stack(
            [symmetric[..., 0, 0], symmetric[..., 1, 1], root * symmetric[..., 0, 1]], axis=-1
        )
        scale = np.sqrt(self.area / 32.0)
        return np.asarray(packed * scale.reshape(-1, *(1,) * (packed.ndim - 1)))

    def gradient(self, flat: Array) -> Array:
        """Return the derivatives of half the sum of squares by the corners, shape (k, 3, 2)."""
        f = self.deformations(flat)
        c = f.transpose(0, 2, 1) @ f
        inverse = inverses(c)
        m = (self.area / 32.0)[:, None, None] * (c - inverse)
        pull = f @ (m + inverse @ m @ inverse)
        return np.asarray(2.0 * self._gradients @ pull.transpose(0, 2, 1))

    def curvature(self, flat: Array, *, full: bool) -> Array:
        """Return the second derivatives of half the sum of squares by the corners, (k, 6, 6).

        Those of Gauss and Newton, which are positive, leave out what the residuals' own second
        derivatives add, unless `full`.
        """
        f, g = self.deformations(flat), self._gradients
        c = f.transpose(0, 2, 1) @ f
        inverse = inverses(c)
        # The change of F when a corner's coordinate grows has one row, that corner's gradient.
        change = np.einsum("kda,kcb->kcdab", f, g)
        change = (change + change.swapaxes(-1, -2)).reshape(-1, 6, 2, 2)
        by_inverse = change @ inverse[:, None]
        residuals = self._packed(change + inverse[:, None] @ by_inverse)
        result = residuals @ residuals.transpose(0, 2, 1)
        if not full:
            return np.asarray(result)
        m = (self.area / 32.0)[:, None, None] * (c - inverse)
        p, q = m + inverse @ m @ inverse, inverse @ m @ inverse
        left = (q[:, None] @ by_inverse).reshape(-1, 6, 4)
        right = change.swapaxes(-1, -2).reshape(-1, 6, 4)
        product = left @ right.transpose(0, 2, 1)
        result -= product + product.transpose(0, 2, 1)
        same = 2.0 * g @ p @ g.transpose(0, 2, 1)
        result[:, 0::2, 0::2] += same
        result[:, 1::2, 1::2] += same
        return np.asarray(result)


class Energy:
    """The sum of squares that is least on the finished piece.

    Parameters
    ----------
    stretch : Stretch
    chains : sequence of ndarray of int
        The vertices along each edge.
    count : int
        The number of vertices.
    """

    def __init__(self, stretch: Stretch, chains: list[Ints], count: int) -> None:
        self.stretch, self.count = stretch, count
        self._ripple = _ripple(chains, count)
        corners = stretch.triangles
        self._index = np.stack([2 * corners, 2 * corners + 1], axis=2).reshape(-1, 6)
        rows = np.repeat(self._index, 6, axis=1).ravel()
        columns = np.tile(self._index, (1, 6)).ravel()
        # Where each entry of the triangles' own matrices goes, found once for all steps.
        keys = rows * (2 * count) + columns
        self._order = np.argsort(keys, kind="stable")
        keys = keys[self._order]
        self._first = np.flatnonzero(np.concatenate([[True], keys[1:] != keys[:-1]]))
        self._entries = np.divmod(keys[self._first], 2 * count)

    def value(self, flat: Array) -> float:
        """Return half the sum of squares; infinite where a triangle is flipped."""
        if self.stretch.flipped(flat).any():
            return np.inf
        residuals = self.stretch.residuals(flat)
        if not np.isfinite(residuals).all():
            return np.inf
        x = flat.ravel()
        return 0.5 * float((residuals**2).sum() + x @ (self._ripple @ x))

    def gradient(self, flat: Array) -> Array:
        """Return the derivatives by all coordinates, shape (2 n,)."""
        own = self.stretch.gradient(flat).ravel()
        summed = np.bincount(self._index.ravel(), weights=own, minlength=2 * self.count)
        return np.asarray(summed + self._ripple @ flat.ravel())

    def curvature(self, flat: Array, *, full: bool) -> scipy.sparse.csr_array:
        """Return the second derivatives; those of Gauss and Newton, unless `full`."""
        blocks = self.stretch.curvature(flat, full=full).ravel()[self._order]
        entries = np.add.reduceat(blocks, self._first), self._entries
        shape = (2 * self.count, 2 * self.count)
        return (scipy.sparse.coo_array(entries, shape=shape).tocsr() + self._ripple).tocsr()


def _ripple(chains: list[Ints], count: int) -> scipy.sparse.csr_array:
    """Return the quadratic form of third differences along chains, shape (2 n, 2 n)."""
    rows = [
        np.stack([chain[i : len(chain) - 3 + i] for i in range(4)], axis=1)
        for chain in chains
        if len(chain) > 3
    ]
    columns = np.concatenate(rows) if rows else np.zeros((0, 4), dtype=np.int64)
    row = np.repeat(np.arange(len(columns)), 4)
    weights = np.tile(SMOOTH * np.array([-1.0, 3.0, -3.0, 1.0]), len(columns))
    shape = (len(columns), count)
    third = scipy.sparse.coo_array((weights, (row, columns.ravel())), shape=shape).tocsr()
    return scipy.sparse.kron(third.T @ third, scipy.sparse.eye_array(2)).tocsr()
