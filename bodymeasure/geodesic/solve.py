"""The one entry to geodesics on patches: it checks, scales and solves, and says how good it is."""

import math
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic.lengths.coincident import distances_in_one_place
from bodymeasure.geodesic.lengths.length import UNKNOWN
from bodymeasure.geodesic.methods.rbf_collocation import RBFCollocation
from bodymeasure.geodesic.proofs.patches import PatchesOfPaths
from bodymeasure.geodesic.shortest.search import Search, check_search, is_outside, search_further
from bodymeasure.geodesic.solution import GeodesicSolution
from bodymeasure.geodesic.solving.magnified import solve_near_and_far
from bodymeasure.geodesic.solving.protocol import Method, PathBatch
from bodymeasure.geodesic.status import OnFailure, Status, check_on_failure
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.geodesic.surfaces.control_points import prepared_control_points
from bodymeasure.geodesic.surfaces.custom import CustomSurface
from bodymeasure.geodesic.surfaces.protocol import Surface
from bodymeasure.geodesic.surfaces.rational import surfaces_of
from bodymeasure.threads import one_blas_thread
from bodymeasure.trust import is_known

# The number that the smallest lengths are rounded to.
SMALLEST = float(np.finfo(np.float64).smallest_subnormal)
# A path whose correction is beyond this part of its length is no geodesic in any sense.
MAX_CORRECTION = 0.1
# Neither is a path that turns by more than this on a distance as long as itself. On flat patches,
# whose geodesics stay inside, unresolved paths that left them turned by 43 and more.
MAX_TURN = 30.0
# How many failed problems an error message lists.
LISTED = 5
# What statuses are copied from, since it takes longer to find out that one is no array.
_CONVERGED = np.array([Status.CONVERGED], dtype=object)


class HasDerivatives(Protocol):
    """A parametric surface of the user's own."""

    def derivatives(self, parameters: Array) -> ArrayLike:
        """Return all partial derivatives up to the third order.

        Parameters
        ----------
        parameters : ndarray, shape (..., 2)

        Returns
        -------
        array_like, shape (..., 10, 3)
            S, S_u, S_v, S_uu, S_uv, S_vv, S_uuu, S_uuv, S_uvv, S_vvv.
        """


@one_blas_thread()
def solve_geodesic(
    surface: ArrayLike | HasDerivatives,
    start: ArrayLike,
    end: ArrayLike,
    *,
    method: Method | None = None,
    search: Search | None = None,
    on_failure: OnFailure = "raise",
) -> GeodesicSolution:
    """Return geodesics between pairs of points, each on one patch.

    Parameters
    ----------
    surface : array_like of shape (*batch, m + 1, n + 1, 3), or object with ``derivatives``
        Control points of Bezier patches, or one parametric surface over [0, 1] x [0, 1]. With four
        coordinates, those of rational patches (see `bodymeasure.homogeneous`). Control points may
        be an array of torch, CuPy or JAX: then most of the work is done by that library, on the
        device where they are. The solution is numpy's.
    start, end : array_like, shape (*shape, 2)
        Points (u, v) in [0, 1]; they broadcast with each other and with the patches.
    method : Method, optional
        `RBFCollocation()` by default.
    search : {"quick", "thorough", "straight"}, optional
        Whether to look for the shortest path beyond what the method finds from the straight line in
        (u, v); see `bodymeasure.geodesic.shortest.search`. Quick: where the method fails, above all
        where the geodesic leaves the patch. Thorough: always, since a shorter path may run
        elsewhere on a strongly curved patch. Straight: never. By default quick; but straight if a
        method is given, so that what is returned is what that method finds.
    on_failure : {"raise", "status"}
        What to do if there is no length that can be trusted: raise, so that no failure is
        overlooked, or say so in the status, with NaN for a length.

    Returns
    -------
    GeodesicSolution

    Raises
    ------
    InputError
        If a shape or value is wrong, or a patch is collapsed to a point.
    ConvergenceError
        If a problem failed and `on_failure` is "raise".

    Examples
    --------
    >>> import numpy as np
    >>> u, v = np.meshgrid(np.linspace(0, 3, 4), np.linspace(0, 4, 4), indexing="ij")
    >>> plane = np.stack([u, v, np.zeros_like(u)], axis=-1)
    >>> round(solve_geodesic(plane, (0.0, 0.0), (1.0, 1.0)).length, 12)
    5.0
    """
    if search is None:
        search = "quick" if method is None else "straight"
    check_search(search)
    check_on_failure(on_failure)
    method = _default_method() if method is None else method
    # A class is no method yet: it lacks its settings.
    if isinstance(method, type) or not hasattr(method, "solve"):
        raise InputError(
            f"method is {method!r}; expected a method with its settings, such as RBFCollocation()"
        )
    problems = _problems(
        surface, _checked_parameters("start", start), _checked_parameters("end", end)
    )
    solution = _solve(problems, method, search)
    # What has no length that can be trusted is not a number.
    if on_failure == "raise" and np.isnan(solution.length).any():
        raise ConvergenceError(_failures(solution))
    return solution


