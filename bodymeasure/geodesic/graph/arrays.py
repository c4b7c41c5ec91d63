"""Newton's method and lengths on one trial space, by operations on arrays of any library."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.graph.equation import linearize, offset_geometry
from bodymeasure.geodesic.graph.maps import FIELDS, offset_map
from bodymeasure.geodesic.graph.problems import OffsetProblems, slices
from bodymeasure.geodesic.graph.rung import (
    GUESS_STEPS,
    LONGEST_STEP,
    MAX_OFFSET,
    Climbed,
    Rung,
    guess_space,
    inner_maps,
)
from bodymeasure.geodesic.lengths.jacobi import length_and_error
from bodymeasure.geodesic.lengths.measure import is_steep
from bodymeasure.geodesic.numerics.array_libraries import constant, to_numpy
from bodymeasure.geodesic.numerics.elimination import solve_batch
from bodymeasure.geodesic.solving.on_spaces import is_far_outside
from bodymeasure.geodesic.solving.protocol import PathBatch
from bodymeasure.geodesic.spaces.trial_space import TrialSpace


def climb(problems: OffsetProblems, rest: Ints, rung: Rung, offset: Any) -> Iterator[Climbed]:
    """Yield what becomes of problems on a trial space, in parts.

    Parameters
    ----------
    problems : OffsetProblems
    rest : ndarray of int, shape (k,)
        The problems that are tried.
    rung : Rung
    offset : array, shape (m - 1, k), optional
        Offsets at the inner nodes of the space before; without them, that is `guess_space`, and
        they are found there first.
    """
    xp, space = problems.xp, rung.space
    offset = _guess(problems, rest) if offset is None else offset
    offset = constant(inner_maps(rung.before, space.nodes[1:-1])[0], offset, xp) @ offset
    for rows, part in _chunks(problems, rest):
        path, last_step = _newton(space, part, offset[:, rows], rung.steps)
        batch = _measured(space, part, path, rung.tolerance)
        solved = last_step < rung.small
        done = solved & (batch.converged | is_far_outside(batch, solved))
        is_open = ~done & to_numpy(xp.max(xp.abs(path), axis=0) < MAX_OFFSET)
        place, left = np.arange(len(rest))[rows], np.flatnonzero(is_open)
        kept = np.flatnonzero(done)
        yield Climbed(
            batch.take(kept).renumbered(place[kept]),
            place[left],
            xp.take(path, constant(left, path, xp), axis=1),
        )


def _guess(problems: OffsetProblems, rest: Ints) -> Any:
    """Offsets at the inner nodes of `guess_space`, shape (n - 1, k)."""
    space, xp = guess_space(), problems.xp
    offsets = []
    for _, part in _chunks(problems, rest):
        straight = 0.0 * part.columns[: space.size - 1, 0, :]
        offsets.append(_newton(space, part, straight, GUESS_STEPS)[0])
    return xp.concat(offsets, axis=1)


def _chunks(problems: OffsetProblems, rest: Ints) -> list[tuple[slice, OffsetProblems]]:
    """The problems that are left, in parts, each with its place in `rest`."""
    if len(rest) == problems.count:
        return problems.chunks
    size = problems.chunk_size
    return [(rows, problems.take(rest[rows])) for rows in slices(len(rest), size)]


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
    _, first, second = (constant(rows, offset, xp) for rows in inner_maps(space, times))
    left, by_offset, by_slope, by_bend = linearize(
        coefficients, offset, first @ offset, second @ offset, xp
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
    path, slope, bend = (constant(rows, offset, xp) @ offset for rows in inner_maps(space, times))
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
    )


def _coefficients(problems: OffsetProblems, times: Array) -> Any:
    """The polynomials in the offset that the equation takes."""
    columns, xp = problems.columns, problems.xp
    matrix = constant(offset_map(problems.degrees, tuple(times.tolist())), columns, xp)
    product = matrix @ xp.reshape(columns, (columns.shape[0], -1))
    return xp.reshape(product, (-1, len(FIELDS), len(times), 3, problems.count))
