"""Boundary first flattening: a conformal map whose border keeps its lengths."""

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.pattern.flat.triangles import angles

# The largest cotangent of an angle, so that slivers along a curve leave the equations regular.
LARGEST = 1e4


def flat_conformally(triangles: Ints, sides: Array, border: Ints) -> Array:
    """Return a disk in the plane, with the lengths of its border kept and its angles nearly so.

    Parameters
    ----------
    triangles : ndarray of int, shape (k, 3)
        All counterclockwise.
    sides : ndarray, shape (k, 3)
        The length from each corner to the next.
    border : ndarray of int, shape (m,)
        The vertices of the border in order, counterclockwise.

    Returns
    -------
    ndarray, shape (n, 2)

    Notes
    -----
    R. Sawhney and K. Crane, "Boundary First Flattening", ACM Trans. Graph. 37 (2017), with a scale
    of 1 on the border: a Poisson equation gives the angles by which the border turns in the plane;
    a curve with these angles is closed by the least change of its lengths, and the inside follows
    harmonically.
    """
    count = int(triangles.max()) + 1
    corner = angles(sides)
    laplacian = _cotangents(triangles, corner, count)
    sums = np.bincount(triangles.ravel(), weights=corner.ravel(), minlength=count)
    inner = np.setdiff1d(np.arange(count), border)
    solve = scipy.sparse.linalg.splu(laplacian[inner][:, inner].tocsc()).solve
    to_border = laplacian[inner][:, border]
    scale = solve(-(2.0 * np.pi - sums[inner]))
    flux = -(to_border.T @ scale)
    turn = np.pi - sums[border] - flux
    # The turns add up to one round but for rounding.
    turn += (2.0 * np.pi - turn.sum()) / len(border)
    following = {
        (start, stop): length
        for start, stop, length in zip(
            triangles.ravel().tolist(),
            np.roll(triangles, -1, axis=1).ravel().tolist(),
            sides.ravel().tolist(),
            strict=True,
        )
    }
    pairs = zip(border.tolist(), np.roll(border, -1).tolist(), strict=True)
    outline = _closed(np.array([following[pair] for pair in pairs]), turn)
    flat = np.empty((count, 2))
    flat[border] = outline
    flat[inner] = solve(-(to_border @ outline))
    return flat


def _cotangents(triangles: Ints, corner: Array, count: int) -> scipy.sparse.csr_array:
    """Return the Laplacian, which is positive."""
    weight = np.minimum(0.5 / np.tan(np.maximum(corner, 1e-12)), LARGEST)
    # The side from one corner to the next lies opposite the third.
    opposite = np.roll(weight, -2, axis=1).ravel()
    start, stop = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    rows, columns = np.concatenate([start, stop]), np.concatenate([stop, start])
    shape = (count, count)
    links = scipy.sparse.coo_array((np.tile(opposite, 2), (rows, columns)), shape=shape).tocsr()
    return (scipy.sparse.diags_array(links.sum(axis=1)) - links).tocsr()


def _closed(lengths: Array, turn: Array) -> Array:
    """Return a closed polygon with turns at its corners, and lengths nearest to given ones."""
    direction = np.cumsum(np.concatenate([[0.0], turn[1:]]))
    tangent = np.stack([np.cos(direction), np.sin(direction)])
    weighted = tangent * lengths
    gap = weighted @ np.ones(len(lengths))
    lengths = lengths - lengths * (tangent.T @ np.linalg.solve(weighted @ tangent.T, gap))
    steps = (tangent * lengths).T
    return np.asarray(np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)[:-1]]))
