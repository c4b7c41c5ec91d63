"""Steps to the minima of quadratic models in a box, compiled."""

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.native.library import address, doubles, kernels


def box_steps(bands: Array, gradient: Array, place: Array, idle: Bools) -> tuple[Array, Bools]:
    """Return the step of each model, and whether it has one.

    The parameters are those of `geodesic.numerics.banded.BoxModels`.
    """
    bands, gradient, place = doubles(bands, gradient, place)
    idle = np.ascontiguousarray(idle, bool)
    count, width, size = bands.shape
    step, definite = np.empty((count, size)), np.empty(count, bool)
    arrays = (bands, gradient, place, idle, step, definite)
    kernels().bodymeasure_box_steps(count, size, width, *map(address, arrays))
    return step, definite
