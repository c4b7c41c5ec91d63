"""Cloth under tension over a body, which holds it up, and from which it hangs free over hollows."""

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints

# Rounds in which the places are found where the cloth lies on the body.
ROUNDS = 40
# How much stiffer the body is than the cloth: it gives by this part of a micrometer or so.
STIFF = 1e3
# Parts of the body's size: depths below its surface, and moves in a round, that are rounding.
DEEP, STILL = 1e-6, 1e-6
# The part of a tension at which rounding pulls cloth off a plane place.
PULL = 1e-9


def hanging(
    positions: Array, normals: Array, stiffness: scipy.sparse.csr_array, free: Bools, aside: Array
) -> Array:
    """Return where cloth hangs that lies on a body at first, shape (n, 3).

    Parameters
    ----------
    positions : ndarray, shape (n, 3)
        Of vertices on the body.
    normals : ndarray, shape (n, 3)
        Unit vectors that point outwards.
    stiffness : csr_array, shape (n, n)
        The quadratic form of the cloth's tension in one coordinate.
    free : ndarray of bool, shape (n,)
        Which vertices may leave their places.
    aside : ndarray, shape (n, 3)
        The unit vectors along which some of these may not move, as at a fold; 0 for all others.

    Notes
    -----
    An obstacle problem with an active set. A vertex sticks to its place until the tension of those
    about it pulls it outwards. So cloth peels off the underside of a bust, where the normals point
    down, as that below it pulls it down. What then comes to lie on the body elsewhere may slide
    along it, on the plane through the nearest vertex, until it is pulled outwards again.
    """
    size, tension = float(np.ptp(positions, axis=0).max()), float(stiffness.diagonal().max())
    tree = scipy.spatial.cKDTree(positions)
    moved = positions.copy()
    off, sliding = np.zeros(len(free), dtype=np.bool_), np.zeros(len(free), dtype=np.bool_)
    nearest = np.arange(len(free))
    for _ in range(ROUNDS):
        force = -(stiffness @ moved)
        outwards = (force * normals[nearest]).sum(axis=1)
        leaving = free & ~off & (outwards > PULL * tension * size)
        off |= leaving
        sliding &= outwards <= 0.0
        rows = np.flatnonzero(off)
        if not len(rows):
            break
        bars = [(rows[sliding[rows]], normals[nearest], positions[nearest])]
        bars.append((np.flatnonzero(off & aside.any(axis=1)), aside, positions))
        before = moved[rows]
        moved[rows] = _at_rest(stiffness, positions, rows, bars)
        _, near = tree.query(moved[rows])
        depth = ((moved[rows] - positions[near]) * normals[near]).sum(axis=1)
        nearest[rows] = near
        struck = np.zeros_like(sliding)
        struck[rows[depth < -DEEP * size]] = True
        still = np.abs(moved[rows] - before).max() <= STILL * size
        if still and not leaving.any() and not (struck & ~sliding).any():
            break
        sliding |= struck
    return moved


def _at_rest(
    stiffness: scipy.sparse.csr_array,
    positions: Array,
    rows: Ints,
    bars: list[tuple[Ints, Array, Array]],
) -> Array:
    """Return where some vertices come to rest while all others are in their places.

    Parameters
    ----------
    stiffness : csr_array, shape (n, n)
    positions : ndarray, shape (n, 3)
    rows : ndarray of int, shape (k,)
    bars : list of tuple
        Vertices, and for all of them the unit vectors along which these stay at the level of the
        points that follow.
    """
    number = np.full(len(positions), -1)
    number[rows] = np.arange(len(rows))
    held = np.ones(len(positions), dtype=np.bool_)
    held[rows] = False
    pulled = -(stiffness[rows][:, held] @ positions[held])
    matrix = scipy.sparse.kron(stiffness[rows][:, rows], scipy.sparse.eye_array(3))
    stiff = STIFF * float(stiffness.diagonal().max())
    entries = [(np.zeros(0), np.zeros(0, np.int64), np.zeros(0, np.int64))]
    for barred, ways, points in bars:
        way, place = ways[barred], 3 * number[barred]
        blocks = stiff * way[:, :, None] * way[:, None, :]
        row, column = np.broadcast_arrays(np.arange(3)[:, None], np.arange(3))
        entries.append(
            (
                blocks.ravel(),
                (place[:, None, None] + row).ravel(),
                (place[:, None, None] + column).ravel(),
            )
        )
        level = stiff * (way * points[barred]).sum(axis=1)
        np.add.at(pulled, number[barred], level[:, None] * way)
    data, row, column = (np.concatenate(parts) for parts in zip(*entries, strict=True))
    bar = scipy.sparse.coo_array((data, (row, column)), shape=matrix.shape)
    solve = scipy.sparse.linalg.splu((matrix + bar).tocsc()).solve
    return np.asarray(solve(pulled.ravel()).reshape(-1, 3))
