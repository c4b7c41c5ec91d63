r"""The length of the shortest path along a route, its error, and the kind of a loop.

For each piece, with its ends fixed, `lengths.measure` gives the excess of its length, which is
subtracted, and an estimate of the rest. The true path crosses each seam elsewhere, where the unit
tangents of both pieces have equal components along the seam. Let :math:`r` be the difference of
these components, times the speed of the seam's parameter. Moving the crossings by :math:`\delta`
changes the length by :math:`r^T \delta + \tfrac12 \delta^T S \delta`, in which :math:`S` is the
Hessian of the length by the crossings alone, the pieces between them being the shortest. Its
minimum :math:`-\tfrac12 r^T S^{-1} r`, tripled twice since the end tangents have errors as large,
is added to the estimate. A crossing that a corner holds stays where it is and counts for nothing.

A piece that a seam holds, because the neighbor is no better, is the shortest only of those on its
patch: its excess is added to its error rather than subtracted from its length.

The excess of a piece of hardly any length is at most the difference between it and its chord. What
smooths the length (`problem.EPSILON`) moves the ends of a piece of length :math:`l` by parts of it
of the order of :math:`\varepsilon / l^2`, which lengthens the path by the square of that, and by no
more than :math:`2 l`: the piece, there and back, joins what is before and after it.

The error covers paths along this route; it says nothing of other routes.

For a loop, S measured across the loop, in parts of the lengths between crossings, has the
eigenvalues of the periodic Jacobi operator :math:`-\psi'' - K \psi`, from below and as finely as
the crossings stand: positive ones prove that all loops close to it are longer. One of zero belongs
to a family of loops of one length, as about a cylinder.
"""

from enum import Enum
from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas.seams import EDGES
from bodymeasure.geodesic.across.pieces.refine import RefinedPath
from bodymeasure.geodesic.lengths.length import UNKNOWN, Length, is_leading_order
from bodymeasure.geodesic.numerics.banded import solve_free

# See the text above.
JOINT_SAFETY = 9.0
# A piece below this part of the path's length counts as straight.
STRAIGHT = 1e-5
# The parts of itself that are added to the Hessian's diagonal where rounding makes it singular.
DAMPINGS = (0.0, 1e-12, 1e-10, 1e-8)
# Lengths are sums of differences of coordinates of the patches' size.
ROUNDING = 4e-16
# Eigenvalues below this part of the square of 2 pi over a loop's length are zero, except for
# rounding.
FLAT = 1e-8
# A loop's crossing is left out if the sine of its angle with the seam is below this.
ALONG = 1e-6


class LoopKind(Enum):
    """What loops lie close to a closed geodesic; each value is a sentence.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> bm.LoopKind.MINIMUM.value
    'All loops close to it are longer.'
    """

    MINIMUM = "All loops close to it are longer."
    FLAT = (
        "No loop close to it is shorter, but some are as long, to the second order: it is one of a "
        "family, as about a cylinder, and which one depends on the start."
    )
    SADDLE = (
        "Some loops close to it are shorter: it only balances, as about a barrel's widest part."
    )


def route_length(refined: RefinedPath) -> tuple[Length, LoopKind | None]:
    """Return the length of a refined path in the atlas's unit, and the kind of a loop.

    The index is 0 for a path with ends that is shorter than all paths close to it along its route,
    and for a loop that is a minimum; else it is not known.
    """
    problem, total = refined.problem, refined.lengths.sum()
    correction, error, residual, least, short = _of_pieces(refined)
    crossings = _crossings(refined, short)
    kind: LoopKind | None = None
    if problem.route.closed:
        jump, excess, kind = _of_loop(refined, crossings)
    else:
        jump, excess = _of_path(refined, crossings)
    known = bool(np.isfinite(error).all() and np.isfinite(excess))
    # The nets' coordinates are rounded before they are subtracted.
    nets = problem.surface.control_points
    rounding = ROUNDING * (np.ptp(nets, axis=(1, 2)).max(axis=1).sum() + np.abs(nets).max())
    whole = error.sum() + JOINT_SAFETY * excess + rounding
    minimal = bool(least.all()) and bool(np.isfinite(excess))
    if kind is not None:
        minimal = kind is LoopKind.MINIMUM
    length = Length(
        raw=total,
        correction=np.asarray(correction.sum() if known else 0.0),
        error=np.asarray(whole if known else np.inf),
        residual=np.maximum(residual.max(), jump),
        index=np.asarray(0 if minimal else UNKNOWN),
        trusted=np.asarray(known and is_leading_order(correction, residual, total).all()),
    )
    return length.scaled(problem.size), kind


