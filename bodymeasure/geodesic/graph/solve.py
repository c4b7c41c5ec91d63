"""Many geodesics by collocation with one unknown function each, where that serves.

Nothing is iterated until it converges: each trial space gets one or two Newton steps from the
previous path. The lengths are measured like all others, and only paths whose lengths are known well
enough are kept. All others are left to the form with two unknown functions.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.graph.equation import linearize, offset_geometry
from bodymeasure.geodesic.graph.maps import FIELDS, offset_map
from bodymeasure.geodesic.graph.problems import OffsetProblems
from bodymeasure.geodesic.lengths.jacobi import length_and_error
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.lengths.measure import is_steep
from bodymeasure.geodesic.numerics.array_libraries import constant, is_on_cpu, to_numpy
from bodymeasure.geodesic.numerics.elimination import solve_batch
from bodymeasure.geodesic.solving.on_spaces import is_far_outside
from bodymeasure.geodesic.solving.protocol import MethodResult, PathBatch
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces

# The first guess is made by Newton steps from the straight line on polynomials of this degree.
GUESS_DEGREE = 5
GUESS_STEPS = 2
# The number of Newton steps on the first of several trial spaces, which serves most problems, and
# the largest last step: a second step would change the paths of bodies by less than their error for
# want of functions, and the error left by a step is about its square, which the correction removes.
FIRST = (1, 1e-2)
# The same on the spaces after it, or on a single one.
LATER = (2, 1e-4)
# No step moves a node further: Newton's method from a straight line may go far astray.
LONGEST_STEP = 0.15
# The number of problems in one array operation: enough to hide the cost of calls, and few enough
# for the cache.
CHUNK = 1024
# The number of problems whose failures are gathered for the next trial space, and that are solved
# at once elsewhere than on the CPU. This bounds the memory.
BLOCK = 16384
# An offset beyond this, where the patch ends at 1, comes from a system that was nearly singular.
MAX_OFFSET = 1.0


def solve_offsets(
    spaces: Sequence[Callable[[], TrialSpace]],
    surface: BezierSurfaces,
    ends: tuple[Array, Array],
    tolerance: float,
) -> MethodResult:
    """Return those geodesics of a batch that run along their straight line as a graph over it.

    Parameters
    ----------
    spaces : sequence of callable
        Functions that make the trial spaces, which are tried in turn.
    surface : BezierSurfaces
        Patches of size 1. Their control points may be of any array library and on any device.
    ends : tuple of ndarray
        Start and end, both of shape (problems, 2).
    tolerance : float
        The relative error of the length that is asked for.

    Returns
    -------
    MethodResult
        Its batches hold only the problems that were solved.
    """
    start, end = ends
    iterations = np.zeros(len(start), np.int64)
    batches: dict[TrialSpace, list[PathBatch]] = {}
    # The straight line between points on one line of u or v has no width to be a graph in.
    across = np.flatnonzero((start != end).all(axis=1))
    # A system without a solution ends in numbers that are not finite, and its problem is left over.
    with np.errstate(all="ignore"):
        for rows in _slices(len(across), BLOCK):
            block = across[rows]
            problems = OffsetProblems.of(surface.take(block), start[block], end[block])
            result = _solve_block(spaces, problems, tolerance)
            iterations[block] = result.iterations
            for batch in result.batches:
                parts = batches.setdefault(batch.space, [])
                parts.append(batch.renumbered(block[batch.problems]))
    return MethodResult(tuple(_joined(parts) for parts in batches.values()), iterations)


def _solve_block(
    spaces: Sequence[Callable[[], TrialSpace]], problems: OffsetProblems, tolerance: float
) -> MethodResult:
    xp = problems.xp
    rest = np.arange(problems.count)
    iterations = np.full(problems.count, GUESS_STEPS)
    batches: list[PathBatch] = []
    before = polynomial_space(GUESS_DEGREE)
    chunks = _chunks(problems, rest)
    offset = xp.concat([_guess(before, part) for _, part in chunks], axis=1)
    steps, small = FIRST if len(spaces) > 1 else LATER
    for make_space in spaces:
        space = make_space()
        if space.size == 1:
            continue  # It has the straight line alone.
        offset = constant(_inner(before, space.nodes[1:-1])[0], offset, xp) @ offset
        iterations[rest] += steps
        moved, is_open = [], []
        for rows, part in chunks:
            path, last_step = _newton(space, part, offset[:, rows], steps)
            batch = _measured(space, part, path, tolerance)
            solved = last_step < small
            done = solved & (batch.converged | is_far_outside(batch, solved))
            if done.any():
                batches.append(batch.take(np.flatnonzero(done)).renumbered(rest[rows][done]))
            moved.append(path)
            is_open.append(~done & to_numpy(xp.max(xp.abs(path), axis=0) < MAX_OFFSET))
        keep = np.flatnonzero(np.concatenate(is_open))
        if len(keep) == 0:
            break
        offset = xp.take(xp.concat(moved, axis=1), constant(keep, offset, xp), axis=1)
        rest, before, (steps, small) = rest[keep], space, LATER
        chunks = _chunks(problems, rest)
    return MethodResult(tuple(batches), iterations)


def _chunks(problems: OffsetProblems, rest: Ints) -> list[tuple[slice, OffsetProblems]]:
    """The problems that are left, in parts, each with its place in `rest`."""
    size = CHUNK if is_on_cpu(problems.columns) else BLOCK
    if len(rest) == problems.count <= size:
        return [(slice(None), problems)]
    return [(rows, problems.take(rest[rows])) for rows in _slices(len(rest), size)]


def _guess(space: TrialSpace, problems: OffsetProblems) -> Any:
    straight = 0.0 * problems.columns[: space.size - 1, 0, :]
    return _newton(space, problems, straight, GUESS_STEPS)[0]


def _newton(
    space: TrialSpace, problems: OffsetProblems, offset: Any, steps: int
) -> tuple[Any, Array]:
    """The offsets at the inner nodes, shape (n - 1, problems), and the size of the last step."""
    xp = problems.xp
    coefficients = _coefficients(problems, space.nodes[1:-1])
    for _ in range(steps):
        step = _step(space, coefficients, offset, xp)
        size = xp.max(xp.abs(step), axis=0)
        offset = offset + step * xp.where(size > LONGEST_STEP, LONGEST_STEP / size, 1.0)
    return offset, to_numpy(size)


def _step(space: TrialSpace, coefficients: Any, offset: Any, xp: Any) -> Any:
    """Newton's step from offsets at the inner nodes, shape (n - 1, problems)."""
    times = space.nodes[1:-1]
    _, first, second = (constant(rows, offset, xp) for rows in _inner(space, times))
    left, by_offset, by_slope, by_bend = linearize(
        coefficients, offset, first @ offset, second @ offset
    )
    matrix = by_slope[:, None, :] * first[:, :, None]
    matrix += by_bend[:, None, :] * second[:, :, None]
    identity = constant(np.eye(len(times)), offset, xp)
    matrix += identity[:, :, None] * by_offset[:, None, :]
    return solve_batch(matrix, -left, xp)


