"""The points of patches that are closest to points beside them."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier import derivatives

# Steps of Gauss and Newton from a point nearby. Each nearly squares what is left of the way along
# the patch, and the distance depends on the square of that.
STEPS = 2
# A patch is continued by this much beyond its edges, since the closest point may lie on a neighbor.
BEYOND = 0.2


def closest_on_patches(nets: Array, targets: Array, start: Array) -> tuple[Array, Array]:
    """Return the closest points of patches near given parameters.

    Parameters
    ----------
    nets : ndarray, shape (patches, 4, 4, 3)
    targets : ndarray, shape (patches, k, 3)
    start : ndarray, shape (patches, k, 2)

    Returns
    -------
    offsets : ndarray, shape (patches, k, 3)
        From the closest points to the targets.
    normals : ndarray, shape (patches, k, 3)
        Unit normals of the patches at the closest points; 0 where there are none.
    """
    x = start
    for step in range(STEPS + 1):
        jets = derivatives(nets, x, order=1)
        offsets = targets - jets[..., 0, 0, :]
        su, sv = jets[..., 1, 0, :], jets[..., 0, 1, :]
        if step == STEPS:
            break
        e, f, g = _dot(su, su), _dot(su, sv), _dot(sv, sv)
        p, q = _dot(su, offsets), _dot(sv, offsets)
        # Where the tangents are parallel, a damped step is as good as none.
        determinant = np.maximum(e * g - f * f, 1e-9 * e * g) + np.finfo(np.float64).tiny
        move = np.stack([g * p - f * q, e * q - f * p], axis=-1) / determinant[..., None]
        x = np.clip(x + np.clip(move, -0.25, 0.25), -BEYOND, 1.0 + BEYOND)
    return offsets, unit(np.cross(su, sv))


def unit(vectors: Array) -> Array:
    """Return vectors of length 1; those of length 0 stay."""
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.asarray(vectors / np.where(length > 0.0, length, 1.0))


def _dot(first: Array, second: Array) -> Array:
    return np.asarray(np.einsum("...c,...c->...", first, second))