def piece_errors(refined: RefinedPath) -> Array:
    """Return the error of each piece's length, with its ends fixed, as a part of the whole.

    Shape (pieces,); infinite where the estimate is not to be trusted.
    """
    total = refined.lengths.sum()
    pieces = _of_pieces(refined)
    trusted = is_leading_order(pieces.correction, pieces.residual, total)
    return np.asarray(np.where(trusted, pieces.error / total, np.inf))


def joint_jumps(refined: RefinedPath) -> Array:
    """Return by how much the unit tangents differ along the seam, where a path crosses one.

    Shape (crossings,); zero where the crossing counts for nothing.
    """
    return _jumps(_crossings(refined, refined.lengths < STRAIGHT * refined.lengths.sum()))


def _jumps(crossings: "_Crossings") -> Array:
    """Return what `joint_jumps` does, of crossings that are known."""
    length = np.linalg.norm(crossings.seam, axis=1)
    count = crossings.movable & ~crossings.short & (length > 0.0)
    jumps = np.abs(crossings.difference) / np.where(count, length, 1.0)
    return np.asarray(np.where(count, jumps, 0.0))


class _Pieces(NamedTuple):
    """What is known of each piece with its ends fixed; arrays of shape (pieces,).

    Parameters
    ----------
    correction, error, residual : ndarray
        As in `Length`, in parts of the problem's size.
    minimal, short : ndarray of bool
        The pieces that no piece close by undercuts, and those of hardly any length.
    """

    correction: Array
    error: Array
    residual: Array
    minimal: Bools
    short: Bools


def _of_pieces(refined: RefinedPath) -> _Pieces:
    measured, total = refined.by_piece, refined.lengths.sum()
    short = refined.lengths < STRAIGHT * total
    places = refined.at_ends[0]
    chord = np.linalg.norm(places[..., 1] - places[..., 0], axis=0)
    correction = np.where(short, 0.0, measured.correction)
    error = np.where(short, refined.lengths - chord, measured.error) + _smoothing(refined)
    residual = np.where(short, 0.0, measured.residual)
    held = refined.held_nodes.any(axis=(1, 2))
    error = error + np.where(held, np.abs(correction), 0.0)
    correction = np.where(held, 0.0, correction)
    return _Pieces(correction, error, residual, measured.minimal | short, short)


def _smoothing(refined: RefinedPath) -> Array:
    """Return the most that the smoothing of the length may add at each piece: (pieces,)."""
    lengths, epsilon = refined.lengths, refined.problem.epsilon
    moved = epsilon / np.maximum(lengths**2, epsilon)
    return np.asarray(np.where(refined.smoothed, 2.0 * lengths * moved**2, 0.0))


class _Crossings(NamedTuple):
    """How a path crosses its seams.

    Parameters
    ----------
    seam : ndarray, shape (crossings, 3)
        The derivative by the parameter along the side that is left.
    tangent : ndarray, shape (crossings, 3)
        The mean of the unit tangents of the piece before and of the one after.
    difference : ndarray, shape (crossings,)
        The component along the seam by which they differ, times the seam's derivative.
    movable : ndarray of bool, shape (crossings,)
        The crossings that count: neither held nor beside a piece so short that it is smoothed.
    short : ndarray of bool, shape (crossings,)
        The crossings beside a piece of hardly any length, whose tangent is known to few digits.
    """

    seam: Array
    tangent: Array
    difference: Array
    movable: Bools
    short: Bools


