"""The geodesic equation on one patch, followed until a side, a pole or the end."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.seams import EDGES
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.geodesic.surfaces.rational import RationalSurfaces

# A geodesic has left a patch once it is this far outside in u or v. One that runs along a seam
# strays from it by rounding alone, which is far less.
MARGIN = 1e-10
# The absolute tolerance of u, v and their derivatives is this part of the relative one.
ABSOLUTE = 0.1
# Evaluations of the equation on one patch; the usual number is some 300.
MAX_EVALUATIONS = 6_000
# The number of places in a step at which the last crossing of a side is looked for.
PLACES = 33


class State(NamedTuple):
    """A point that moves over a patch.

    Parameters
    ----------
    patch : int
    parameters : ndarray, shape (2,)
    velocity : ndarray, shape (2,)
        Derivatives of (u, v) by the arc length.
    """

    patch: int
    parameters: Array
    velocity: Array


class Run(NamedTuple):
    """The part of a geodesic on one patch.

    Parameters
    ----------
    start, end : State
    length : float
        Arc length; the scale of lengths is the patch's.
    course : callable
        Takes arc lengths (k,) and returns (u, v), shape (2, k).
    side : int or None
        The side at which it leaves the patch, in the order of `EDGES`.
    at_pole : bool
        Whether it has come as close to a pole of the patch as is followed.
    """

    start: State
    end: State
    length: float
    course: Callable[[Array], Array]
    side: int | None = None
    at_pole: bool = False


class Pole(NamedTuple):
    """A point to which sides of patches collapse, and the distance down to which it is neared."""

    position: Array
    radius: float


class LostError(Exception):
    """A geodesic cannot be followed: the surface is singular, or it takes too many steps."""


Surfaces = BezierSurfaces | RationalSurfaces


def jet_at(surface: Surfaces, parameters: Array) -> Array:
    """Return the derivatives up to the second at one point, shape (6, 3)."""
    return surface.jet(parameters[None, None], 2)[:, :, 0, 0]


def velocity_along(surface: Surfaces, parameters: Array, direction: Array) -> Array:
    """Return the derivatives of (u, v) by arc length along a direction in space, shape (2,).

    Raises
    ------
    LostError
        If the patch has no tangent plane there.
    """
    tangents = jet_at(surface, parameters)[1:3]
    metric = tangents @ tangents.T
    if not np.linalg.det(metric) > 0.0:
        raise LostError
    velocity = np.linalg.solve(metric, tangents @ direction)
    speed = float(np.linalg.norm(velocity @ tangents))
    if not speed > 0.0:
        raise LostError
    return np.asarray(velocity / speed)


def followed(surface: Surfaces, start: State, length: float, pole: Pole | None, rtol: float) -> Run:
    """Follow a geodesic over a patch, at most so far.

    Parameters
    ----------
    surface : Surfaces
        The one patch, of about size 1, which is the scale of all lengths here.
    start : State
    length : float
    pole : Pole or None
        The pole of the patch that the geodesic may come close to.
    rtol : float

    Raises
    ------
    LostError

    Notes
    -----
    With ``a = S_uu u'^2 + 2 S_uv u'v' + S_vv v'^2``, the tangential part of the acceleration is
    zero where ``g (u'', v'') = -(S_u . a, S_v . a)``; g is the metric.
    """
    # Imported here, since they take long to load and nothing else needs them.
    from scipy.integrate import solve_ivp
    from scipy.optimize import brentq

    evaluations = 0

    def motion(_: float, state: Array) -> Array:
        nonlocal evaluations
        evaluations += 1
        if evaluations > MAX_EVALUATIONS or not np.isfinite(state).all():
            raise LostError
        du, dv = state[2:]
        jet = jet_at(surface, state[:2])
        tangents = jet[1:3]
        acceleration = jet[3] * du**2 + jet[4] * (2.0 * du * dv) + jet[5] * dv**2
        second = -np.linalg.solve(tangents @ tangents.T, tangents @ acceleration)
        return np.concatenate([state[2:], second])

    def inside(_: float, state: Array) -> float:
        return float(0.5 + MARGIN - np.abs(state[:2] - 0.5).max())

    def away(_: float, state: Array) -> float:
        assert pole is not None
        there = surface.positions(state[None, None, :2])[0, 0] - pole.position
        return float(np.linalg.norm(there)) - pole.radius

    for event in (inside, away):
        event.terminal = True  # type: ignore[attr-defined]
        event.direction = -1.0  # type: ignore[attr-defined]
    try:
        with np.errstate(all="ignore"):
            found = solve_ivp(
                motion,
                (0.0, length),
                np.concatenate([start.parameters, start.velocity]),
                method="DOP853",
                rtol=rtol,
                atol=ABSOLUTE * rtol,
                dense_output=True,
                events=[inside] if pole is None else [inside, away],
            )
    except (np.linalg.LinAlgError, ValueError):
        raise LostError from None
    if found.status < 0:
        raise LostError

    def course(s: Array) -> Array:
        return np.asarray(found.sol(s)[:2])

    at, last = float(found.t[-1]), found.y[:, -1]
    if found.status == 0 or (pole is not None and len(found.t_events[1])):
        end = State(start.patch, np.clip(last[:2], 0.0, 1.0), last[2:])
        return Run(start, end, at, course, at_pole=found.status == 1)
    outside = np.array([-last[0], last[0] - 1.0, -last[1], last[1] - 1.0])
    side = int(outside.argmax())
    if pole is not None and away(at, last) < 0.0:
        # A step has led past a pole: the geodesic goes through it.
        before = float(found.t[-2])
        if away(before, found.sol(before)) > 0.0:
            at = float(brentq(lambda s: away(s, found.sol(s)), before, at, xtol=1e-15))
        else:
            at = before
        last = found.sol(at)
        return Run(start, State(start.patch, last[:2], last[2:]), at, course, at_pole=True)
    edge = EDGES[side]
    sign = 1.0 if edge.fixed_value == 0.0 else -1.0
    at = _crossed(
        lambda s: float(sign * (found.sol(s)[edge.fixed_axis] - edge.fixed_value)),
        float(found.t[-2]),
        at,
    )
    last = np.array(found.sol(at))
    last[edge.fixed_axis] = edge.fixed_value
    return Run(start, State(start.patch, np.clip(last[:2], 0.0, 1.0), last[2:]), at, course, side)


def _crossed(depth: Callable[[float], float], begin: float, end: float) -> float:
    """Return where a depth inside a side last becomes 0 between two arc lengths.

    A geodesic that is inside nowhere between them has strayed from the side by rounding, and leaves
    at the end.
    """
    from scipy.optimize import brentq

    places = np.linspace(begin, end, PLACES)
    inside = [number for number, s in enumerate(places) if depth(float(s)) > 0.0]
    if not inside:
        return end
    return float(brentq(depth, places[inside[-1]], places[inside[-1] + 1], xtol=1e-15))
