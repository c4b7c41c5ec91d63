"""Arrays of libraries other than numpy, by the Python array API standard."""

from typing import Any

import array_api_compat
import numpy as np
from numpy.typing import NDArray


def namespace(array: Any) -> Any:
    """Return the functions of an array's library, under the names of the standard.

    NumPy has had these names itself from version 2 on, and is asked for first: the package that
    gives them to all libraries takes a tenth of a second to load what it wraps.
    """
    if isinstance(array, np.ndarray) and hasattr(np, "permute_dims"):
        return np
    return array_api_compat.array_namespace(array)


def constant(values: NDArray[Any], like: Any, xp: Any) -> Any:
    """Return a numpy array as one of the library, and on the device, of the array `like`."""
    if isinstance(like, np.ndarray):
        return values
    return xp.asarray(values, device=array_api_compat.device(like))


def to_numpy(array: Any) -> NDArray[Any]:
    """Return an array of any library as one of numpy, on the CPU."""
    if isinstance(array, np.ndarray):
        return array
    return np.asarray(array_api_compat.to_device(array, "cpu"))


def is_on_cpu(array: Any) -> bool:
    """Return whether an array lives in the memory of the CPU."""
    return isinstance(array, np.ndarray) or "cpu" in str(array_api_compat.device(array)).lower()
