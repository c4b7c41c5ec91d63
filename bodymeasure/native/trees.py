"""Shortest ways over graphs, compiled."""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.native.library import address, doubles, kernels


def compiled_shortest_ways(degrees: Ints, heads: Ints, weights: Array) -> tuple[Array, Ints]:
    """Return what `geodesic.numerics.shortest_ways` does; -1 where there is no node before."""
    (weights,) = doubles(weights)
    degrees, heads = (np.ascontiguousarray(each, np.int64) for each in (degrees, heads))
    shape = (len(weights), len(degrees))
    distance, before = np.empty(shape), np.empty(shape, np.int64)
    kernels().bodymeasure_shortest_trees(
        *shape,
        weights.shape[1],
        *map(address, (degrees, heads, weights, distance, before)),
    )
    return distance, before
