"""Shortest ways over graphs, compiled."""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.native.library import address, doubles, kernels


def shortest_ways(degrees: Ints, heads: Ints, weights: Array) -> tuple[Array, Ints]:
    """Return the shortest ways from the last node of each of some graphs to all of its nodes.

    Parameters
    ----------
    degrees : ndarray of int, shape (nodes,)
        The numbers of edges that leave each node, the same for all graphs.
    heads : ndarray of int, shape (graphs, edges)
        The nodes to which edges lead, sorted by the nodes that they leave.
    weights : ndarray, shape (graphs, edges)
        Their lengths; none is negative, and those that are infinite lead nowhere.

    Returns
    -------
    distance : ndarray, shape (graphs, nodes)
        Infinite where no way leads.
    before : ndarray of int, shape (graphs, nodes)
        The node before on the way; -1 where there is none.
    """
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
