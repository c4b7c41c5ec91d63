"""The Morse index of a path made of elements: how many conjugate points it has."""

import numpy as np
import scipy

from bodymeasure._typing import Bools
from bodymeasure.geodesic.elements.path import DEGREE
from bodymeasure.geodesic.elements.pieces import Pieces
from bodymeasure.geodesic.lengths.jacobi import LYAPUNOV_BOUND
from bodymeasure.geodesic.lengths.length import UNKNOWN
from bodymeasure.geodesic.spaces.polynomials import polynomial_space

# An eigenvalue of the second variation below this part of that of a flat surface says nothing.
CLEAR = 1e-5
# No step between points counts as shorter, on a surface of size 1.
SHORTEST = 1e-18


def path_index(pieces: Pieces, free: Bools) -> int:
    """Return the sum of the indices of the legs of a path between joints that are not free.

    The second variation is that of finite differences between the points of the quadrature. It is
    `UNKNOWN` where an eigenvalue is so small that its sign is uncertain.

    Parameters
    ----------
    pieces : Pieces
    free : ndarray of bool, shape (elements - 1,)
        The joints that are free to move.
    """
    weights = polynomial_space(DEGREE).quadrature.weights
    along = (weights[:, None] * pieces.speed).T
    curvature = np.where(pieces.smooth, pieces.curvature, 0.0).T
    index = 0
    for leg in np.split(np.arange(len(along)), np.flatnonzero(~free) + 1):
        way, bend = along[leg].ravel(), curvature[leg].ravel()
        length = way.sum()
        if pieces.on_edge[leg].any() or np.maximum(bend, 0.0) @ way * length < LYAPUNOV_BOUND:
            continue
        way = np.maximum(way, SHORTEST)
        steps = np.concatenate([[way[0]], way[:-1] + way[1:], [way[-1]]]) / 2.0
        diagonal = (1.0 / steps[1:] + 1.0 / steps[:-1]) / way - bend
        beside = -1.0 / steps[1:-1] / np.sqrt(way[:-1] * way[1:])
        bound = CLEAR * (np.pi / length) ** 2
        low = scipy.linalg.eigvalsh_tridiagonal(
            diagonal, beside, select="v", select_range=(-np.inf, bound)
        )
        if (low > -bound).any():
            return UNKNOWN
        index += len(low)
    return index
