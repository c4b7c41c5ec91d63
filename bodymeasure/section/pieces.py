"""Pieces of a section: points on them, and their lengths."""

from dataclasses import dataclass, fields
from functools import cached_property, lru_cache

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.bezier import bernstein, derivatives
from bodymeasure.native import MOST_DEGREE, CutPatches, Graphs, is_compiled, section_points
from bodymeasure.section.plane import Plane
from bodymeasure.section.roots import bracketed_roots
from bodymeasure.section.through.quotient import without_poles

# The nodes of two Gauss rules on each piece, whose difference is the error of the first one.
NODES, MORE_NODES = 8, 13
# A length may change by this part of the atlas's size from one rule to the next. What is below is
# the rounding of roots.
TOLERANCE = 1e-13
# The most halvings of a piece; graphs have no vertical tangent, so that a few are enough.
MAX_HALVINGS = 12


@dataclass(frozen=True, eq=False)
class Pieces:
    """Pieces of a section, each the graph of one parameter of a patch over the other.

    Parameters
    ----------
    patch : ndarray of int, shape (k,)
    axis : ndarray of int, shape (k,)
        The parameter that runs along the piece: 0 for u, 1 for v.
    start, stop : ndarray, shape (k,)
        Its values at the ends; it may run downwards.
    low, high : ndarray, shape (k,)
        Bounds of the other parameter.
    """

    patch: Ints
    axis: Ints
    start: Array
    stop: Array
    low: Array
    high: Array

    def __len__(self) -> int:
        return len(self.patch)

    def take(self, rows: Ints | Bools | slice) -> "Pieces":
        """Return some of the pieces."""
        return Pieces(
            self.patch[rows],
            self.axis[rows],
            self.start[rows],
            self.stop[rows],
            self.low[rows],
            self.high[rows],
        )

    def between(self, first: Array, last: Array) -> "Pieces":
        """Return the part of each piece from one fraction of its range to another."""
        span = self.stop - self.start
        # Fractions 0 and 1 give a piece's own ends to the last bit.
        start, stop = (np.where(t == 1.0, self.stop, self.start + t * span) for t in (first, last))
        return Pieces(self.patch, self.axis, start, stop, self.low, self.high)


@dataclass(frozen=True, eq=False)
class CutSurface:
    """The patches and the plane that pieces belong to; puts points on them.

    Parameters
    ----------
    control_points : ndarray, shape (patches, m + 1, m + 1, 3) or (patches, m + 1, m + 1, 4)
    plane : Plane
    poles : ndarray of bool, shape (patches, 4)
        The collapsed sides that lie in the plane.
    stretch : ndarray, shape (patches,), optional
        That of the atlas's approximation, if it has one.
    """

    control_points: Array
    plane: Plane
    poles: Bools
    stretch: Array | None = None

    def distances(self, patch: Ints) -> Array:
        """Return the distances of patches from the plane in Bernstein form, divided about poles."""
        return np.asarray(self.patches.distances[patch])

    @cached_property
    def patches(self) -> CutPatches:
        """The patches with all their distances from the plane."""
        distances = without_poles(self.plane.distances(self.control_points), self.poles)
        return CutPatches(self.control_points, distances, self.plane.normal)

    def parameters(self, pieces: Pieces, fraction: Array) -> Array:
        """Return (u, v) at fractions (k, n) of each piece's range, shape (k, n, 2)."""
        along = pieces.start[:, None] + fraction * (pieces.stop - pieces.start)[:, None]
        distance = self.distances(pieces.patch)
        over_v = (pieces.axis == 1)[:, None, None]
        turned = np.where(over_v, distance.swapaxes(1, 2), distance)
        across = bernstein(turned.shape[1] - 1, along)[..., 0, :] @ turned
        shape = along.shape
        low, high = (
            np.broadcast_to(bound[:, None], shape).ravel() for bound in (pieces.low, pieces.high)
        )
        other = bracketed_roots(across.reshape(-1, across.shape[-1]), low, high).reshape(shape)
        first = np.where(over_v[..., 0], other, along)
        second = np.where(over_v[..., 0], along, other)
        return np.stack([first, second], axis=-1)

    def points(self, pieces: Pieces, fraction: Array) -> tuple[Array, Array, Array]:
        """Return parameters (k, n, 2), positions and velocities by the fraction (k, n, 3)."""
        if is_compiled() and self.control_points.shape[1] <= MOST_DEGREE + 1:
            span = pieces.stop - pieces.start
            graphs = Graphs(pieces.patch, pieces.axis, pieces.start, span, pieces.low, pieces.high)
            return section_points(self.patches, graphs, fraction)
        parameters = self.parameters(pieces, fraction)
        jet = derivatives(self.control_points[pieces.patch], parameters, order=1)
        over_v = (pieces.axis == 1)[:, None, None]
        by_u, by_v = jet[..., 1, 0, :], jet[..., 0, 1, :]
        along, other = np.where(over_v, by_v, by_u), np.where(over_v, by_u, by_v)
        normal = self.plane.normal
        # A graph never runs along the other parameter, so its slope is finite.
        rise, run = along @ normal, other @ normal
        slope = np.divide(-rise, run, out=np.zeros_like(rise), where=run != 0.0)
        velocity = (along + slope[..., None] * other) * (pieces.stop - pieces.start)[:, None, None]
        return parameters, jet[..., 0, 0, :], velocity

    def lengths(self, pieces: Pieces, nodes: int = MORE_NODES) -> Array:
        """Return the lengths of pieces by Gauss quadrature, shape (k,)."""
        return np.asarray(self.measures(pieces, nodes)[0])

    def measures(self, pieces: Pieces, *rules: int) -> Array:
        """Return the lengths of pieces by Gauss rules of so many nodes, and what they sweep.

        These are (rules + 1) rows of shape (k,): the last one is twice the area that the way from
        the plane's point to the piece sweeps, by the first rule.
        """
        at, weights = _gauss(rules)
        fraction = np.broadcast_to(at, (len(pieces), len(at)))
        _, position, velocity = self.points(pieces, fraction)
        speed = np.sqrt(np.einsum("knc,knc->nk", velocity, velocity))
        a, b, c = self.plane.normal.tolist()
        # The normal times the cross product of two vectors is a product with a skew matrix.
        skew = np.array([[0.0, c, -b], [-c, 0.0, a], [b, -a, 0.0]])
        sweep = np.einsum("knc,knc->nk", (position - self.plane.point) @ skew, velocity)
        return np.concatenate([weights @ speed, weights[:1] @ sweep])


