"""Trial spaces: nodes, differentiation matrices, and evaluation anywhere on [0, 1]."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bodymeasure._typing import Array
from bodymeasure.geodesic.spaces.piecewise import PiecewisePolynomials
from bodymeasure.geodesic.spaces.quadrature import Quadrature

# A speed is the square root of a polynomial: it takes about twice as many Gauss points as the path
# has nodes until quadrature no longer limits the length (measured on random patches: with one point
# a node, lengths lose one to two digits).
POINTS_PER_NODE = 2
# And some for spaces with few nodes; on each piece of a piecewise space at least these.
FEWEST_POINTS = 8
# Paths that are looked at between their nodes at once.
CHUNK = 4096


@dataclass(frozen=True, eq=False)
class TrialSpace:
    """Functions on [0, 1] that are given by their values at nodes.

    The solver sees only this: which functions span the space is the maker's business. The maps
    from nodal values to values and derivatives elsewhere are plain matrices.

    Parameters
    ----------
    nodes : ndarray, shape (n + 1,)
        Increasing, first 0 and last 1; the inner ones are the collocation points.
    condition : float
        Condition number of the system that takes expansion coefficients to nodal values.
    functions : PiecewisePolynomials
        The n + 1 cardinal functions: each 1 at its node and 0 at the others.
    description : str
        The space in words, for reports.
    """

    nodes: Array
    condition: float
    functions: PiecewisePolynomials
    description: str

    def matrices(self, t: ArrayLike) -> Array:
        """Maps from nodal values to values and two derivatives at t, shape (3, k, n + 1)."""
        return self.functions(np.atleast_1d(np.asarray(t, dtype=np.float64)))

    @property
    def size(self) -> int:
        """Number n of intervals between nodes: the degree, of a polynomial space."""
        return len(self.nodes) - 1

    @cached_property
    def differentiation(self) -> Array:
        """First and second derivative at the inner nodes, shape (2, n - 1, n + 1)."""
        return np.ascontiguousarray(self.matrices(self.nodes[1:-1])[1:])

    @cached_property
    def quadrature(self) -> Quadrature:
        """Gauss-Legendre quadrature on [0, 1], exact enough for the length of a path."""
        edges = self.functions.edges
        wanted = POINTS_PER_NODE * self.size + FEWEST_POINTS
        return Quadrature(edges, max(FEWEST_POINTS, -(-wanted // (len(edges) - 1))))

    @cached_property
    def at_quadrature(self) -> Array:
        """The maps of `matrices` at the quadrature points."""
        return self.matrices(self.quadrature.points)

    @cached_property
    def with_lines(self) -> "TrialSpace":
        """The space of straight lines plus this one's functions that vanish at the ends.

        On the same nodes. The paths of the form with one unknown function are of this space. One
        that holds all straight lines anyway, as polynomials do, stays what it is.
        """
        edges, coefficients = self.functions.edges, self.functions.coefficients.copy()
        middle, half = (edges[1:] + edges[:-1]) / 2.0, np.diff(edges) / 2.0
        lines = np.zeros((3, coefficients.shape[1], 2, len(half)), dtype=np.longdouble)
        lines[0, 0], lines[0, 1] = (1.0 - middle, middle), (-half, half)
        lines[1, 0] = np.array([-1.0, 1.0])[:, None]
        inner = np.stack([1.0 - self.nodes[1:-1], self.nodes[1:-1]])
        # Zero at the inner nodes, as cardinal functions are.
        coefficients[:, :, [0, -1]] = lines - inner @ coefficients[:, :, 1:-1]
        return replace(self, functions=PiecewisePolynomials(edges, coefficients))

    def leaves_patch(self, values: Array, margin: float) -> NDArray[np.bool_]:
        """Which paths go further than a margin outside [0, 1], in u or v.

        Parameters
        ----------
        values : ndarray, shape (problems, 2, n + 1)
        margin : float
        """
        leaves = np.zeros(len(values), bool)
        for first in range(0, len(values), CHUNK):
            some = values[first : first + CHUNK]
            # The times along the first axis, over which a minimum is much the fastest.
            paths = self.between_nodes @ some.reshape(-1, some.shape[2]).T
            outside = (paths.min(axis=0) < -margin) | (paths.max(axis=0) > 1.0 + margin)
            leaves[first : first + CHUNK] = outside.reshape(-1, 2).any(axis=1)
        return leaves

    @cached_property
    def between_nodes(self) -> Array:
        """Map to values at `times_between`, shape (k, n + 1)."""
        return self.functions.values(self.times_between)

    @property
    def times_between(self) -> Array:
        """Points that lie close together everywhere, shape (k,)."""
        k = np.arange(8 * self.size + 1)
        return np.asarray(0.5 - 0.5 * np.cos(np.pi * k / k[-1]))
