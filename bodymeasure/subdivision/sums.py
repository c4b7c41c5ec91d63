"""Sums over what belongs to each vertex or edge."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_Array = NDArray[np.float64]


def sum_at(index: NDArray[np.int64], values: _Array, count: int) -> _Array:
    """Sums of values (..., 3) over each number that occurs in `index`, shape (count, 3).

    `values` has the shape of `index`, or one row for each row of it.
    """
    if values.ndim == index.ndim:
        values = np.broadcast_to(values[:, None], (*index.shape, 3))
    rows, flat = index.ravel(), values.reshape(-1, 3)
    return np.stack([np.bincount(rows, flat[:, axis], count) for axis in range(3)], axis=-1)
