r"""The length of a path over several patches, to the second order in all its unknowns.

On each patch the path is a polynomial, given by (u, v) at its nodes; where it crosses a seam, both
pieces end at the same point of it, given by one number. The sum of
:math:`\sqrt{\int |x'|^2 dt + \varepsilon}` over the pieces is the length, if each has a constant
speed, and more if not: its minimum is the shortest path, each piece at a constant speed.

The unknowns of each piece and one crossing beside it are a block. Along a path with ends the blocks
stand in order, so that only neighboring ones are coupled. In a loop the last piece is coupled with
the first one, too: taken in the order 0, k - 1, 1, k - 2, ..., no two coupled blocks are more than
two apart. So the Hessian is banded either way.
"""

from functools import cached_property, lru_cache

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.prepared import prepared
from bodymeasure.atlas.seams import AXIS, EDGES
from bodymeasure.atlas.topology.neighbors import on_side
from bodymeasure.bezier import scaled
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.lengths.functionals import energy, path_tables
from bodymeasure.geodesic.numerics.box_newton import (
    FIRST,
    MAX_STEPS,
    BoxMinimum,
    SecondOrder,
    minimize_in_box,
    newton_settings,
)
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.geodesic.surfaces.rational import surfaces_of
from bodymeasure.native import RouteArrays, route_newton

# Where a piece has no length, the root would have no derivative without this. It is in units of the
# whole path's length. A piece below its root would count for less than its length, so that its ends
# could move for nothing: `refine` makes it smaller where a path has such pieces.
EPSILON = 1e-14
ALL_NODES = slice(None)
# The derivatives' nets of so many patches are kept for the next path: bicubic ones take 4 KB each.
MOST_PATCHES = 4096

Slides = tuple[int | None, int | None]
"""The sides of their patches along which the start and the end of a path may move."""


