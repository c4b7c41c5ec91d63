"""Steps to the minima of quadratic models in a box, compiled."""

import ctypes

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.native.library import BYTES, DOUBLES, library, pointer

# The arrays of a kernel's room beside the factor.
BESIDE = 7


class _BoxModel(ctypes.Structure):
    """`BoxModel` of ``kernels.h``."""

    _fields_ = (
        ("unknowns", ctypes.c_int64),
        ("bands", ctypes.c_int64),
        ("matrix", DOUBLES),
        ("gradient", DOUBLES),
        ("place", DOUBLES),
        ("idle", BYTES),
    )


def box_steps(bands: Array, gradient: Array, place: Array, idle: Bools) -> tuple[Array, Bools]:
    """Return the step of each model, and whether it has one.

    The parameters are those of `geodesic.numerics.banded.BoxModels`.
    """
    kernels = library()
    assert kernels is not None
    bands, gradient, place = map(np.ascontiguousarray, (bands, gradient, place))
    idle = np.ascontiguousarray(idle)
    count, width, size = bands.shape
    step, definite = np.zeros((count, size)), np.zeros(count, bool)
    room = np.empty((width + BESIDE) * size)
    for number in range(count):
        model = _BoxModel(
            size,
            width,
            pointer(bands[number]),
            pointer(gradient[number]),
            pointer(place[number]),
            pointer(idle[number]),
        )
        found = kernels.bodymeasure_box_step(
            ctypes.byref(model), pointer(step[number]), pointer(room)
        )
        definite[number] = bool(found)
    return step, definite
