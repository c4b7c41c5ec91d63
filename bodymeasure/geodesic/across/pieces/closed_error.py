r"""How long the shortest loop along a route is, how sure that is, and what kind of loop it is.

On each piece, what `length_error` says holds with the piece's ends in place. Moving the crossings
by :math:`\delta` changes the length by :math:`r^T \delta + \tfrac12 \delta^T S \delta`, as in
`route_error`, with S the Hessian of the length by the crossings alone, the pieces between them
being the shortest. Measured across the loop, in parts of the lengths between crossings, the
eigenvalues of S are those of the periodic Jacobi operator :math:`-\psi'' - K \psi`, from below and
as finely as the crossings stand: positive ones prove that all loops close to it are longer. One of
zero belongs to a family of loops of one length, as about a cylinder.
"""

from enum import Enum
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.atlas.seams import EDGES
from bodymeasure.geodesic.across.pieces.closed_refine import RefinedLoop
from bodymeasure.geodesic.across.pieces.route_error import JOINT_SAFETY, STRAIGHT, rounding_of
from bodymeasure.geodesic.lengths.length import TRUSTED_CORRECTION, TRUSTED_RESIDUAL
from bodymeasure.geodesic.lengths.measure import measure_length

# Of the square of 2 pi over the length: eigenvalues that small are zero, but for rounding.
FLAT = 1e-8
# Sine of the angle at which a seam is crossed, below which the crossing says nothing.
ALONG = 1e-6


class LoopKind(Enum):
    """What loops lie close to a closed geodesic; each value is a sentence."""

    MINIMUM = "All loops close to it are longer."
    FLAT = (
        "No loop close to it is shorter, but some are as long, to the second order: it is one of a "
        "family, as about a cylinder, and which one depends on the start."
    )
    SADDLE = (
        "Some loops close to it are shorter: it only balances, as about a barrel's widest part."
    )


class LoopLength(NamedTuple):
    """The length of a loop, in the atlas's unit.

    Parameters
    ----------
    raw : float
        Of the loop as computed.
    corrected : float
        Of the closed geodesic: less its excess.
    error : float
        Estimated error of that; infinite where nothing is known.
    residual : float
        Largest geodesic curvature times the piece's length, and largest difference of the unit
        tangents' parts along a seam where it is crossed: 0 for a geodesic.
    trusted : bool
        Whether the corrections are small enough to be leading order.
    kind : LoopKind
    """

    raw: float
    corrected: float
    error: float
    residual: float
    trusted: bool
    kind: LoopKind


def loop_length(loop: RefinedLoop) -> LoopLength:
    """The length of a refined loop, its error, and what is known of it."""
    problem, size, total = loop.problem, loop.problem.size, loop.lengths.sum()
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        measured = measure_length(problem.surface, problem.space, loop.values)
    short = loop.lengths < STRAIGHT * total
    ends = problem.surface.positions(loop.values[:, :, [0, -1]].transpose(0, 2, 1))
    chord = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=-1)
    held = loop.held_nodes.any(axis=(1, 2))
    correction = np.where(short, 0.0, measured.correction)
    error = np.where(short, loop.lengths - chord, measured.error)
    # A piece that a seam holds is the shortest only of those on its patch.
    error = error + np.where(held, np.abs(correction), 0.0)
    correction = np.where(held, 0.0, correction)
    residual = np.where(short, 0.0, measured.residual)
    jumps, excess, kind = _joints(loop, short)
    known = bool(np.isfinite(error).all() and np.isfinite(excess))
    trusted = known and bool(
        (np.abs(correction) <= TRUSTED_CORRECTION * total).all()
        and (residual <= TRUSTED_RESIDUAL).all()
    )
    whole = error.sum() + JOINT_SAFETY * excess + rounding_of(problem.surface.control_points)
    return LoopLength(
        raw=float(total * size),
        corrected=float((total - correction.sum()) * size) if known else float(total * size),
        error=float(whole * size) if known else np.inf,
        residual=float(max(residual.max(), jumps)),
        trusted=trusted,
        kind=kind,
    )