@cache
def _default_method() -> Method:
    return RBFCollocation()


class _Problems(NamedTuple):
    """A flattened batch of problems.

    Parameters
    ----------
    surfaces : Surface
        The surfaces, scaled to about size 1.
    surface_of : ndarray of int, shape (problems,)
        The number of each problem's surface.
    starts, ends : ndarray, shape (problems, 2)
    scale : ndarray, shape (problems,)
        The factors that take lengths on the surfaces to the user's unit.
    shape : tuple of int
        The shape of the batch as the user gave it.
    """

    surfaces: Surface
    surface_of: Ints
    starts: Array
    ends: Array
    scale: Array
    shape: tuple[int, ...]


def _problems(surface: ArrayLike | HasDerivatives, start: Array, end: Array) -> _Problems:
    surfaces: Surface
    if hasattr(surface, "derivatives"):
        shape = _broadcast(start.shape[:-1], end.shape[:-1])
        count = math.prod(shape)
        surfaces, size = CustomSurface(surface.derivatives).of_size_one()
        surface_of, scale = np.zeros(count, np.int64), np.full(count, size)
    else:
        nets, scale, batch = prepared_control_points(surface)
        shape = _broadcast(batch, start.shape[:-1], end.shape[:-1])
        surfaces, surface_of = surfaces_of(nets), np.arange(len(scale))
        # Each patch is prepared once, however many problems it has.
        if batch != shape:
            surface_of = np.broadcast_to(surface_of.reshape(batch), shape).ravel()
            scale = scale[surface_of]
    starts, ends = np.empty((2, *shape, 2))
    starts[...], ends[...] = start, end
    starts, ends = starts.reshape(-1, 2), ends.reshape(-1, 2)
    return _Problems(surfaces, surface_of, starts, ends, scale, shape)


@dataclass(frozen=True)
class _Outcome:
    """The facts known of each problem, by the names of `GeodesicSolution`; shape (problems,)."""

    length: Array
    raw_length: Array
    error_estimate: Array
    residual: Array
    status: NDArray[np.object_]
    index: Ints
    functions: Ints
    iterations: Ints

    @classmethod
    def of_coincident_points(cls, error: Array) -> "_Outcome":
        """Return paths of length zero from points to themselves, which nothing can shorten."""
        count = len(error)
        zeros, none = np.zeros((3, count)), np.zeros((3, count), np.int64)
        return cls(zeros[0], zeros[1], error, zeros[2], _CONVERGED.repeat(count), *none)

    def put(self, batch: PathBatch, scale: Array) -> Bools:
        """Put in what a method found for some of the problems, and return which have a length."""
        here, length = batch.problems, batch.length
        scale = scale[here]
        self.raw_length[here] = length.raw * scale
        self.length[here] = length.corrected * scale
        # The smallest numbers have few digits.
        self.error_estimate[here] = (length.error + SMALLEST) * scale + SMALLEST
        self.residual[here] = length.residual
        self.index[here] = np.where(batch.converged, length.index, UNKNOWN)
        self.functions[here] = batch.space.size
        if batch.contacts:
            self.status[here] = Status.ON_BOUNDARY
        outside = is_outside(batch)
        good = batch.converged & length.minimal & ~(outside | batch.singular)
        if not good.all():
            outside &= ~_is_far_from_geodesic(batch)
            self.status[here[~length.minimal]] = Status.NOT_A_MINIMUM
            self.status[here[outside]] = Status.LEAVES_PATCH
            self.status[here[~batch.converged & ~outside]] = Status.NOT_CONVERGED
            self.status[here[batch.singular]] = Status.SINGULAR
        return good


