"""Triangles from the lengths of their sides."""

import numpy as np

from bodymeasure._typing import Array, Ints

# The least height of a triangle above its side, as a part of another side.
NARROWEST = 0.01


def side_lengths(positions: Array, triangles: Ints) -> Array:
    """Return the lengths (k, 3) of the sides from each corner of triangles to the next."""
    corners = positions[triangles]
    return np.asarray(np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2))


def laid_out(sides: Array) -> Array:
    """Return triangles in the plane with given sides: the corners 1 and 2 from corner 0, (k, 2, 2).

    The last axis has the coordinates; corner 1 lies on the first axis, and corner 2 above it.
    """
    a, b, c = sides.T
    x = (a**2 + c**2 - b**2) / (2.0 * a)
    # Cloth that is creased may have sides that cannot close.
    y = np.sqrt(np.maximum(c**2 - x**2, (NARROWEST * c) ** 2))
    return np.stack([np.stack([a, np.zeros_like(a)], axis=1), np.stack([x, y], axis=1)], axis=1)


def angles(sides: Array) -> Array:
    """Return the angles (k, 3) at the corners of triangles."""
    a, b, c = sides.T
    pairs = ((a, c, b), (a, b, c), (b, c, a))
    cosines = [(p**2 + q**2 - r**2) / (2.0 * p * q) for p, q, r in pairs]
    return np.asarray(np.arccos(np.clip(np.stack(cosines, axis=1), -1.0, 1.0)))


def determinants(matrices: Array) -> Array:
    """Return the determinants of matrices (..., 2, 2), quicker than by LAPACK."""
    return np.asarray(
        matrices[..., 0, 0] * matrices[..., 1, 1] - matrices[..., 0, 1] * matrices[..., 1, 0]
    )


def inverses(matrices: Array) -> Array:
    """Return the inverses of matrices (..., 2, 2); those of singular ones are not finite."""
    adjugate = np.empty_like(matrices)
    adjugate[..., 0, 0], adjugate[..., 1, 1] = matrices[..., 1, 1], matrices[..., 0, 0]
    adjugate[..., 0, 1], adjugate[..., 1, 0] = -matrices[..., 0, 1], -matrices[..., 1, 0]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        return np.asarray(adjugate / determinants(matrices)[..., None, None])
