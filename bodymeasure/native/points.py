"""Roots of polynomials and points of patches, compiled."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.native.library import address, library

# The most powers of a patch in one parameter for which the kernel has room.
MOST_SIDE = 33


def roots_in_brackets(coefficients: Array, lower: Array, upper: Array) -> Array:
    """Return the root of each polynomial; see `section.roots.bracketed_roots`."""
    kernels = library()
    assert kernels is not None
    coefficients, lower, upper = (
        np.ascontiguousarray(each, np.float64) for each in (coefficients, lower, upper)
    )
    count, size = coefficients.shape
    found, room = np.empty(count), np.empty(size)
    kernels.bodymeasure_roots(
        count, size - 1, *map(address, (coefficients, lower, upper, found, room))
    )
    return found


def power_jets(coefficients: Array, x: Array) -> Array:
    """Return derivatives up to the second; see `bezier.power_form.jets`, but for weights.

    Returns
    -------
    ndarray, shape (k, 3, 3, coordinates)
    """
    kernels = library()
    assert kernels is not None
    coefficients, x = np.ascontiguousarray(coefficients), np.ascontiguousarray(x)
    count, side, _, coordinates = coefficients.shape
    jets = np.empty((count, 3, 3, coordinates))
    kernels.bodymeasure_power_jets(count, side, coordinates, *map(address, (coefficients, x, jets)))
    return jets
