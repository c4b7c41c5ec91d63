"""Steps to the minima of quadratic models in a box, compiled."""

import ctypes

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.native.library import address, doubles, kernels


class _BoxModel(ctypes.Structure):
    """`BoxModel` of ``kernels.h``."""

    _fields_ = (
        ("unknowns", ctypes.c_int64),
        ("bands", ctypes.c_int64),
        ("matrix", ctypes.c_void_p),
        ("gradient", ctypes.c_void_p),
        ("place", ctypes.c_void_p),
        ("idle", ctypes.c_void_p),
    )


def box_steps(bands: Array, gradient: Array, place: Array, idle: Bools) -> tuple[Array, Bools]:
    """Return the step of each model, and whether it has one.

    The parameters are those of `geodesic.numerics.banded.BoxModels`.
    """
    bands, gradient, place = doubles(bands, gradient, place)
    idle = np.ascontiguousarray(idle, bool)
    count, width, size = bands.shape
    step, definite = np.zeros((count, size)), np.zeros(count, bool)
    for number in range(count):
        model = _BoxModel(
            size,
            width,
            address(bands[number]),
            address(gradient[number]),
            address(place[number]),
            address(idle[number]),
        )
        found = kernels().bodymeasure_box_step(ctypes.byref(model), address(step[number]))
        definite[number] = bool(found)
    return step, definite
