"""Creases of the skin, as in an armpit, where an offset along normals would fold the cloth."""

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints

# The least part to which the offset may shrink a triangle in any direction, and the least cosine by
# which it may turn it.
LEAST, FACING = 0.4, 0.2
# Rounds in which creases are found, and grow by a ring of triangles where they still fold.
ROUNDS = 12


def without_creases(positions: Array, triangles: Ints, ways: Array, offsets: Array) -> Array:
    """Return ways in which vertices may move without folding the mesh.

    Parameters
    ----------
    positions : ndarray, shape (n, 3)
    triangles : ndarray of int, shape (k, 3)
    ways : ndarray, shape (n, 3)
        Unit vectors.
    offsets : ndarray, shape (n,)
        How far they move.

    Returns
    -------
    ndarray, shape (n, 3)
        Those given, but in creases, where they are as even as they can be between the ways round
        about: the same on both sides of a narrow one.
    """
    links = _links(triangles, len(positions))
    crease = np.zeros(len(positions), dtype=np.bool_)
    ways = ways.copy()
    checked = triangles
    for _ in range(ROUNDS):
        folds = _folded(positions, checked, positions + offsets[:, None] * ways)
        if not folds.any():
            break
        wider = np.zeros_like(crease)
        wider[checked[folds]] = True
        crease |= wider | (links @ wider)
        inner, rim = np.flatnonzero(crease), np.flatnonzero(~crease & (links @ crease))
        if not len(rim):
            break
        degree = scipy.sparse.diags_array(np.asarray(links[inner].sum(axis=1), dtype=np.float64))
        within = links[inner][:, inner].astype(np.float64)
        right = links[inner][:, rim].astype(np.float64) @ ways[rim]
        ways[inner] = scipy.sparse.linalg.splu((degree - within).tocsc()).solve(right)
        # No others move otherwise than in the round before.
        checked = triangles[crease[triangles].any(axis=1)]
    return ways


def _links(triangles: Ints, count: int) -> scipy.sparse.csr_array:
    """Return which vertices are neighbors."""
    start, stop = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    pair = np.concatenate([start, stop]), np.concatenate([stop, start])
    shape = (count, count)
    links = scipy.sparse.coo_array((np.ones(len(pair[0]), dtype=np.bool_), pair), shape=shape)
    return links.tocsr()


def _folded(before: Array, triangles: Ints, after: Array) -> Bools:
    """Return the triangles that shrink or turn too much."""
    sides = [
        np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2)
        for corners in (before[triangles], after[triangles])
    ]
    normals = [np.cross(side[..., 0], side[..., 1]) for side in sides]
    sizes = [np.linalg.norm(normal, axis=1) for normal in normals]
    usable = sizes[0] > 0.0
    facing = (normals[0] * normals[1]).sum(axis=1) < FACING * sizes[0] * sizes[1]
    metric = [side.transpose(0, 2, 1) @ side for side in sides]
    # The squares of both principal stretches have the ratio of metrics as their matrix.
    metric[0][~usable] = metric[1][~usable] = np.eye(2)
    ratio = np.linalg.solve(metric[0], metric[1])
    half = 0.5 * np.trace(ratio, axis1=1, axis2=2)
    least = half - np.sqrt(np.maximum(half**2 - np.linalg.det(ratio), 0.0))
    return np.asarray(usable & (facing | (least < LEAST**2)))