@lru_cache
def _gauss(rules: tuple[int, ...]) -> tuple[Array, Array]:
    """Return the nodes of all rules in [0, 1], and each rule's weights, 0 at those of others."""
    each = [np.polynomial.legendre.leggauss(nodes) for nodes in rules]
    at = np.concatenate([0.5 * (1.0 + x) for x, _ in each])
    return at, scipy.linalg.block_diag(*(0.5 * weights for _, weights in each))


def measured_pieces(surface: CutSurface, pieces: Pieces, size: float) -> tuple[Pieces, Array, Ints]:
    """Halve pieces until two quadrature rules agree on each one's length.

    Parameters
    ----------
    surface : CutSurface
    pieces : Pieces
        In the order in which they follow one another.
    size : float
        Size of the atlas, to which the tolerance is relative.

    Returns
    -------
    pieces : Pieces
        In the same order.
    measures : ndarray, shape (3, k)
        Lengths by the larger rule, their differences from the smaller one, and what the pieces
        sweep.
    origin : ndarray of int, shape (k,)
        Row of the piece that was given of which each is a part, or the whole.
    """
    order = np.arange(len(pieces), dtype=np.float64)
    done: list[tuple[Array, Pieces, Array]] = []
    for halving in range(MAX_HALVINGS + 1):
        measures = surface.measures(pieces, MORE_NODES, NODES)
        measures[1] = np.abs(measures[0] - measures[1])
        good = (measures[1] <= TOLERANCE * size) | (halving == MAX_HALVINGS)
        done.append((order[good], pieces.take(good), measures[:, good]))
        if good.all():
            break
        rest = pieces.take(np.repeat(np.flatnonzero(~good), 2))
        second = np.tile([0.0, 0.5], len(rest) // 2)
        pieces = rest.between(second, second + 0.5)
        order = np.repeat(order[~good], 2) + second * 0.5**halving
    order = np.concatenate([part[0] for part in done])
    rank = np.argsort(order)
    joined = Pieces(
        *(
            np.concatenate([getattr(part[1], field.name) for part in done])[rank]
            for field in fields(Pieces)
        )
    )
    measures = np.concatenate([part[2] for part in done], axis=1)[:, rank]
    return joined, measures, order[rank].astype(np.int64)