def _measured(
    space: TrialSpace, problems: OffsetProblems, offset: Any, tolerance: float
) -> PathBatch:
    xp, count = problems.xp, problems.count
    times = space.quadrature.points
    path, slope, bend = (constant(rows, offset, xp) @ offset for rows in _inner(space, times))
    geometry = offset_geometry(_coefficients(problems, times), path, slope, bend, xp)
    length = length_and_error(space, geometry, xp).mapped(to_numpy)
    length = replace(length, error=length.error + problems.rounding)
    values = np.empty((count, 2, space.size + 1))
    values[:, :, 0], values[:, :, -1] = problems.start, problems.end
    for axis, parameter in enumerate(problems.parameters(space.nodes[1:-1], offset)):
        values[:, axis, 1:-1] = to_numpy(parameter).T
    # Steep lengths need differences of neighboring control points, which this form does not use.
    good = length.is_known_to(tolerance) & ~is_steep(length.raw, values)
    return PathBatch(
        np.arange(count),
        space.with_lines,
        values,
        length,
        good,
        np.zeros(count, bool),
        speed=to_numpy(geometry.speed).T,
    )


def _coefficients(problems: OffsetProblems, times: Array) -> Any:
    """The polynomials in the offset that the equation takes."""
    columns, xp = problems.columns, problems.xp
    matrix = constant(offset_map(problems.degrees, tuple(times.tolist())), columns, xp)
    product = matrix @ xp.reshape(columns, (columns.shape[0], -1))
    return xp.reshape(product, (-1, len(FIELDS), len(times), 3, problems.count))


def _inner(space: TrialSpace, times: Array) -> Array:
    """The maps of `matrices` for functions that vanish at the ends, from their inner nodes."""
    return _inner_at(space, tuple(times.tolist()))


@lru_cache(maxsize=64)
def _inner_at(space: TrialSpace, times: tuple[float, ...]) -> Array:
    return np.ascontiguousarray(space.matrices(np.array(times))[:, :, 1:-1])


def _slices(count: int, size: int) -> Iterator[slice]:
    """Yield the range of a number of problems in nearly equal parts of at most a size."""
    edges = np.linspace(0, count, -(-count // size) + 1).astype(int)
    for first, last in pairwise(edges):
        yield slice(int(first), int(last))


def _joined(batches: Sequence[PathBatch]) -> PathBatch:
    """One batch made of several on the same space."""
    return PathBatch(
        np.concatenate([batch.problems for batch in batches]),
        batches[0].space,
        np.concatenate([batch.values for batch in batches]),
        Length.concatenated([batch.length for batch in batches]),
        np.concatenate([batch.converged for batch in batches]),
        np.concatenate([batch.singular for batch in batches]),
        speed=np.concatenate([batch.speed for batch in batches if batch.speed is not None]),
    )
