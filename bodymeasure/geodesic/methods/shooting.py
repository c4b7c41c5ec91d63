"""Shooting: geodesics from their start and direction, aimed at the end by Newton's method."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.lengths.equations import acceleration, linearization
from bodymeasure.geodesic.methods.settings import check_between, check_positive
from bodymeasure.geodesic.solving.on_spaces import TOLERANCE
from bodymeasure.geodesic.solving.protocol import MethodResult
from bodymeasure.geodesic.solving.resampled import Path, resampled
from bodymeasure.geodesic.surfaces.protocol import Surface

# The error of a length is about the square of that of its path, so that half the digits are enough.
RTOL = 1e-8
# scipy does not go below this.
LEAST_RTOL = 1e-13
# The first shots need not be more exact than they hit.
FIRST_RTOL = 1e-4
# The absolute tolerance, of u and v, is this part of the relative one.
ABSOLUTE = 0.1
# A hit is as exact as the integration, which adds up some ten steps' errors.
HIT = 10.0
MAX_SHOTS = 30
# A correction of the aim this many times halved leads nowhere.
SMALLEST_STEP = 2.0**-8
# Where a geodesic gets so far outside [0, 1] in u or v, it is followed no further.
FARTHEST_OUTSIDE = 1.0
# All shots of a problem may take this many evaluations, ten times the usual.
MAX_EVALUATIONS = 5_000


@dataclass(frozen=True)
class Shooting:
    """Initial value problems with Newton's method on direction and length.

    From start, with a velocity (u', v') at t = 0, the geodesic equations are integrated to t = 1
    by scipy's DOP853, together with the Jacobi equation: how the path moves if the velocity
    changes. That gives Newton's method exact derivatives of where the path arrives (H. B. Keller,
    *Numerical Methods for Two-Point Boundary-Value Problems*, chapter 2).
    The first velocity is that of the straight line in (u, v). The path is then put on polynomials,
    and its length is measured as with the other methods; their degree is the solution's
    `functions`.

    There is no trial space to be chosen and none that could be too small; but every problem is
    integrated by itself, a thousand times slower than collocation. Where geodesics spread
    quickly (negative curvature), or near a conjugate point, Newton's method may not find the
    direction, though a first shot that goes too far is made shorter: ``NOT_CONVERGED``.

    Parameters
    ----------
    rtol : float
        The relative tolerance of a step of the integration, from 1e-13 to 1.
    tolerance : float
        The relative error of the length that is asked for.

    Raises
    ------
    InputError
        If a setting makes no sense.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> net = bm.load_sample("paraboloid").control_points[0]
    >>> method = bm.geodesic.Shooting(rtol=1e-8)
    >>> round(bm.solve_geodesic(net, (0, 0), (1, 1), method=method).length, 8)
    2.56200714
    """

    rtol: float = RTOL
    tolerance: float = TOLERANCE

    def __post_init__(self) -> None:
        check_between("rtol", self.rtol, LEAST_RTOL, 1.0)
        check_positive("tolerance", self.tolerance)

    def solve(self, surface: Surface, start: Array, end: Array) -> MethodResult:
        """Return paths from start to end, both of shape (problems, 2), on a batch of surfaces."""
        paths: list[Path | None] = []
        shots = np.zeros(len(start), np.int64)
        for problem in range(len(start)):
            one = surface.take(np.array([problem]))
            path, shots[problem] = _aimed(one, start[problem], end[problem], self.rtol)
            paths.append(path)
        pieces = resampled(surface, paths, (start, end), tolerance=self.tolerance)
        return MethodResult(pieces, shots)


@dataclass(frozen=True)
class _Shot:
    """Where a geodesic arrives at t = 1, how that changes with its first velocity, and its path."""

    target: Array
    by_velocity: Array
    path: Path


class _TooLongError(Exception):
    """A geodesic that takes too long."""


class _Motion:
    """The geodesic and Jacobi equations of one problem, as `scipy.integrate.solve_ivp` wants them.

    A state is 2 numbers each of place and velocity, and 4 each of their changes by the first
    velocity. The geodesic equations are linear in (u'', v''), and so are those of the changes: the
    same matrix, the metric, stands before the unknowns.
    """

    def __init__(self, surface: Surface) -> None:
        self.surface = surface
        self.evaluations = 0

    def __call__(self, _: float, state: Array) -> Array:
        """Return the derivative of a state by t."""
        self.evaluations += 1
        if self.evaluations > MAX_EVALUATIONS or not np.isfinite(state).all():
            raise _TooLongError
        place, velocity = state[:2], state[2:4]
        change, change_velocity = state[4:].reshape(2, 2, 2)
        jet = self.surface.jet(place[None, None], 3)[:, :, 0, 0]
        tangents = jet[1:3]
        inverse = np.linalg.inv(tangents @ tangents.T)
        second = -inverse @ (tangents @ acceleration(jet, velocity, np.zeros(2)))
        here = linearization(jet, velocity, second)
        load = np.array(here.by_value) @ change + np.array(here.by_velocity) @ change_velocity
        return np.concatenate(
            [velocity, second, change_velocity.ravel(), -(inverse @ load).ravel()]
        )


def _aimed(surface: Surface, start: Array, end: Array, rtol: float) -> tuple[Path | None, int]:
    """The path to the end, if it is hit, and the number of shots."""
    motion, velocity, path, shots = _Motion(surface), end - start, None, 0
    for precision in (max(rtol, FIRST_RTOL), rtol):
        velocity, path, used = _newton(motion, (start, end), velocity, precision)
        shots += used
        if path is None:
            break
    return path, shots


def _newton(
    motion: _Motion, ends: tuple[Array, Array], velocity: Array, rtol: float
) -> tuple[Array, Path | None, int]:
    """Newton's method on the first velocity, damped; the number of shots comes last."""
    start, end = ends
    close = HIT * rtol * float(np.abs(end - start).max())
    direction: Array = np.zeros(2)
    step, least_miss = 1.0, np.inf
    for count in range(1, MAX_SHOTS + 1):
        trial = velocity + step * direction
        shot = _shoot(motion, start, trial, rtol)
        miss = np.inf if shot is None else float(np.linalg.norm(shot.target - end))
        if shot is None or miss >= least_miss:
            step *= 0.5
            if least_miss == np.inf:
                # Not even the first shot has arrived: try one that does not go so far.
                velocity = 0.5 * velocity
            if step < SMALLEST_STEP or motion.evaluations > MAX_EVALUATIONS:
                return velocity, None, count
            continue
        velocity, least_miss = trial, miss
        if miss <= close:
            return velocity, shot.path, count
        try:
            direction = np.linalg.solve(shot.by_velocity, end - shot.target).astype(np.float64)
        except np.linalg.LinAlgError:
            # The end is conjugate to the start.
            return velocity, None, count
        step = 1.0
    return velocity, None, MAX_SHOTS


def _shoot(motion: _Motion, start: Array, velocity: Array, rtol: float) -> _Shot | None:
    """Integrate from t = 0 to 1; None if the path goes too far outside or takes too long."""
    # Imported here, since it takes some 30 ms to load and no other method needs it.
    from scipy.integrate import solve_ivp

    def is_outside(_: float, state: Array) -> float:
        return float(0.5 + FARTHEST_OUTSIDE - np.abs(state[:2] - 0.5).max())

    is_outside.terminal = True  # type: ignore[attr-defined]
    # (u, v), its velocity, and both changed by the first velocity's u' and by its v'.
    first = np.concatenate([start, velocity, np.zeros(4), np.eye(2).ravel()])
    try:
        with np.errstate(all="ignore"):
            result = solve_ivp(
                motion,
                (0.0, 1.0),
                first,
                method="DOP853",
                rtol=rtol,
                atol=ABSOLUTE * rtol,
                dense_output=True,
                events=is_outside,
            )
    except (_TooLongError, np.linalg.LinAlgError):
        return None
    if result.status != 0:
        return None
    last = result.y[:, -1]
    return _Shot(last[:2], last[4:8].reshape(2, 2), lambda t: result.sol(t)[:2])