def _joints(loop: RefinedLoop, short: NDArray[np.bool_]) -> tuple[float, float, LoopKind]:
    """The largest difference of tangents along a seam, its excess, and the loop's kind."""
    seam, tangent = _at_crossings(loop)
    mean = tangent.mean(axis=0)
    mean /= np.linalg.norm(mean, axis=1)[:, None]
    length = np.linalg.norm(seam, axis=1)
    across = np.linalg.norm(seam - (seam * mean).sum(axis=1)[:, None] * mean, axis=1)
    free = ~(loop.held_joints | short | np.roll(short, 1)) & (across > ALONG * length)
    if not free.any():
        return 0.0, 0.0, LoopKind.MINIMUM
    right = ((tangent[0] - tangent[1]) * seam).sum(axis=1)
    jump = float(np.max(np.abs(right[free]) / length[free]))
    stiffness, definite = _stiffness(loop)
    if not definite:
        return jump, np.inf, LoopKind.SADDLE
    scaled = stiffness[np.ix_(free, free)] / np.outer(across[free], across[free])
    mass = 0.5 * (loop.lengths + np.roll(loop.lengths, 1))[free]
    value, vector = scipy.linalg.eigh(scaled, np.diag(mass))
    flat = FLAT * (2.0 * np.pi / loop.lengths.sum()) ** 2
    share = vector.T @ (right[free] / across[free])
    excess = 0.5 * float((share**2 / np.maximum(np.abs(value), flat)).sum())
    kind = LoopKind.MINIMUM if value[0] > flat else LoopKind.FLAT
    return jump, excess, LoopKind.SADDLE if value[0] < -flat else kind


def _at_crossings(loop: RefinedLoop) -> tuple[Array, Array]:
    """Where pieces start: the seam's tangent by its parameter (pieces, 3), and the unit tangents.

    The latter of shape (2, pieces, 3), of the piece before and of the one after.
    """
    problem = loop.problem
    slopes = problem.space.matrices([0.0, 1.0])[1]
    moved = loop.values - loop.values[:, :, :1]
    ends = loop.values[:, :, [0, -1]].transpose(0, 2, 1)
    _, s_u, s_v = problem.surface.jet(ends, 1)
    du, dv = (moved @ slopes.T).transpose(1, 0, 2)
    velocity = s_u * du + s_v * dv
    speed = np.linalg.norm(velocity, axis=0)
    tangent = velocity / np.where(speed > 0.0, speed, 1.0)
    # Along the side that is left, by the piece before.
    fixed = np.array([EDGES[crossing.from_side].fixed_axis for crossing in problem.route.crossings])
    before = np.roll(np.arange(problem.pieces), 1)
    seam = np.where(fixed == 0, s_v[:, before, 1], s_u[:, before, 1]).T
    return seam, np.stack([tangent[:, before, 1].T, tangent[:, :, 0].T])


def _stiffness(loop: RefinedLoop) -> tuple[Array, bool]:
    """The Hessian of the length by the crossings, and whether all pieces are the shortest."""
    problem = loop.problem
    _, _, bend = problem.bends(loop.minimum.unknowns)
    result = np.zeros((problem.pieces, problem.pieces))
    held = loop.minimum.held[problem.rows]
    for piece in range(problem.pieces):
        inner = 1 + np.flatnonzero(~held[piece, 1:-1])
        ends = np.array([0, problem.inner + 1])
        condensed = bend[piece][np.ix_(ends, ends)]
        if len(inner):
            within = bend[piece][np.ix_(inner, inner)]
            try:
                factor = scipy.linalg.cho_factor(within, lower=True)
            except scipy.linalg.LinAlgError:
                return result, False
            beside = bend[piece][np.ix_(inner, ends)]
            condensed = condensed - beside.T @ scipy.linalg.cho_solve(factor, beside)
        at = np.array([piece, (piece + 1) % problem.pieces])
        np.add.at(result, (at[:, None], at), condensed)
    return result, True