class RouteProblem:
    """The paths or loops along a route, and what their unknowns mean.

    The unknowns of a piece are where it starts along its first seam, its inner nodes (all u, then
    all v) and where it ends along its last seam. Where a path with ends starts and ends is an
    unknown as well, but idle unless that end slides along an edge.

    Parameters
    ----------
    atlas : Atlas
    route : Route
    space : TrialSpace
        The trial space of each piece.
    size : float
        About the length of the path, by which the patches are scaled.
    slides : pair of int or None
        The side of its patch along which the start, or the end, may move.
    epsilon : float
        What is added under the root.

    Attributes
    ----------
    joints : ndarray of int, shape (crossings,)
        The unknown of each crossing.
    rows : ndarray of int, shape (pieces, k)
        The unknowns of each piece, in the order above.
    local : ndarray of int, shape (pieces, k)
        The nodal value that each of them moves; values are numbered all u, then all v.
    sign : ndarray, shape (pieces, k)
        The derivative of that value: 1, or -1 along a seam that runs the other way, or 0 for idle
        unknowns.
    idle : ndarray of bool, shape (unknowns,)
        The unknowns that move nothing.
    """

    def __init__(
        self,
        atlas: Atlas,
        route: Route,
        space: TrialSpace,
        size: float,
        slides: Slides = (None, None),
        epsilon: float = EPSILON,
    ) -> None:
        self.atlas, self.route, self.space = atlas, route, space
        self.size, self.slides, self.epsilon = size, slides, epsilon
        self.surface = surfaces_of(scaled(atlas.control_points[list(route.patches)], 1.0 / size))
        if isinstance(self.surface, BezierSurfaces) and len(atlas) <= MOST_PATCHES:
            self.surface.nets = _nets(atlas)[list(route.patches)] * (1.0 / size)
        nodes, pieces = space.size + 1, len(route.patches)
        self.rows, self.joints, local, self.count, bands = _numbered(
            pieces, space.size, route.closed
        )
        # The sides on which each piece starts and ends; -1 where it does so at a point.
        sides, flipped = np.full((2, pieces, 2), -1)
        for piece, (end, side) in zip((0, -1), enumerate(slides), strict=True):
            sides[piece, end] = -1 if side is None else side
        crossed = [(each.from_side, each.to_side, each.flipped) for each in route.crossings]
        if crossed:
            # Before the first crossing of a loop is its last piece, number -1.
            before = np.arange(len(crossed)) - route.closed
            sides[before, 1], sides[before + 1, 0], flipped[before + 1, 0] = np.array(crossed).T
        moves, turned = sides >= 0, flipped > 0
        # The first column and the last one.
        ends = slice(None, None, local.shape[1] - 1)
        self.local = local.copy()
        self.local[:, ends] += moves * (1 - AXIS[sides]) * nodes
        self.sign = np.ones(local.shape)
        self.sign[:, ends] = np.where(turned, -1.0, moves)
        # The nodal values that no unknown moves, and the values of the others where the unknowns
        # are 0, which is 1 along a seam that runs the other way.
        self._fixed = np.zeros((pieces, 2, nodes))
        self._fixed[:, :, [0, -1]] = np.array(route.pieces)[:, :, 1:].transpose(0, 2, 1)
        self._offset = np.zeros(local.shape)
        self._offset[:, ends] = np.where(moves, turned, self._fixed[:, 0, :: nodes - 1])
        self.idle = np.zeros(self.count, bool)
        self.idle[self.rows[self.sign == 0.0]] = True
        self._size_of_bands = bands * self.count

    @cached_property
    def _in_bands(self) -> tuple[Bools, Ints]:
        """Which entries of the pieces' Hessians are wanted, and their places in the bands."""
        row, column = np.broadcast_arrays(self.rows[:, :, None], self.rows[:, None, :])
        # One of a pair of unknowns is the lower; a loop's single piece ends in the unknown in which
        # it starts.
        lower = row >= column
        return lower, ((row - column) * self.count + column)[lower]

    def unknowns(self, inner: Array | None = None) -> Array:
        """Return the unknowns of a path whose pieces meet where the route says.

        Parameters
        ----------
        inner : ndarray, shape (pieces, 2, n - 1), optional
            (u, v) at the inner nodes; on straight lines if not given.
        """
        if inner is None:
            start, stop = self._fixed[:, :, :1], self._fixed[:, :, -1:]
            inner = start + (stop - start) * self.space.nodes[1:-1]
        result: Array = np.full(self.count, 0.5)
        result[self.joints] = self.route.along
        result[self.rows[:, 1:-1]] = inner.reshape(len(inner), -1)
        for row, side, end in zip((0, -1), self.slides, self.route.ends or (), strict=False):
            if side is not None:
                result[row] = end[2 - EDGES[side].fixed_axis]
        return np.asarray(np.clip(result, 0.0, 1.0))

    def values(self, unknowns: Array) -> Array:
        """Return (u, v) at the nodes of all pieces, shape (pieces, 2, n + 1)."""
        result = self._fixed.reshape(len(self.rows), -1).copy()
        piece = np.arange(len(result))[:, None]
        result[piece, self.local] = self._offset + self.sign * unknowns[self.rows]
        return result.reshape(self._fixed.shape)

    def at(self, unknowns: Array) -> Route:
        """Return the route that crosses its seams where the unknowns say."""
        ends = self.route.ends
        if ends is not None:
            start, end = (
                here
                if side is None
                else AtlasPoint(here.patch, *on_side(side, float(unknowns[row])))
                for row, side, here in zip((0, -1), self.slides, ends, strict=True)
            )
            ends = start, end
        return Route(ends, self.route.crossings, tuple(unknowns[self.joints].tolist()))

    def by_piece(self, unknowns: Array) -> tuple[Array, Array, Array]:
        """Return the root of each piece, its gradient and its Hessian by the piece's unknowns."""
        whole = energy(self.surface, self.space, self.values(unknowns), ALL_NODES)
        root = np.sqrt(2.0 * whole.value + self.epsilon)
        local, sign = self.local, self.sign
        slope = np.take_along_axis(whole.gradient, local, axis=1) * sign / root[:, None]
        piece = np.arange(len(root))[:, None, None]
        bend = whole.hessian[piece, local[:, :, None], local[:, None, :]]
        bend = bend * (sign[:, :, None] * sign[:, None, :]) / root[:, None, None]
        bend -= slope[:, :, None] * slope[:, None, :] / root[:, None, None]
        return root, slope, bend

    def minimized(
        self,
        start: Array,
        idle: Bools | None = None,
        most_steps: int = MAX_STEPS,
        damping: float = FIRST,
    ) -> BoxMinimum:
        """Return the minimum near a place; `numerics.box_newton.minimize_in_box` finds it.

        Parameters
        ----------
        start : ndarray, shape (unknowns,)
        idle : ndarray of bool, shape (unknowns,), optional
            Unknowns that stay as they are; those that move nothing if not given.
        most_steps : int
            The most steps.
        damping : float
            Its first value.
        """
        idle = self.idle if idle is None else idle
        tables = path_tables(self.surface, self.space)
        if tables is None:
            return minimize_in_box(self.expand, start, idle, most_steps, damping)
        bands = self._size_of_bands // self.count
        arrays = RouteArrays(
            self.rows, self.local, self.sign, self._offset, self._fixed, bands, self.epsilon
        )
        settings = newton_settings(most_steps, self._size_of_bands, damping)
        found = route_newton(tables, arrays, start, idle, settings)
        here = SecondOrder(found.value, found.gradient, found.bands)
        converged, iterations = found.converged, found.iterations
        return BoxMinimum.at(found.unknowns, here, idle, converged=converged, iterations=iterations)

    def expand(self, unknowns: Array) -> SecondOrder:
        """Return the sum over the pieces, to the second order."""
        root, slope, bend = self.by_piece(unknowns)
        gradient: Array = np.zeros(self.count)
        np.add.at(gradient, self.rows, slope)
        bands: Array = np.zeros(self._size_of_bands)
        lower, places = self._in_bands
        np.add.at(bands, places, bend[lower])
        return SecondOrder(float(root.sum()), gradient, bands.reshape(-1, self.count))


