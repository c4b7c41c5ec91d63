"""The library of compiled kernels, if there is one.

It is built when the package is installed, where a C++ compiler is. Where none is, or where the
environment variable ``BODYMEASURE_NATIVE`` is ``0``, the NumPy forms of the same functions serve.
Any other value is the path of a library to take instead, such as one that checks itself.
"""

import ctypes
import os
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure.errors import InputError

NAME = "bodymeasure.native._kernels"
SWITCH = "BODYMEASURE_NATIVE"
# The arguments of each kernel: addresses of arrays, and whole numbers.
_POINTER = ctypes.c_void_p
KERNELS = {
    "bodymeasure_box_steps": [ctypes.c_int64] * 3 + [_POINTER] * 6,
    "bodymeasure_closest": [*[ctypes.c_int64] * 2, *[_POINTER] * 9],
    "bodymeasure_collocation": [_POINTER] * 5,
    "bodymeasure_descent": [_POINTER] * 2,
    "bodymeasure_diagonals": [*[_POINTER] * 6, ctypes.c_int64],
    "bodymeasure_energy": [_POINTER, _POINTER, ctypes.c_int64, *[_POINTER] * 3],
    "bodymeasure_extents": [ctypes.c_int64] * 2 + [_POINTER] * 3,
    "bodymeasure_equilibrium": [_POINTER] * 4,
    "bodymeasure_first_ways": [_POINTER] * 5,
    "bodymeasure_jets": [*[ctypes.c_int64] * 5, _POINTER, ctypes.c_int64, *[_POINTER] * 2],
    "bodymeasure_lengths": [*[_POINTER] * 5, ctypes.c_int64],
    "bodymeasure_normals": [*[ctypes.c_int64] * 2, *[_POINTER] * 8],
    "bodymeasure_planar_hull": [ctypes.c_int64, *[_POINTER] * 2],
    "bodymeasure_power_jets": [ctypes.c_int64] * 3 + [_POINTER] * 3,
    "bodymeasure_roots": [ctypes.c_int64] * 2 + [_POINTER] * 4,
    "bodymeasure_route_newton": [_POINTER] * 7,
    "bodymeasure_shortest_trees": [ctypes.c_int64] * 3 + [_POINTER] * 5,
    "bodymeasure_section_points": [_POINTER] * 4,
    "bodymeasure_straight_way": [_POINTER] * 2,
}


_IS_OFF = ContextVar("kernels are switched off", default=False)


@contextmanager
def without_kernels() -> Iterator[None]:
    """Let the NumPy forms serve in a `with` statement, in this thread, to compare them.

    Examples
    --------
    >>> from bodymeasure.native import is_compiled, without_kernels
    >>> with without_kernels():
    ...     print(is_compiled())
    False
    """
    token = _IS_OFF.set(True)
    try:
        yield
    finally:
        _IS_OFF.reset(token)


def library() -> ctypes.CDLL | None:
    """Return the library; None if there is none, or it is switched off."""
    return None if _IS_OFF.get() else _found()


@cache
def _found() -> ctypes.CDLL | None:
    chosen = os.environ.get(SWITCH)
    if chosen == "0":
        return None
    if chosen:
        try:
            return _loaded(chosen)
        except (OSError, AttributeError) as error:
            raise InputError(
                f"the environment variable {SWITCH} is {chosen!r}, which is no library of kernels "
                f"({error}); expected 0, a library's path, or nothing: unset it"
            ) from None
    found = find_spec(NAME)
    if found is None or found.origin is None:
        return None
    try:
        return _loaded(found.origin)
    except (OSError, AttributeError):  # It was built for another machine, or of other sources.
        return None


def _loaded(path: str) -> ctypes.CDLL:
    result = ctypes.CDLL(path)
    for name, arguments in KERNELS.items():
        kernel = getattr(result, name)
        kernel.argtypes, kernel.restype = arguments, ctypes.c_int64
    return result


def kernels() -> ctypes.CDLL:
    """Return the library, where `is_compiled`."""
    found = library()
    assert found is not None, "there are no compiled kernels; ask is_compiled first"
    return found


def is_compiled() -> bool:
    """Return whether compiled kernels serve.

    Examples
    --------
    >>> from bodymeasure.native import is_compiled
    >>> is_compiled() in (True, False)
    True
    """
    return library() is not None


def doubles(*arrays: NDArray[Any]) -> list[NDArray[np.float64]]:
    """Return arrays as kernels read them: 64-bit numbers in C order, copied only if need be."""
    return [np.ascontiguousarray(array, np.float64) for array in arrays]


def address(array: NDArray[Any]) -> int:
    """Return the address of the entries of an array in C order, which must outlive it."""
    try:
        # A third of the time of the array interface, but only for what may be written and is not
        # empty.
        return ctypes.addressof(ctypes.c_char.from_buffer(array.data))
    except (TypeError, ValueError):
        pass
    if not array.flags.c_contiguous:
        raise ValueError("expected an array in C order")
    result: int = array.__array_interface__["data"][0]
    return result
