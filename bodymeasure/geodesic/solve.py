"""The one entry to geodesics: checks, scales, solves, judges."""

from typing import Literal, NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bodymeasure._typing import Array
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic.lengths.coincident import distances_in_one_place
from bodymeasure.geodesic.lengths.length import UNKNOWN
from bodymeasure.geodesic.methods.rbf_collocation import RBFCollocation
from bodymeasure.geodesic.shortest.search import SEARCHES, Search, is_outside, search_further
from bodymeasure.geodesic.solution import GeodesicSolution
from bodymeasure.geodesic.solving.magnified import solve_near_and_far
from bodymeasure.geodesic.solving.protocol import Method, MethodResult
from bodymeasure.geodesic.status import Status, have_length
from bodymeasure.geodesic.surfaces.bezier import Surface
from bodymeasure.geodesic.surfaces.control_points import checked_control_points, of_size_one
from bodymeasure.geodesic.surfaces.custom import CustomSurface
from bodymeasure.geodesic.surfaces.surfaces_of import surfaces_of

# What the smallest lengths are rounded to.
SMALLEST = float(np.finfo(np.float64).smallest_subnormal)
# A path with a correction beyond this part of its length is no geodesic in any sense.
STRAY = 0.1
# Nor is one that turns by more than this on a way as long as itself. Of flat patches, whose
# geodesics stay inside, unresolved paths that left them turned by 43 and more.
WANDERING = 30.0
# How many failed problems an error message lists.
LISTED = 5


class HasDerivatives(Protocol):
    """A parametric surface of the user's own."""

    def derivatives(self, parameters: Array) -> ArrayLike:
        """All partial derivatives up to the third order.

        Parameters
        ----------
        parameters : ndarray, shape (..., 2)

        Returns
        -------
        array_like, shape (..., 10, 3)
            S, S_u, S_v, S_uu, S_uv, S_vv, S_uuu, S_uuv, S_uvv, S_vvv.
        """


