"""Connected components of a graph."""

import numpy as np
import scipy

from bodymeasure._typing import Ints


def connected_components(first: Ints, second: Ints, count: int) -> Ints:
    """Return the number of the component of each node, shape (count,).

    Parameters
    ----------
    first, second : ndarray of int, shape (links,)
        The nodes that each link joins.
    count : int
        Number of nodes.
    """
    links = scipy.sparse.coo_array(
        (np.ones(len(first), dtype=np.int8), (first, second)), shape=(count, count)
    )
    _, label = scipy.sparse.csgraph.connected_components(links, directed=False)
    return np.asarray(label, dtype=np.int64)
