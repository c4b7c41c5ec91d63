"""Unit normals of patches and how they bend, compiled."""

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.native.library import address, doubles, kernels


def normals_in_powers(
    coefficients: Array, patch: Ints, x: Array, least: tuple[float, float]
) -> tuple[Array, Array, Array, Bools]:
    """Return positions, unit normals and bends; see `atlas.normals.normals_and_bends`.

    Parameters
    ----------
    coefficients : ndarray, shape (patches, m + 1, m + 1, 3)
        Of degrees up to `MOST_DEGREE`.
    patch : ndarray of int, shape (k,)
    x : ndarray, shape (k, 2)
    least : tuple of float
        The least sine of the angle between the tangents, and the least ratio of their lengths.

    Returns
    -------
    position, normal : ndarray, shape (k, 3)
    bend : ndarray, shape (k, 3, 3)
    regular : ndarray of bool, shape (k,)
        Where the tangents fall short of the least, the results are undefined.
    """
    coefficients, x, bounds = doubles(coefficients, x, np.array(least))
    patch, count = np.ascontiguousarray(patch, np.int64), len(x)
    position, normal, bend = np.empty((count, 3)), np.empty((count, 3)), np.empty((count, 3, 3))
    regular = np.empty(count, bool)
    kernels().bodymeasure_normals(
        count,
        coefficients.shape[1],
        *map(address, (coefficients, patch, x, bounds, position, normal, bend, regular)),
    )
    return position, normal, bend, regular