def solve_geodesic(
    surface: ArrayLike | HasDerivatives,
    start: ArrayLike,
    end: ArrayLike,
    *,
    method: Method | None = None,
    search: Search | None = None,
    on_failure: Literal["raise", "status"] = "raise",
) -> GeodesicSolution:
    """Geodesics between pairs of points, each on one patch.

    Parameters
    ----------
    surface : array_like of shape (*batch, m + 1, n + 1, 3), or object with ``derivatives``
        Control points of Bezier patches, or one parametric surface over [0, 1] x [0, 1]. With four
        coordinates, those of rational patches (see `bodymeasure.homogeneous`). Control points may
        be an array of torch, CuPy or JAX: then most of the work is done by that library, on the
        device where they are. The solution is numpy's.
    start, end : array_like, shape (*batch, 2)
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
        What to do if a problem has no length that can be trusted: raise, or say so in its status,
        with NaN for a length.

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
    _check_words(search, on_failure)
    method = RBFCollocation() if method is None else method
    # A class is none: it lacks its settings.
    if isinstance(method, type) or not hasattr(method, "solve"):
        raise InputError(
            f"method is {method!r}; expected a method with its settings, such as RBFCollocation()"
        )
    start, end = _checked_parameters("start", start), _checked_parameters("end", end)
    if hasattr(surface, "derivatives"):
        batch = _broadcast(start.shape[:-1], end.shape[:-1])
        count = int(np.prod(batch))
        surfaces: Surface
        surfaces, size = CustomSurface(surface.derivatives).of_size_one()
        patch_of, scale = np.zeros(count, np.int64), np.full(count, size)
    else:
        nets = checked_control_points(surface)
        batch = _broadcast(nets.shape[:-3], start.shape[:-1], end.shape[:-1])
        # Each patch is prepared once, however many problems it has.
        patches = np.arange(int(np.prod(nets.shape[:-3]))).reshape(nets.shape[:-3])
        patch_of = np.broadcast_to(patches, batch).ravel()
        nets, sizes = of_size_one(nets.reshape((-1, *nets.shape[-3:])))
        surfaces, scale = surfaces_of(nets), sizes[patch_of]
        count = len(patch_of)
    starts = np.broadcast_to(start, (*batch, 2)).reshape(-1, 2).copy()
    ends = np.broadcast_to(end, (*batch, 2)).reshape(-1, 2).copy()
    problems = _Problems(surfaces, patch_of, starts, ends, scale, batch)
    solution = _solve(problems, method, search)
    if on_failure == "raise" and not np.all(solution.converged):
        raise ConvergenceError(_failures(solution, count))
    return solution


class _Problems(NamedTuple):
    """A flattened batch: of each problem its surface, by number, and its ends.

    `scale` takes lengths on the surfaces to the user's.
    """

    surfaces: Surface
    surface_of: NDArray[np.int64]
    starts: Array
    ends: Array
    scale: Array
    batch: tuple[int, ...]


def _solve(problems: _Problems, method: Method, search: Search) -> GeodesicSolution:
    surfaces, surface_of, starts, ends, scale, batch = problems
    count = len(starts)
    raw, length, residual = np.zeros(count), np.zeros(count), np.zeros(count)
    status = np.full(count, Status.CONVERGED, dtype=object)
    # Of geodesics from a point to itself, which nothing can shorten.
    index = np.zeros(count, np.int64)
    functions, iterations = np.zeros(count, np.int64), np.zeros(count, np.int64)
    # Between points in one place the length is zero, and nothing needs solving.
    error = distances_in_one_place(surfaces, surface_of, starts, ends) * scale
    apart = np.flatnonzero(~np.isfinite(error))
    # A million patches with a problem each are not copied once more.
    each_once = np.array_equal(surface_of[apart], np.arange(count))
    part = surfaces if each_once else surfaces.take(surface_of[apart])
    result = solve_near_and_far(method, part, starts[apart], ends[apart])
    result = search_further(part, (starts[apart], ends[apart]), result, search, method.tolerance)
    result = _renumbered(result, apart)
    iterations[apart] = result.iterations
    for piece in result.pieces:
        here, measured = piece.problems, piece.measured
        raw[here] = measured.raw * scale[here]
        length[here] = measured.corrected * scale[here]
        # The smallest numbers have few digits.
        error[here] = (measured.error + SMALLEST) * scale[here] + SMALLEST
        residual[here] = measured.residual
        index[here] = np.where(piece.converged, measured.index, UNKNOWN)
        functions[here] = piece.space.size
        # A path that is far from a geodesic says nothing of where the geodesic would run.
        near = np.abs(measured.correction) < STRAY * measured.raw
        stray = ~piece.converged & ~(near & (measured.residual <= WANDERING))
        outside = is_outside(piece) & ~stray
        if piece.contacts:
            status[here] = Status.ON_BOUNDARY
        status[here[~measured.minimal]] = Status.NOT_A_MINIMUM
        status[here[outside]] = Status.LEAVES_PATCH
        status[here[~piece.converged & ~outside]] = Status.NOT_CONVERGED
        status[here[piece.singular]] = Status.SINGULAR
    length[~have_length(status)] = np.nan
    arrays = {
        "length": length,
        "raw_length": raw,
        "error_estimate": error,
        "residual": residual,
        "status": status,
        "index": index,
        "functions": functions,
        "iterations": iterations,
    }
    return GeodesicSolution(
        start=starts.reshape(*batch, 2),
        end=ends.reshape(*batch, 2),
        **{
            key: array.reshape(batch) if batch else array.tolist()[0]
            for key, array in arrays.items()
        },
        pieces=result.pieces,
    )


def _renumbered(result: MethodResult, numbers: NDArray[np.int64]) -> MethodResult:
    pieces = tuple(piece.renumbered(numbers[piece.problems]) for piece in result.pieces)
    return MethodResult(pieces, result.iterations)


def _check_words(search: str, on_failure: str) -> None:
    # As text, since arrays compare with nothing as a whole.
    if str(on_failure) not in ("raise", "status"):
        raise InputError(f"on_failure is {on_failure!r}; expected 'raise' or 'status'")
    if str(search) not in SEARCHES:
        raise InputError(f"search is {search!r}; expected one of {', '.join(SEARCHES)}")


def _checked_parameters(name: str, value: ArrayLike) -> Array:
    try:
        # Of a torch tensor that records what is done with it, only the numbers are wanted.
        array = np.asarray(value.detach() if hasattr(value, "detach") else value, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"{name} is {value!r}; expected numbers (..., 2): u and v") from None
    if array.ndim == 0 or array.shape[-1] != 2:
        raise InputError(f"{name} has shape {array.shape}; expected (..., 2): u and v")
    # `not inside` rather than `outside`, so that NaN is refused too.
    bad = ~((array >= 0.0) & (array <= 1.0)).all(axis=-1)
    if bad.any():
        raise InputError(f"{name} holds {array[bad][0].tolist()}; expected u and v in [0, 1]")
    return array


def _broadcast(*shapes: tuple[int, ...]) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(*shapes)
    except ValueError:
        raise InputError(
            f"batch shapes {', '.join(map(str, shapes))} of surface, start and end do not "
            "broadcast with one another"
        ) from None


def _failures(solution: GeodesicSolution, count: int) -> str:
    failed = np.flatnonzero(~np.atleast_1d(solution.converged).ravel())
    statuses = np.atleast_1d(np.asarray(solution.status, dtype=object)).ravel()
    if count == 1:
        return str(statuses[0].sentence)
    listed = "; ".join(f"problem {i}: {statuses[i].sentence}" for i in failed[:LISTED])
    more = f"; and {len(failed) - LISTED} more" if len(failed) > LISTED else ""
    return (
        f"{len(failed)} of {count} geodesics have no length that can be trusted: {listed}{more} "
        '(on_failure="status" gives the others)'
    )
