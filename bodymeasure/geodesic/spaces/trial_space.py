"""Trial spaces: nodes, differentiation matrices, and evaluation anywhere on [0, 1]."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.spaces.piecewise import PiecewisePolynomials
from bodymeasure.geodesic.spaces.quadrature import Quadrature

# A speed is the square root of a polynomial. With about twice as many Gauss points as the path has
# nodes, quadrature no longer limits the length; with one point a node, lengths on random patches
# lost one to two digits.
POINTS_PER_NODE = 2
# So many points are added for the sake of spaces with few nodes, and each piece of a piecewise
# space has at least as many.
FEWEST_POINTS = 8
# The number of paths that are evaluated between their nodes at once.
CHUNK = 4096


@dataclass(frozen=True, eq=False)
class TrialSpace:
    """Functions on [0, 1] that are given by their values at nodes.

    This is all that the solver sees: which functions span the space matters only to the function
    that makes it. The maps from nodal values to values and derivatives elsewhere are matrices.

    Parameters
    ----------
    nodes : ndarray, shape (n + 1,)
        Increasing, first 0 and last 1; the inner ones are the collocation points.
    condition : float
        The condition number of the system that takes expansion coefficients to nodal values.
    functions : PiecewisePolynomials
        The n + 1 cardinal functions, each of which is 1 at its node and 0 at the others.
    description : str
        The space in words, for reports.
    more_points : int
        The points of the quadrature beyond `POINTS_PER_NODE`.
    """

    nodes: Array
    condition: float
    functions: PiecewisePolynomials
    description: str
    more_points: int = FEWEST_POINTS

    def matrices(self, t: ArrayLike) -> Array:
        """Return the maps from nodal values to values and two derivatives at t, (3, k, n + 1)."""
        return self.functions(np.atleast_1d(np.asarray(t, dtype=np.float64)))

    @property
    def size(self) -> int:
        """The number n of intervals between nodes, which is the degree of a polynomial space."""
        return len(self.nodes) - 1

    @cached_property
    def differentiation(self) -> Array:
        """The maps to first and second derivatives at the inner nodes, shape (2, n - 1, n + 1)."""
        return np.ascontiguousarray(self.matrices(self.nodes[1:-1])[1:])

    @cached_property
    def quadrature(self) -> Quadrature:
        """The Gauss-Legendre quadrature on [0, 1] that is exact enough for the length of a path."""
        edges = self.functions.edges
        wanted = POINTS_PER_NODE * self.size + self.more_points
        return Quadrature(edges, max(FEWEST_POINTS, -(-wanted // (len(edges) - 1))))

    @cached_property
    def at_quadrature(self) -> Array:
        """The maps of `matrices` at the quadrature points."""
        return self.matrices(self.quadrature.points)

    @cached_property
    def at_ends(self) -> Array:
        """The maps of `matrices` at both ends."""
        return self.matrices([0.0, 1.0])

    @cached_property
    def with_lines(self) -> "TrialSpace":
        """The space, on the same nodes, of straight lines plus functions that vanish at the ends.

        The latter are those of this space. The paths of the form with one unknown function are in
        it. A space that holds all straight lines anyway, as polynomials do, stays what it is.
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

    def leaves_patch(self, values: Array, margin: float) -> Bools:
        """Return which paths go further than a margin outside [0, 1], in u or v.

        Parameters
        ----------
        values : ndarray, shape (problems, 2, n + 1)
        margin : float
        """
        leaves = np.zeros(len(values), bool)
        for first in range(0, len(values), CHUNK):
            some = values[first : first + CHUNK]
            # The times run along the first axis, over which minima are found much faster.
            paths = self.between_nodes @ some.reshape(-1, some.shape[2]).T
            outside = (paths.min(axis=0) < -margin) | (paths.max(axis=0) > 1.0 + margin)
            leaves[first : first + CHUNK] = outside.reshape(-1, 2).any(axis=1)
        return leaves

    @cached_property
    def between_nodes(self) -> Array:
        """The map to values at `times_between`, shape (k, n + 1)."""
        return self.functions.values(self.times_between)

    @property
    def times_between(self) -> Array:
        """Parameters that lie close together everywhere, shape (k,)."""
        k = np.arange(8 * self.size + 1)
        return np.asarray(0.5 - 0.5 * np.cos(np.pi * k / k[-1]))
