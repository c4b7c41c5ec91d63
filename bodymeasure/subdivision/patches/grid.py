"""Points and derivatives of bicubic patches on one grid for all."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier import bernstein


def grid_jets(nets: Array, nodes: Array, order: int) -> Array:
    """Return the derivatives of patches at a grid of parameters, by u and by v.

    This is what `bodymeasure.bezier.derivatives` returns, faster, because all patches share their
    basis functions.

    Parameters
    ----------
    nets : ndarray, shape (..., 4, 4, 3)
    nodes : ndarray, shape (k,)
        Parameters in u and in v.
    order : int

    Returns
    -------
    ndarray, shape (..., k, k, order + 1, order + 1, 3)
    """
    count, orders, batch = len(nodes), order + 1, nets.shape[:-3]
    basis = bernstein(3, nodes, order).reshape(count * orders, 4)
    along_u = (basis @ nets.reshape(*batch, 4, 12)).reshape(*batch, count * orders, 4, 3)
    both = (basis @ along_u).reshape(*batch, count, orders, count, orders, 3)
    return np.asarray(np.swapaxes(both, -4, -3))
