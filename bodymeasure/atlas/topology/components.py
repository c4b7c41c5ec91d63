"""Connected components of a graph."""

import numpy as np
import scipy

from bodymeasure._typing import Ints

# For so many nodes SciPy's search is worth its import, which takes a tenth of a second.
MANY = 2**15


def connected_components(first: Ints, second: Ints, count: int) -> Ints:
    """Return the number of the component of each node, shape (count,).

    Parameters
    ----------
    first, second : ndarray of int, shape (links,)
        The nodes that each link joins.
    count : int
        Number of nodes.
    """
    if count > MANY:
        links = scipy.sparse.coo_array(
            (np.ones(len(first), dtype=np.int8), (first, second)), shape=(count, count)
        )
        _, found = scipy.sparse.csgraph.connected_components(links, directed=False)
        return np.asarray(found, dtype=np.int64)
    label = np.arange(count)
    while True:
        # The lower of two linked labels takes the place of the higher; then labels of labels are
        # followed to their ends, so that a chain of n nodes takes about log n turns.
        low, high = np.sort(np.stack([label[first], label[second]]), axis=0)
        if (low == high).all():
            break
        np.minimum.at(label, high, low)
        while not np.array_equal(label, label[label]):
            label = label[label]
    result: Ints = np.unique(label, return_inverse=True)[1].reshape(count)
    return result
