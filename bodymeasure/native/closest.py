"""The closest points of patches, compiled."""

import ctypes
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.native.library import address, doubles, kernels


class ClosestSettings(ctypes.Structure):
    """`ClosestSettings` of ``closest.cpp``: the constants of `atlas.queries.feet`."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("most_steps", "most_seams")),
        *((name, ctypes.c_double) for name in ("last_step", "longest_step", "singular")),
        *((name, ctypes.c_double) for name in ("damping", "rounding", "tied")),
    )


class PatchSeams(NamedTuple):
    """The sides of patches, and what lies beyond them, of shape (patches, 4) each.

    Parameters
    ----------
    to_patch, to_side : ndarray of int
        The patch and the side beyond, -1 where there is none.
    flipped : ndarray of bool
        Whether that side runs against this one.
    """

    to_patch: Ints
    to_side: Ints
    flipped: Bools


def closest_in_powers(
    coefficients: Array,
    seams: PatchSeams,
    targets: Array,
    start: tuple[Ints, Array],
    settings: ClosestSettings,
) -> tuple[Ints, Array, Array]:
    """Return the closest points of patches, and of those over their seams.

    Parameters
    ----------
    coefficients : ndarray, shape (patches, m + 1, m + 1, 3)
        Coefficients of powers, of degrees up to `MOST_DEGREE`.
    seams : PatchSeams
    targets : ndarray, shape (k, 3)
    start : tuple of ndarray, of shapes (k,) and (k, 2)
        The patches, and a place nearby on each.
    settings : ClosestSettings

    Returns
    -------
    patch : ndarray of int, shape (k,)
    x : ndarray, shape (k, 2)
    squared : ndarray, shape (k,)
    """
    coefficients, targets = doubles(coefficients, targets)
    to_patch, to_side = (np.ascontiguousarray(each, np.int64) for each in seams[:2])
    flipped = np.ascontiguousarray(seams.flipped, np.bool_)
    patch, x = np.array(start[0], np.int64, order="C"), np.array(start[1], np.float64, order="C")
    squared = np.empty(len(x))
    kernels().bodymeasure_closest(
        len(x),
        coefficients.shape[1],
        *map(address, (coefficients, to_patch, to_side, flipped, targets)),
        ctypes.byref(settings),
        *map(address, (patch, x, squared)),
    )
    return patch, x, squared
