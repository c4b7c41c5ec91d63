"""The closest points of patches, compiled."""

import ctypes

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.native.library import address, doubles, kernels


class ClosestSettings(ctypes.Structure):
    """`ClosestSettings` of ``closest.cpp``: the constants of `atlas.queries.closest`."""

    _fields_ = (
        ("most_steps", ctypes.c_int64),
        *((name, ctypes.c_double) for name in ("last_step", "longest_step", "singular")),
        *((name, ctypes.c_double) for name in ("damping", "rounding")),
    )


def closest_in_powers(
    coefficients: Array, targets: Array, start: Array, settings: ClosestSettings
) -> tuple[Array, Array]:
    """Return the closest points of patches, one problem a row, each from a start nearby.

    Parameters
    ----------
    coefficients : ndarray, shape (k, m + 1, m + 1, 3)
        Coefficients of powers, of degrees up to `MOST_DEGREE`.
    targets : ndarray, shape (k, 3)
    start : ndarray, shape (k, 2)
    settings : ClosestSettings

    Returns
    -------
    x : ndarray, shape (k, 2)
    squared : ndarray, shape (k,)
    """
    coefficients, targets = doubles(coefficients, targets)
    count, side = coefficients.shape[:2]
    x, squared = np.array(start, np.float64, order="C"), np.empty(count)
    kernels().bodymeasure_closest(
        count,
        side,
        address(coefficients),
        address(targets),
        ctypes.byref(settings),
        address(x),
        address(squared),
    )
    return x, squared
