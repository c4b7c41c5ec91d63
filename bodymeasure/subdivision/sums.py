"""Sums over the elements that belong to each vertex or edge."""

import numpy as np

from bodymeasure._typing import Array, Ints


def sum_at(index: Ints, values: Array, count: int) -> Array:
    """Sum values (..., 3) over each number that occurs in `index`; shape (count, 3).

    `values` has the shape of `index`, or one row for each row of it.
    """
    if values.ndim == index.ndim:
        values = np.broadcast_to(values[:, None], (*index.shape, 3))
    rows, flat = index.ravel(), values.reshape(-1, 3)
    return np.stack([np.bincount(rows, flat[:, axis], count) for axis in range(3)], axis=-1)