@prepared
def _nets(atlas: Atlas) -> Array:
    """The nets of the derivatives of all patches, as in `BezierSurfaces`."""
    return BezierSurfaces(atlas.control_points).nets


@lru_cache(maxsize=256)
def _numbered(pieces: int, size: int, closed: bool) -> tuple[Ints, Ints, Ints, int, int]:
    """What `RouteProblem` has from the number of pieces: how its unknowns are numbered.

    Its rows, its joints, the values that unknowns move if they all move u, the number of unknowns,
    and that of the Hessian's bands.
    """
    nodes = size + 1
    inner = np.concatenate([np.arange(1, size), np.arange(nodes + 1, nodes + size)])
    block = len(inner) + 1
    begins = (_folded(pieces) if closed else np.arange(pieces)) * block
    # In a loop, a crossing that is eliminated before its piece would couple that to the one before.
    entries, inside = (begins + len(inner), begins) if closed else (begins, begins + 1)
    exits = np.roll(entries, -1) if closed else entries + block
    rows = np.column_stack([entries, inside[:, None] + np.arange(len(inner)), exits])
    joints = entries if closed else exits[:-1]
    local = np.tile([0, *inner, size], (pieces, 1))
    return rows, joints, local, int(rows.max()) + 1, int(np.ptp(rows, axis=1).max()) + 1


def _folded(count: int) -> Ints:
    """The places of blocks 0, 1, ... in the order 0, k - 1, 1, k - 2, ..."""
    number = np.arange(count)
    return np.where(2 * number < count, 2 * number, 2 * (count - number) - 1)
