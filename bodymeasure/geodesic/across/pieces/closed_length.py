r"""The length of a loop over several patches, to the second order in all its unknowns.

As in `route_length`, but for the unknowns' order. Each piece and the crossing before it are a
block; the blocks of neighboring pieces are coupled, and the last with the first. Taken in the order
0, k - 1, 1, k - 2, ..., no two coupled blocks are more than two apart, so that the Hessian is
banded though the loop is closed.
"""

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.seams import EDGES
from bodymeasure.bezier import scaled
from bodymeasure.geodesic.across.pieces.route_length import (
    ALL_NODES,
    ENERGY,
    EPSILON,
    RouteExpansion,
)
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.lengths.functionals import expand
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.rational import surfaces_of


class ClosedProblem:
    """Loops along a route: what their unknowns mean.

    Parameters
    ----------
    atlas : Atlas
    route : Route
    space : TrialSpace
        Of each piece.
    size : float
        About the length of the loop, for scaling.
    """

    def __init__(self, atlas: Atlas, route: Route, space: TrialSpace, size: float) -> None:
        self.route, self.space, self.size = route, space, size
        self.pieces = len(route.crossings)
        self.surface = surfaces_of(scaled(atlas.control_points[list(route.patches)], 1.0 / size))
        self.inner = 2 * (space.size - 1)
        self.count = self.pieces * (self.inner + 1)
        # Where the seams' unknowns stand: that of each piece's entry, before its inner nodes.
        self.joints = _folded(self.pieces) * (self.inner + 1)
        inner = self.joints[:, None] + 1 + np.arange(self.inner)
        leaving = np.roll(self.joints, -1)
        # The unknowns of each piece, shape (pieces, inner + 2).
        self.rows = np.concatenate([self.joints[:, None], inner, leaving[:, None]], axis=1)
        self.local, self.sign = self._dependence()

    def _dependence(self) -> tuple[NDArray[np.int64], Array]:
        """For each piece's unknowns, the nodal value that each moves, and which way.

        Two arrays of shape (pieces, inner + 2); values are numbered all u, then all v.
        """
        nodes = self.space.size + 1
        local = np.empty((self.pieces, self.inner + 2), dtype=np.int64)
        sign = np.ones((self.pieces, self.inner + 2))
        local[:, 1:-1] = np.concatenate(
            [np.arange(1, nodes - 1), np.arange(nodes + 1, 2 * nodes - 1)]
        )
        for piece, crossing in enumerate(self.route.crossings):
            local[piece, 0] = (1 - EDGES[crossing.to_side].fixed_axis) * nodes
            sign[piece, 0] = -1.0 if crossing.flipped else 1.0
            # The piece before; of the first one, the last.
            fixed = EDGES[crossing.from_side].fixed_axis
            local[piece - 1, -1] = (1 - fixed) * nodes + nodes - 1
        return local, sign

    def straight(self) -> Array:
        """The unknowns of the loop that is straight in (u, v) on each patch."""
        ends = np.array(
            [[self.route.entry(i)[1:], self.route.exit(i)[1:]] for i in range(self.pieces)]
        )
        start, stop = ends[:, 0, :, None], ends[:, 1, :, None]
        lines = start + (stop - start) * self.space.nodes[1:-1]
        return self.unknowns(np.array(self.route.along), lines)

    def unknowns(self, along: Array, inner: Array) -> Array:
        """From crossings (pieces,) and values at the inner nodes (pieces, 2, n - 1)."""
        result: Array = np.empty(self.count)
        result[self.joints] = along
        result[self.rows[:, 1:-1]] = inner.reshape(self.pieces, -1)
        return np.asarray(np.clip(result, 0.0, 1.0))

    def values(self, unknowns: Array) -> Array:
        """(u, v) at the nodes of all pieces, shape (pieces, 2, n + 1)."""
        result: Array = np.empty((self.pieces, 2, self.space.size + 1))
        result[:, :, 1:-1] = unknowns[self.rows[:, 1:-1]].reshape(self.pieces, 2, -1)
        route = self.at(unknowns)
        for piece in range(self.pieces):
            result[piece, :, 0] = route.entry(piece)[1:]
            result[piece, :, -1] = route.exit(piece)[1:]
        return result

    def at(self, unknowns: Array) -> Route:
        """The route that crosses its seams where the unknowns say."""
        return Route(None, self.route.crossings, tuple(unknowns[self.joints].tolist()))

    def bends(self, unknowns: Array) -> tuple[Array, Array, Array]:
        """Of each piece, the root, its gradient and its Hessian by the piece's unknowns."""
        energy = expand(ENERGY, self.surface, self.space, self.values(unknowns), ALL_NODES)
        root = np.sqrt(2.0 * energy.value + EPSILON)
        slope = np.take_along_axis(energy.gradient, self.local, axis=1) * self.sign / root[:, None]
        piece = np.arange(self.pieces)[:, None, None]
        bend = energy.hessian[piece, self.local[:, :, None], self.local[:, None, :]]
        bend = bend * (self.sign[:, :, None] * self.sign[:, None, :]) / root[:, None, None]
        bend -= slope[:, :, None] * slope[:, None, :] / root[:, None, None]
        return root, slope, bend

    def expand(self, unknowns: Array) -> RouteExpansion:
        """The sum over the pieces, to the second order."""
        root, slope, bend = self.bends(unknowns)
        gradient = np.zeros(self.count)
        np.add.at(gradient, self.rows, slope)
        bands = np.zeros((3 * (self.inner + 1), self.count))
        row, column = np.broadcast_arrays(self.rows[:, :, None], self.rows[:, None, :])
        # Of a pair of unknowns one is the lower; a single piece ends in the unknown it starts with.
        lower = row >= column
        np.add.at(bands, ((row - column)[lower], column[lower]), bend[lower])
        return RouteExpansion(float(root.sum()), gradient, bands)


def _folded(count: int) -> NDArray[np.int64]:
    """The places of blocks 0, 1, ... in the order 0, k - 1, 1, k - 2, ..."""
    number = np.arange(count)
    return np.where(2 * number < count, 2 * number, 2 * (count - number) - 1)
