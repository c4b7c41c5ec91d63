"""The library of compiled kernels, if there is one.

It is built when the package is installed, where a C++ compiler is. Where none is, or where the
environment variable ``BODYMEASURE_NATIVE`` is ``0``, the NumPy forms of the same functions serve.
Any other value is the path of a library to take instead, such as one that checks itself.
"""

import ctypes
import os
from functools import cache
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

NAME = "bodymeasure.native._kernels"
SWITCH = "BODYMEASURE_NATIVE"
DOUBLES = ctypes.POINTER(ctypes.c_double)
INTEGERS = ctypes.POINTER(ctypes.c_int64)
BYTES = ctypes.POINTER(ctypes.c_uint8)
# The pointer to arrays of each type.
_KINDS: dict[type, Any] = {np.float64: DOUBLES, np.int64: INTEGERS, np.bool_: BYTES}


@cache
def library() -> ctypes.CDLL | None:
    """Return the library; None if there is none, or it is switched off."""
    chosen = os.environ.get(SWITCH)
    if chosen == "0":
        return None
    if chosen:
        return ctypes.CDLL(chosen)
    found = find_spec(NAME)
    if found is None or found.origin is None:
        return None
    try:
        return ctypes.CDLL(found.origin)
    except OSError:  # built for another machine
        return None


def is_compiled() -> bool:
    """Return whether compiled kernels serve.

    Examples
    --------
    >>> from bodymeasure.native import is_compiled
    >>> is_compiled() in (True, False)
    True
    """
    return library() is not None


def pointer(array: NDArray[Any]) -> Any:
    """Return a pointer to the entries of an array in C order, which must outlive it."""
    if not array.flags.c_contiguous:
        raise ValueError("expected an array in C order")
    return array.ctypes.data_as(_KINDS[array.dtype.type])
