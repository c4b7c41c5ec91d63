"""Polygons as a trial space: piecewise linear functions on equal pieces of [0, 1]."""

from functools import lru_cache

import numpy as np

from bodymeasure.geodesic.spaces.piecewise import PiecewisePolynomials
from bodymeasure.geodesic.spaces.trial_space import TrialSpace


@lru_cache(maxsize=8)
def polygon_space(edges: int) -> TrialSpace:
    """Return the space of polygons with a number of edges, at least 2.

    A path that is partly held by a bound lies on it exactly there, which no polynomial does.
    """
    nodes = np.linspace(0.0, 1.0, edges + 1)
    coefficients = np.zeros((3, 2, edges + 1, edges), dtype=np.longdouble)
    for piece in range(edges):
        coefficients[0, :, piece, piece] = 0.5, -0.5
        coefficients[0, :, piece + 1, piece] = 0.5, 0.5
        coefficients[1, 0, piece : piece + 2, piece] = -edges, edges
    return TrialSpace(
        nodes=nodes,
        condition=1.0,
        functions=PiecewisePolynomials(nodes, coefficients),
        description=f"polygons of {edges} edges",
    )
