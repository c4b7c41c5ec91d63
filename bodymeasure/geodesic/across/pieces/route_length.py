r"""The length of a path over several patches, to the second order in all its unknowns.

On each patch the path is a polynomial, given by (u, v) at its nodes; where it crosses a seam, both
pieces end at the same point of it, given by one number. The sum of
:math:`\sqrt{\int |x'|^2 dt + \varepsilon}` over the pieces is the length, if each has a constant
speed, and more if not: its minimum is the shortest path, each piece at a constant speed.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import on_side
from bodymeasure.bezier import scaled
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.lengths.functionals import Functional, expand
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.rational import surfaces_of

# Pieces may be of no length, where the root has no derivative. In units of the whole path's length.
EPSILON = 1e-14
ALL_NODES = slice(None)
ENERGY = Functional("energy")


@dataclass(frozen=True, eq=False)
class RouteExpansion:
    """The sum over the pieces, its gradient, and the lower bands of its Hessian.

    Parameters
    ----------
    value : float
    gradient : ndarray, shape (unknowns,)
    bands : ndarray, shape (bandwidth + 1, unknowns)
        ``bands[i, j]`` is the Hessian at row i + j, column j.
    """

    value: float
    gradient: Array
    bands: Array


class RouteProblem:
    """Paths along a route: what their unknowns mean.

    The unknowns are, in order, one number for the start, then for each piece its inner nodes (all
    u, then all v) and where it ends along the seam. Those for the start and the end are idle,
    unless these slide along an edge.

    Parameters
    ----------
    atlas : Atlas
    route : Route
    space : TrialSpace
        Of each piece.
    size : float
        About the length of the path, for scaling.
    slides : pair of int or None
        The side of its patch along which the start, or the end, may move.
    """

    def __init__(
        self,
        atlas: Atlas,
        route: Route,
        space: TrialSpace,
        size: float,
        slides: tuple[int | None, int | None] = (None, None),
    ) -> None:
        self.atlas, self.route, self.space = atlas, route, space
        self.size, self.slides = size, slides
        self.pieces = len(route.patches)
        self.surface = surfaces_of(scaled(atlas.control_points[list(route.patches)], 1.0 / size))
        self.inner = 2 * (space.size - 1)
        self.count = self.pieces * (self.inner + 1) + 1
        # Where the seams' unknowns stand, and before and after them those of the ends.
        self.joints = np.arange(self.pieces + 1) * (self.inner + 1)
        self.local, self.sign = self._dependence()

    def _dependence(self) -> tuple[NDArray[np.int64], Array]:
        """For each piece's unknowns, the nodal value that each moves, and which way.

        Two arrays of shape (pieces, inner + 2); values are numbered all u, then all v. The sign is
        0 for the idle unknowns.
        """
        nodes = self.space.size + 1
        inner = np.concatenate([np.arange(1, nodes - 1), np.arange(nodes + 1, 2 * nodes - 1)])
        local = np.zeros((self.pieces, self.inner + 2), dtype=np.int64)
        sign = np.ones((self.pieces, self.inner + 2))
        local[:, 1:-1] = inner
        for place, node, side in ((0, 0, self.slides[0]), (-1, nodes - 1, self.slides[1])):
            if side is None:
                sign[place, place] = 0.0
            else:
                local[place, place] = (1 - EDGES[side].fixed_axis) * nodes + node
        for piece, crossing in enumerate(self.route.crossings):
            local[piece, -1] = (1 - EDGES[crossing.from_side].fixed_axis) * nodes + nodes - 1
            local[piece + 1, 0] = (1 - EDGES[crossing.to_side].fixed_axis) * nodes
            sign[piece + 1, 0] = -1.0 if crossing.flipped else 1.0
        return local, sign

    @cached_property
    def rows(self) -> NDArray[np.int64]:
        """The unknowns of each piece, shape (pieces, inner + 2)."""
        return self.joints[:-1, None] + np.arange(self.inner + 2)

    @cached_property
    def idle(self) -> NDArray[np.bool_]:
        """The unknowns of the ends, where they move nothing."""
        result = np.zeros(self.count, bool)
        result[[0, -1]] = [side is None for side in self.slides]
        return result

    @property
    def _ends(self) -> tuple[AtlasPoint, AtlasPoint]:
        return self.route.start, self.route.end

    def straight(self) -> Array:
        """The unknowns of the path that is straight in (u, v) on each patch."""
        unknowns = np.full(self.count, 0.5)
        unknowns[self.joints[1:-1]] = self.route.along
        for row, side, end in zip((0, -1), self.slides, self._ends, strict=True):
            if side is not None:
                unknowns[row] = end[2 - EDGES[side].fixed_axis]
        nodes = self.space.nodes[1:-1]
        for piece in range(self.pieces):
            enter, leave = self.route.entry(piece), self.route.exit(piece)
            lines = [
                first + (last - first) * nodes
                for first, last in ((enter.u, leave.u), (enter.v, leave.v))
            ]
            unknowns[self.joints[piece] + 1 : self.joints[piece + 1]] = np.concatenate(lines)
        return np.asarray(np.clip(unknowns, 0.0, 1.0))

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
        along = tuple(unknowns[self.joints[1:-1]].tolist())
        start, end = (
            here if side is None else AtlasPoint(here.patch, *on_side(side, float(unknowns[row])))
            for row, side, here in zip((0, -1), self.slides, self._ends, strict=True)
        )
        return Route((start, end), self.route.crossings, along)

    def expand(self, unknowns: Array) -> RouteExpansion:
        """The sum over the pieces, to the second order."""
        energy = expand(ENERGY, self.surface, self.space, self.values(unknowns), ALL_NODES)
        root = np.sqrt(2.0 * energy.value + EPSILON)
        local, sign = self.local, self.sign
        slope = np.take_along_axis(energy.gradient, local, axis=1) * sign / root[:, None]
        piece = np.arange(self.pieces)[:, None, None]
        bend = energy.hessian[piece, local[:, :, None], local[:, None, :]]
        bend = bend * (sign[:, :, None] * sign[:, None, :]) / root[:, None, None]
        bend -= slope[:, :, None] * slope[:, None, :] / root[:, None, None]
        gradient = np.zeros(self.count)
        np.add.at(gradient, self.rows, slope)
        bands = np.zeros((self.inner + 2, self.count))
        row, column = np.tril_indices(self.inner + 2)
        np.add.at(bands, (row - column, self.rows[:, column]), bend[:, row, column])
        return RouteExpansion(float(root.sum()), gradient, bands)
