"""The equilibrium of a string between tangent planes, compiled."""

import ctypes
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.native.library import address, doubles, kernels


class _StringModel(ctypes.Structure):
    """`StringModel` of ``equilibrium.cpp``."""

    _fields_ = (
        ("count", ctypes.c_int64),
        ("most_exchanges", ctypes.c_int64),
        *((name, ctypes.c_void_p) for name in ("springs", "force", "normal", "gap")),
        *((name, ctypes.c_void_p) for name in ("there", "bend")),
    )


class StringForces(NamedTuple):
    """A string with k inner nodes, and the walls that keep them; see `taut.equilibrium`.

    Parameters
    ----------
    springs : ndarray, shape (k + 1,)
    force : ndarray, shape (k, 3)
    normal, gap : ndarray, shapes (k, 2, 3) and (k, 2)
    bend : ndarray, shape (k, 3, 3)
    """

    springs: Array
    force: Array
    normal: Array
    gap: Array
    bend: Array


def string_equilibrium(
    forces: StringForces, there: Bools, held: Bools, most_exchanges: int
) -> tuple[Array, Array, Bools] | None:
    """Return steps (k, 3), loads (k, 2) and the walls that hold (k, 2).

    None if the matrix is not positive definite.
    """
    springs, force, normal, gap, bend = doubles(*forces)
    there, held = np.ascontiguousarray(there, bool), np.array(held, bool, order="C")
    count = len(force)
    step, load = np.zeros((count, 3)), np.zeros((count, 2))
    model = _StringModel(
        count, most_exchanges, *map(address, (springs, force, normal, gap, there, bend))
    )
    found = kernels().bodymeasure_equilibrium(
        ctypes.byref(model), *map(address, (step, load, held))
    )
    return (step, load, held) if found else None
