"""Connected components of a graph."""

import numpy as np
import scipy
from numpy.typing import NDArray


def connected_components(
    first: NDArray[np.int64], second: NDArray[np.int64], count: int
) -> NDArray[np.int64]:
    """Number of the component of each node, shape (count,).

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
