"""Shortest ways over graphs, by Dijkstra's algorithm."""

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.numerics.grid_steps import SHORTEST
from bodymeasure.native import compiled_shortest_ways, is_compiled


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
        The node before on the way; negative where there is none.
    """
    if is_compiled():
        return compiled_shortest_ways(degrees, heads, weights)
    shape = graphs, nodes = len(weights), len(degrees)
    # Each of them is a part of one great graph.
    first = nodes * np.arange(graphs)[:, None]
    begins = np.concatenate([[0], np.cumsum(np.tile(degrees, graphs))])
    graph = scipy.sparse.csr_array(
        (
            np.maximum(weights, SHORTEST).ravel(),
            (heads + first).astype(np.int32).ravel(),
            begins.astype(np.int32),
        ),
        shape=2 * (graphs * nodes,),
    )
    # The parts are not connected, so that the start nearest to a node is its own.
    distance, before, _ = scipy.sparse.csgraph.dijkstra(
        graph, indices=first.ravel() + nodes - 1, min_only=True, return_predecessors=True
    )
    return distance.reshape(shape), before.reshape(shape) - first