def _crossings(refined: RefinedPath, short: Bools) -> _Crossings:
    problem = refined.problem
    _, slopes, _ = problem.space.at_ends
    moved = refined.values - refined.values[:, :, :1]
    _, s_u, s_v = refined.at_ends
    du, dv = (moved @ slopes.T).transpose(1, 0, 2)
    velocity = s_u * du + s_v * dv
    speed = np.linalg.norm(velocity, axis=0)
    tangent = velocity / np.where(speed > 0.0, speed, 1.0)
    crossings = problem.route.crossings
    # Before the first crossing of a loop is its last piece, number -1.
    before = np.arange(len(crossings)) - problem.route.closed
    fixed = np.array([EDGES[crossing.from_side].fixed_axis for crossing in crossings])
    seam = np.where(fixed == 0, s_v[:, before, 1], s_u[:, before, 1]).T
    smoothed = refined.smoothed
    leaving, entering = tangent[:, before, 1].T, tangent[:, before + 1, 0].T
    return _Crossings(
        seam=seam,
        tangent=0.5 * (leaving + entering),
        difference=((leaving - entering) * seam).sum(axis=1),
        movable=~(refined.minimum.held[problem.joints] | smoothed[before] | smoothed[before + 1]),
        short=short[before] | short[before + 1],
    )


def _of_path(refined: RefinedPath, crossings: _Crossings) -> tuple[float, float]:
    """The largest difference of tangents at the crossings of a path, and its excess.

    The difference is that of the unit tangents' components along a seam. The excess is infinite
    where the path is no minimum.
    """
    jump = _jumps(crossings)
    right = np.zeros(refined.problem.count)
    right[refined.problem.joints] = np.where(crossings.movable, crossings.difference, 0.0)
    free = ~(refined.minimum.held | refined.problem.idle)
    for damping in DAMPINGS:
        bands = refined.minimum.bands.copy()
        bands[0] *= 1.0 + damping
        shift = solve_free(bands, np.where(free, right, 0.0), free)
        if shift is not None:
            return jump.max(initial=0.0), float(0.5 * right @ shift)
    return jump.max(initial=0.0), np.inf


def _of_loop(refined: RefinedPath, crossings: _Crossings) -> tuple[float, float, LoopKind]:
    """Return what `_of_path` returns, for a loop, and its kind."""
    seam, mean = crossings.seam, crossings.tangent
    mean = mean / np.linalg.norm(mean, axis=1)[:, None]
    length = np.linalg.norm(seam, axis=1)
    across = np.linalg.norm(seam - (seam * mean).sum(axis=1)[:, None] * mean, axis=1)
    free = crossings.movable & ~crossings.short & (across > ALONG * length)
    if not free.any():
        return 0.0, 0.0, LoopKind.MINIMUM
    right = crossings.difference[free]
    jump = float(np.max(np.abs(right) / length[free]))
    stiffness = _stiffness(refined)
    if stiffness is None:
        return jump, np.inf, LoopKind.SADDLE
    scaled = stiffness[np.ix_(free, free)] / np.outer(across[free], across[free])
    mass = 0.5 * (refined.lengths + np.roll(refined.lengths, 1))[free]
    value, vector = scipy.linalg.eigh(scaled, np.diag(mass))
    flat = FLAT * (2.0 * np.pi / refined.lengths.sum()) ** 2
    share = vector.T @ (right / across[free])
    excess = 0.5 * float((share**2 / np.maximum(np.abs(value), flat)).sum())
    kind = LoopKind.MINIMUM if value[0] > flat else LoopKind.FLAT
    return jump, excess, LoopKind.SADDLE if value[0] < -flat else kind


def _stiffness(loop: RefinedPath) -> Array | None:
    """The Hessian of a loop's length by its crossings; None if a piece is not the shortest."""
    _, _, bend = loop.problem.by_piece(loop.minimum.unknowns)
    # What is held stays where it is: its row and column are those of the identity.
    free = ~loop.minimum.held[loop.problem.rows[:, 1:-1]]
    within = np.where(free[:, :, None] & free[:, None, :], bend[:, 1:-1, 1:-1], 0.0)
    diagonal = np.arange(free.shape[1])
    within[:, diagonal, diagonal] += ~free
    beside = np.where(free[:, :, None], bend[:, 1:-1, [0, -1]], 0.0)
    try:
        np.linalg.cholesky(within)
    except np.linalg.LinAlgError:
        return None
    condensed = bend[:, [[0], [-1]], [0, -1]]
    condensed = condensed - beside.transpose(0, 2, 1) @ np.linalg.solve(within, beside)
    pieces = len(bend)
    result = np.zeros((pieces, pieces))
    at = (np.arange(pieces)[:, None] + (0, 1)) % pieces
    np.add.at(result, (at[:, :, None], at[:, None, :]), condensed)
    return result
