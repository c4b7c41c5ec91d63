"""The geodesic from a point of an atlas in a direction."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.queries.locations import Location
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic.across.pieces.part import PathPiece
from bodymeasure.geodesic.across.pieces.path import AtlasPath, SeamCrossing
from bodymeasure.geodesic.across.search.ends import checked_points
from bodymeasure.geodesic.lengths.path_geometry import path_geometry
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.status import OnFailure, Status, check_on_failure, checked_status
from bodymeasure.geodesic.tracing.motion import Run, State
from bodymeasure.geodesic.tracing.patches import NEAR_POLE, Patches
from bodymeasure.geodesic.tracing.trace import Trace, apart, runs_of, traced
from bodymeasure.threads import one_blas_thread

# The relative tolerances of a step. The second, coarser trace tells what the first is worth: that
# its error is smaller than their difference is certain enough.
TOLERANCES = (1e-13, 1e-11)
# Sums of some hundred numbers of the size of the length are good to this part of it.
ROUNDING = 2e-14
# What each pole adds, as a part of the length.
AT_POLE = 2e-10
# An end that is known no better than to this part of the length is not called converged.
LARGEST_ERROR = 1e-6
# A direction whose part in the tangent plane is a smaller part of it is across the surface.
LEAST_TANGENT = 1e-6
# The degrees of the polynomials that hold the path on a patch, and how well they do, in (u, v). A
# part that takes more is halved, at most so often.
DEGREES = (8, 16, 28)
WELL = 1e-12
HALVINGS = 16


@dataclass(frozen=True, eq=False, repr=False)
class DirectedPath(AtlasPath):
    """A geodesic that starts in a direction: an `AtlasPath` with the direction at its end.

    It is as straight as the surface allows, but need not be the shortest way to its end. Its
    `length` is that of the path. Its `error_estimate` is how far the end may lie from where the
    exact geodesic of that length ends, which is known by following it with two tolerances.

    Parameters
    ----------
    end_direction : ndarray, shape (3,)
        The unit tangent at the end; followed the other way, it leads back to the start.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> path = bm.geodesic_from(body, "back neck point", (0.0, 0.0, -1.0), 0.2)
    >>> path  # doctest: +ELLIPSIS
    <DirectedPath of length 0.2 m, error ...e-1... m, CONVERGED>
    >>> back = bm.geodesic_from(body, path.end, -path.end_direction, path.length)
    >>> gap = body.position(back.end) - body.position(body.landmarks["back neck point"])
    >>> bool(abs(gap).max() < 1e-9)
    True
    """

    end_direction: Array

    @property
    def end(self) -> AtlasPoint:
        """The point at which the path ends."""
        return self.points[-1]


@one_blas_thread()
def geodesic_from(
    atlas: Atlas,
    start: Location,
    direction: ArrayLike,
    length: float,
    *,
    on_failure: OnFailure = "raise",
) -> DirectedPath:
    """Return the geodesic from a point in a direction, over as many seams as it crosses.

    Parameters
    ----------
    atlas : Atlas
    start : str, AtlasPoint or position of shape (3,)
        A landmark's name, a point of the atlas, or a position in the atlas's unit, for which the
        closest point of the surface is taken.
    direction : array_like, shape (3,)
        A vector in space of any length; its part in the tangent plane counts.
    length : float
        The length of the path, in the atlas's unit.
    on_failure : {"raise", "status"}
        What to do if the path cannot be followed: raise, or say so in the status, with NaN for a
        length.

    Returns
    -------
    DirectedPath
        One that reaches a boundary of the surface ends there, with the status
        ``ENDS_AT_BOUNDARY`` and the length up to it.

    Raises
    ------
    InputError
        If the start is not on the atlas, the direction is no vector or is across the surface, or
        the length is not a positive number.
    ConvergenceError
        If the path cannot be followed and `on_failure` is "raise".

    Notes
    -----
    The geodesic equations are integrated patch by patch by the method of Dormand and Prince of
    order 8 (E. Hairer, S. Norsett and G. Wanner, *Solving Ordinary Differential Equations I*). A
    seam is crossed at the same angle on both sides, and a pole along its tangent plane.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> path = bm.geodesic_from(body, "back neck point", (0.0, 0.0, -1.0), 0.2)
    >>> path.end  # doctest: +ELLIPSIS
    AtlasPoint(patch=..., u=..., v=...)
    >>> print(path.status.name, len(path.crossings) > 0)
    CONVERGED True
    """
    check_on_failure(on_failure)
    ((point,), (move,)) = checked_points(atlas, (start,), ("the start",))
    vector, asked = _checked_direction(direction), _checked_length(length)
    patches = Patches(atlas)
    _require_tangent(patches, point, vector)
    fine, coarse = (traced(patches, point, vector, asked, rtol) for rtol in TOLERANCES)
    error = (
        apart(atlas, fine, coarse)
        + abs(fine.length - coarse.length)
        + (ROUNDING + AT_POLE * fine.poles + _beside_a_pole(patches, point)) * asked
        + move
    )
    path = _path(patches, point, fine, error)
    if on_failure == "raise" and not path.converged:
        raise ConvergenceError(path.status.sentence)
    return path


def _beside_a_pole(patches: Patches, point: AtlasPoint) -> float:
    """Return how well rounding lets directions be known at a point beside a pole, in radians."""
    near = patches.pole_beside(State(point.patch, np.array([point.u, point.v]), np.zeros(2)))
    if near is None or near.distance < NEAR_POLE:
        return 0.0
    return float(np.finfo(np.float64).eps / near.distance)


def _checked_direction(direction: ArrayLike) -> Array:
    try:
        vector = np.asarray(direction, dtype=np.float64)
    except (TypeError, ValueError):
        vector = np.empty(0)
    if vector.shape != (3,) or not np.isfinite(vector).all() or not vector.any():
        raise InputError(
            f"the direction is {direction!r}; expected a vector (x, y, z) that is not zero"
        )
    return np.asarray(vector / np.abs(vector).max())


def _checked_length(length: float) -> float:
    try:
        number = float(length)
    except (TypeError, ValueError):
        number = np.nan
    if not 0.0 < number < np.inf:
        raise InputError(f"the length is {length!r}; expected a positive number")
    return number


def _require_tangent(patches: Patches, point: AtlasPoint, direction: Array) -> None:
    """Refuse a direction that is all but normal to the surface."""
    jet = patches.surface(point.patch).jet(np.array([[[point.u, point.v]]]), 1)[1:, :, 0, 0]
    tangents = jet[np.linalg.norm(jet, axis=1) > 0.0]
    if len(tangents) < 2:
        return
    basis, _ = np.linalg.qr(tangents.T)
    if np.linalg.norm(direction @ basis) < LEAST_TANGENT * np.linalg.norm(direction):
        raise InputError(
            f"the direction {direction.tolist()} is normal to the surface at the start; expected "
            "one along it"
        )


def _path(patches: Patches, start: AtlasPoint, trace: Trace, error: float) -> DirectedPath:
    """Return what was followed as a path over the atlas."""
    pieces: list[PathPiece] = []
    crossings: list[SeamCrossing] = []
    before, whole = 0.0, trace.length or 1.0
    for run, length in runs_of(trace, patches):
        if pieces and pieces[-1].patch != run.start.patch:
            entered = AtlasPoint(run.start.patch, *run.start.parameters.tolist())
            crossings.append(SeamCrossing(pieces[-1].end(-1), entered, before / whole))
        pieces += _pieces(run, length, (0.0, 1.0), HALVINGS)
        before += length
    known = not trace.lost and error <= LARGEST_ERROR * max(trace.length, 1e-300)
    status = Status.NOT_CONVERGED
    if known or (trace.at_boundary and not trace.lost):
        size = float(np.ptp(patches.atlas.points, axis=0).max())
        status = Status.ENDS_AT_BOUNDARY if trace.at_boundary else Status.CONVERGED
        status = checked_status(status, trace.length, error, size)
    return DirectedPath(
        atlas=patches.atlas,
        points=(start, trace.end),
        length=trace.length if status.has_length else np.nan,
        raw_length=trace.length,
        error_estimate=np.inf if trace.lost else error,
        residual=_residual(patches, pieces, trace.length),
        status=status,
        pieces=tuple(pieces),
        crossings=tuple(crossings),
        leg_ends=(0.0, 1.0) if pieces else (),
        end_direction=trace.direction,
    )


def _residual(patches: Patches, pieces: list[PathPiece], length: float) -> float:
    """Return the largest geodesic curvature of the pieces, times the length."""
    largest = 0.0
    for piece in pieces:
        size = float(patches.sizes[piece.patch])
        values, velocity, second = (piece.values @ m.T for m in piece.space.at_quadrature)
        geometry = path_geometry(
            patches.surface(piece.patch), values[None], velocity[None], second[None]
        )
        bend = np.abs(geometry.geodesic_curvature).max() / size * length
        # Beside a pole (u, v) are of no use, and neither is a curvature that is made of them.
        largest = max(largest, float(bend)) if piece.length > 2.0 * NEAR_POLE * size else largest
    return largest


def _pieces(run: Run, length: float, part: tuple[float, float], halvings: int) -> list[PathPiece]:
    """Return polynomials through a part of a run."""
    low, high = part
    piece = None
    for degree in DEGREES:
        space = polynomial_space(degree)
        values = run.course(run.length * (low + (high - low) * space.nodes))
        piece = PathPiece(run.start.patch, space, values, length * (high - low))
        between = run.course(run.length * (low + (high - low) * space.times_between))
        if np.abs(values @ space.between_nodes.T - between).max() <= WELL:
            return [_ended(piece, run, part)]
    if halvings == 0:
        assert piece is not None
        return [_ended(piece, run, part)]
    middle = 0.5 * (low + high)
    halves = ((low, middle), (middle, high))
    return [one for half in halves for one in _pieces(run, length, half, halvings - 1)]


def _ended(piece: PathPiece, run: Run, part: tuple[float, float]) -> PathPiece:
    """Return a piece whose ends are exactly those of its run."""
    values = np.clip(piece.values, 0.0, 1.0)
    if part[0] == 0.0:
        values[:, 0] = run.start.parameters
    if part[1] == 1.0:
        values[:, -1] = run.end.parameters
    return PathPiece(piece.patch, piece.space, values, piece.length)