def _is_far_from_geodesic(batch: PathBatch) -> Bools:
    """Which paths are so far from a geodesic that they do not say where the geodesic would run."""
    length = batch.length
    near = np.abs(length.correction) < MAX_CORRECTION * length.raw
    return ~batch.converged & ~(near & (length.residual <= MAX_TURN))


def _solve(problems: _Problems, method: Method, search: Search) -> GeodesicSolution:
    surfaces, surface_of, starts, ends, scale, shape = problems
    # Between points in one place the length is zero, and nothing needs solving.
    distance = distances_in_one_place(surfaces, surface_of, starts, ends) * scale
    outcome = _Outcome.of_coincident_points(distance)
    apart = np.flatnonzero(np.isinf(distance))
    here = slice(None) if len(apart) == len(starts) else apart
    # A million patches with a problem each are not copied once more.
    each_once = np.array_equal(surface_of[here], np.arange(len(starts)))
    part = surfaces if each_once else surfaces.take(surface_of[here])
    result = solve_near_and_far(method, part, starts[here], ends[here])
    result = search_further(part, (starts[here], ends[here]), result, search, method.tolerance)
    outcome.iterations[here] = result.iterations
    batches = result.batches
    if len(apart) < len(starts):
        batches = tuple(batch.renumbered(apart[batch.problems]) for batch in batches)
    has_length = np.ones(len(starts), bool)
    for batch in batches:
        has_length[batch.problems] = outcome.put(batch, scale)
    known = is_known(outcome.length, outcome.error_estimate, scale)
    # What has no length that can be trusted is not a number.
    if not (has_length & known).all():
        outcome.status[has_length & ~known] = Status.INACCURATE
        outcome.length[~(has_length & known)] = np.nan
    return GeodesicSolution(
        start=starts.reshape(*shape, 2),
        end=ends.reshape(*shape, 2),
        **{
            name: array.reshape(shape) if shape else array.tolist()[0]
            for name, array in vars(outcome).items()
        },
        batches=batches,
        patches=_patches(problems),
    )


def _patches(problems: _Problems) -> PatchesOfPaths | None:
    surfaces = problems.surfaces
    # Rational patches have no polynomial curvature bound.
    if not isinstance(surfaces, BezierSurfaces) or surfaces.coordinates != 3:
        return None
    return PatchesOfPaths(surfaces.control_points, problems.surface_of, problems.scale)


def _checked_parameters(name: str, value: ArrayLike) -> Array:
    try:
        # A torch tensor may record what is done with it; only its numbers are wanted.
        array = np.asarray(value.detach() if hasattr(value, "detach") else value, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"{name} is {value!r}; expected numbers (..., 2): u and v") from None
    if array.ndim == 0 or array.shape[-1] != 2:
        raise InputError(f"{name} has shape {array.shape}; expected (..., 2): u and v")
    inside = (array >= 0.0) & (array <= 1.0)
    # `not inside` rather than `outside`, so that NaN is refused too.
    if not inside.all():
        bad = array[~inside.all(axis=-1)][0].tolist()
        raise InputError(f"{name} holds {bad}; expected u and v in [0, 1]")
    return array


def _broadcast(*shapes: tuple[int, ...]) -> tuple[int, ...]:
    if len(set(shapes)) == 1:
        return shapes[0]
    try:
        return np.broadcast_shapes(*shapes)
    except ValueError:
        raise InputError(
            f"the batch shapes {', '.join(map(str, shapes))} of surface, start and end do not "
            "broadcast with one another; expected equal ones, or 1 where they differ"
        ) from None


def _failures(solution: GeodesicSolution) -> str:
    failed = np.flatnonzero(~np.atleast_1d(solution.converged).ravel())
    statuses = np.atleast_1d(np.asarray(solution.status, dtype=object)).ravel()
    count = len(statuses)
    if count == 1:
        return str(statuses[0].sentence)
    listed = "; ".join(f"problem {i}: {statuses[i].sentence}" for i in failed[:LISTED])
    more = f"; and {len(failed) - LISTED} more" if len(failed) > LISTED else ""
    return (
        f"{len(failed)} of {count} geodesics have no length that can be trusted: {listed}{more} "
        '(on_failure="status" gives the others)'
    )
