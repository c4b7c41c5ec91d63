r"""How long the shortest path over several patches is, and how sure that is.

On each piece, what `length_error` says holds with the piece's ends in place: the path's excess is
subtracted, and the rest is estimated. Where a seam is crossed, the true path would cross elsewhere.
There the unit tangents of both pieces have equal parts along the seam; with :math:`r` what is left
of their difference, times the speed of the seam's parameter, moving the crossings by
:math:`\delta` changes the length by
:math:`r^T \delta + \tfrac12 \delta^T S \delta`, in which :math:`S` is the Hessian of the length by
the crossings alone, the pieces between them being the shortest. Its minimum
:math:`-\tfrac12 r^T S^{-1} r`, tripled twice since the end tangents have errors as large, is added
to the estimate. A crossing that a corner holds stays where it is and counts for nothing.

A piece that a seam holds, because the neighbor is no better, is the shortest only of those on its
patch: what would be subtracted is added to its error instead.

The excess of a piece of hardly any length is at most what it is longer than its chord.

This covers paths along this route. That no other route is shorter it doesn't tell.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.atlas.seams import EDGES
from bodymeasure.geodesic.across.pieces.route_refine import Refined
from bodymeasure.geodesic.lengths.length import TRUSTED_CORRECTION, TRUSTED_RESIDUAL
from bodymeasure.geodesic.lengths.measure import measure_length
from bodymeasure.geodesic.numerics.box_newton import solve_free

# See the text above.
JOINT_SAFETY = 9.0
# A piece below this part of the path's length is as good as straight.
STRAIGHT = 1e-5
# The Hessian may be singular by rounding: what is added to its diagonal then, as a part of it.
DAMPINGS = (0.0, 1e-12, 1e-10, 1e-8)
# Lengths are sums of differences of coordinates of the patches' size.
ROUNDING = 4e-16


class RouteLength(NamedTuple):
    """The length of a path, in the atlas's unit.

    Parameters
    ----------
    raw : float
        Of the path as computed.
    corrected : float
        Of the geodesic: less its excess.
    error : float
        Estimated error of that; infinite where nothing is known.
    residual : float
        Largest geodesic curvature times the piece's length, and largest difference of the unit
        tangents' parts along a seam where it is crossed: 0 for a geodesic.
    trusted : bool
        Whether the corrections are small enough to be leading order.
    minimal : bool
        Whether it is shorter than all paths close to it along its route.
    """

    raw: float
    corrected: float
    error: float
    residual: float
    trusted: bool
    minimal: bool


def route_length(refined: Refined) -> RouteLength:
    """The length of a refined path, its error, and what is known of it."""
    problem, size = refined.problem, refined.problem.size
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        measured = measure_length(problem.surface, problem.space, refined.values)
    total = refined.lengths.sum()
    short = refined.lengths < STRAIGHT * total
    ends = problem.surface.positions(refined.values[:, :, [0, -1]].transpose(0, 2, 1))
    chord = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=-1)
    correction = np.where(short, 0.0, measured.correction)
    error = np.where(short, refined.lengths - chord, measured.error)
    residual = np.where(short, 0.0, measured.residual)
    held = refined.held_nodes.any(axis=(1, 2)) & ~short
    error = error + np.where(held, np.abs(correction), 0.0)
    correction = np.where(held, 0.0, correction)
    jumps, excess = _joints(refined, short)
    known = bool(np.isfinite(error).all() and np.isfinite(excess))
    trusted = known and bool(
        (np.abs(correction) <= TRUSTED_CORRECTION * total).all()
        and (residual <= TRUSTED_RESIDUAL).all()
    )
    whole = (
        error.sum() + JOINT_SAFETY * excess + rounding_of(refined.problem.surface.control_points)
    )
    return RouteLength(
        raw=float(total * size),
        corrected=float((total - correction.sum()) * size) if known else float(total * size),
        error=float(whole * size) if known else np.inf,
        residual=float(max(residual.max(), jumps)),
        trusted=trusted,
        minimal=bool((measured.minimal | short).all() and np.isfinite(excess)),
    )


def _joints(refined: Refined, short: NDArray[np.bool_]) -> tuple[float, float]:
    """The largest difference of tangents along a seam, and the excess that it stands for."""
    problem, route = refined.problem, refined.problem.route
    slopes = problem.space.matrices([0.0, 1.0])[1]
    moved = refined.values - refined.values[:, :, :1]
    ends = refined.values[:, :, [0, -1]].transpose(0, 2, 1)
    _, s_u, s_v = problem.surface.jet(ends, 1)
    du, dv = (moved @ slopes.T).transpose(1, 0, 2)
    velocity = s_u * du + s_v * dv
    speed = np.linalg.norm(velocity, axis=0)
    tangent = velocity / np.where(speed > 0.0, speed, 1.0)
    right, largest = np.zeros(problem.count), 0.0
    for joint, crossing in enumerate(route.crossings):
        row = problem.joints[joint + 1]
        if refined.minimum.held[row] or short[joint] or short[joint + 1]:
            continue
        seam = (s_v if EDGES[crossing.from_side].fixed_axis == 0 else s_u)[:, joint, 1]
        right[row] = (tangent[:, joint, 1] - tangent[:, joint + 1, 0]) @ seam
        length = np.linalg.norm(seam)
        largest = max(largest, abs(right[row]) / length if length else 0.0)
    free = ~(refined.minimum.held | problem.idle)
    for damping in DAMPINGS:
        bands = refined.minimum.bands.copy()
        bands[0] *= 1.0 + damping
        shift = solve_free(bands, np.where(free, right, 0.0), free)
        if shift is not None:
            return largest, float(0.5 * right @ shift)
    return largest, np.inf


def rounding_of(nets: Array) -> float:
    """What rounding does to the length of a path over patches."""
    widths = np.ptp(nets, axis=(1, 2)).max(axis=1)
    # The nets' coordinates are rounded before they are subtracted.
    return float(ROUNDING * (widths.sum() + np.abs(nets).max()))
