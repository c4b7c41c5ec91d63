"""Quadrilaterals in the plane whose sides and diagonals come closest to given lengths."""

import numpy as np

from bodymeasure._typing import Array, Bools

# The corners that each length joins: the four sides in turn, then both diagonals.
FIRST = np.array([0, 1, 2, 3, 0, 1])
LAST = np.array([1, 2, 3, 0, 2, 3])
# Six lengths determine the five degrees of freedom of a quadrilateral but for one, so that the
# residuals are small and each step of Gauss and Newton gains digits. Flat quadrilaterals, whose
# equations are nearly dependent, take the most.
STEPS = 30
# The last step, as a part of the longest side, after which only rounding is left.
LAST_STEP = 1e-13
# Part of the largest diagonal element by which the normal equations are kept regular where a side
# has collapsed and two of them are the same.
DAMPING = 1e-12


def flat_quadrilaterals(lengths: Array) -> Array:
    """Return the corners of the quadrilaterals whose six lengths fit best.

    Parameters
    ----------
    lengths : ndarray, shape (k, 6)
        Of the sides from corner 0 to 1, 1 to 2, 2 to 3 and 3 to 0, and of the diagonals from 0 to 2
        and from 1 to 3.

    Returns
    -------
    ndarray, shape (k, 4, 2)
        The sum of the squares of the six differences is the least. Corner 0 is the origin, corner 1
        lies on the first axis, and the corners run counterclockwise.

    Notes
    -----
    The Bijective Pattern Map of Ng, Pong and Wong (2007) has five unknowns: the place of corner 1
    on its axis, and the places of corners 2 and 3.
    """
    size = lengths.max(axis=1, keepdims=True)
    scaled = lengths / size
    # The longest side is the base: a collapsed one has no direction.
    turn = scaled[:, :4].argmax(axis=1)
    corner = (np.arange(4) + turn[:, None]) % 4
    sides = np.take_along_axis(scaled[:, :4], corner, axis=1)
    swapped = (turn % 2 == 1)[:, None]
    across = np.where(swapped, scaled[:, [5, 4]], scaled[:, [4, 5]])
    wanted = np.concatenate([sides, across], axis=1)
    found = _solved(_first(wanted), wanted)
    back = np.empty_like(found)
    np.put_along_axis(back, corner[:, :, None], found, axis=1)
    return np.asarray(_upright(back) * size[:, :, None])


def lengths_of(corners: Array) -> Array:
    """Return the six lengths (..., 6) of quadrilaterals (..., 4, 2)."""
    return np.asarray(np.linalg.norm(corners[..., LAST, :] - corners[..., FIRST, :], axis=-1))


def turned_over(corners: Array) -> Bools:
    """Return which quadrilaterals (..., 4, 2) cross themselves or run clockwise."""

    def area(a: int, b: int, c: int) -> Array:
        one, other = (corners[..., end, :] - corners[..., a, :] for end in (b, c))
        return np.asarray(one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0])

    rounding = DAMPING * lengths_of(corners).max(axis=-1) ** 2
    ways = ((area(0, 1, 2), area(0, 2, 3)), (area(1, 2, 3), area(0, 1, 3)))
    # A quadrilateral is right if one diagonal at least cuts it in two triangles that both are.
    right = [np.minimum(*way) > -rounding for way in ways]
    empty = np.abs(ways[0][0] + ways[0][1]) <= rounding
    return np.asarray(~(right[0] | right[1]) | empty)


def _first(lengths: Array) -> Array:
    """Return corners as two triangles over the base give them."""
    base = lengths[:, 0]

    def apex(from_first: Array, from_last: Array) -> Array:
        x = (base**2 + from_first**2 - from_last**2) / (2.0 * base)
        return np.stack([x, np.sqrt(np.maximum(from_first**2 - x**2, 0.0))], axis=1)

    corners = np.zeros((len(lengths), 4, 2))
    corners[:, 1, 0] = base
    corners[:, 2] = apex(lengths[:, 4], lengths[:, 1])
    corners[:, 3] = apex(lengths[:, 3], lengths[:, 5])
    return corners


def _solved(corners: Array, wanted: Array) -> Array:
    # The unknowns are the coordinates without those of corner 0 and the second one of corner 1.
    free = np.array([2, 4, 5, 6, 7])
    rows = np.arange(6)
    for _ in range(STEPS):
        way = corners[:, LAST] - corners[:, FIRST]
        length = np.linalg.norm(way, axis=2)
        unit = np.divide(way, length[..., None], out=np.zeros_like(way), where=way != 0.0)
        jacobian = np.zeros((len(corners), 6, 4, 2))
        jacobian[:, rows, LAST] = unit
        jacobian[:, rows, FIRST] = -unit
        j = jacobian.reshape(-1, 6, 8)[:, :, free]
        normal = j.transpose(0, 2, 1) @ j
        normal += DAMPING * np.eye(5) * normal.max(axis=(1, 2), keepdims=True)
        right = j.transpose(0, 2, 1) @ (length - wanted)[..., None]
        step = np.linalg.solve(normal, right)[..., 0]
        flat = corners.reshape(-1, 8).copy()
        flat[:, free] -= step
        corners = flat.reshape(-1, 4, 2)
        if np.abs(step).max(initial=0.0) <= LAST_STEP:
            break
    return corners


def _upright(corners: Array) -> Array:
    """Return quadrilaterals with corner 0 in the origin and corner 1 on the first axis."""
    moved = corners - corners[:, :1]
    # A side without length gives no direction; the next one that has it does.
    along = np.where(
        np.abs(moved[:, 1]).max(axis=1, keepdims=True) > LAST_STEP, moved[:, 1], moved[:, 2]
    )
    along = along / np.linalg.norm(along, axis=1, keepdims=True)
    across = np.stack([-along[:, 1], along[:, 0]], axis=1)
    return np.asarray(moved @ np.stack([along, across], axis=2))
