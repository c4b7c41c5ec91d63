"""Many geodesics by collocation with one unknown function each, where that serves.

Nothing is iterated until it converges: each trial space gets one or two Newton steps from the
previous path. The lengths are measured like all others, and only paths whose lengths are known well
enough are kept. All others are left to the form with two unknown functions.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.graph import arrays, compiled
from bodymeasure.geodesic.graph.problems import OffsetProblems, are_corners, slices
from bodymeasure.geodesic.graph.rung import GUESS_STEPS, Climbed, Rung, guess_space
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.lengths.varying_speed import VaryingSpeed
from bodymeasure.geodesic.solving.protocol import MethodResult, PathBatch
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces

# The number of Newton steps on the first of several trial spaces, which serves most problems, and
# the largest last step: a second step would change the paths of bodies by less than their error for
# want of functions, and the error left by a step is about its square, which the correction removes.
FIRST = (1, 1e-2)
# The same on the spaces after it, or on a single one.
LATER = (2, 1e-4)
# The number of problems whose failures are gathered for the next trial space. This bounds the
# memory, except where compiled code writes results where they stay.
BLOCK = 16384


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
    differ = start != end
    across = np.flatnonzero(differ[:, 0] & differ[:, 1])
    is_whole = len(across) == len(start)
    corners = are_corners(start, end)
    # All at once where that copies nothing.
    copies_nothing = is_whole and corners and compiled.serves(surface.control_points)
    size = max(BLOCK, len(start)) if copies_nothing else BLOCK
    # A system without a solution ends in numbers that are not finite, and its problem is left over.
    with np.errstate(all="ignore"):
        for rows in slices(len(across), size):
            block = across[rows]
            # What is in a row need not be copied.
            here = rows if is_whole else block
            nets = surface.control_points[rows, ...] if is_whole else _taken(surface, block)
            make = OffsetProblems.of_corners if corners else OffsetProblems.of
            problems = make(nets, start[here], end[here])
            result = _solve_block(spaces, problems, tolerance)
            iterations[here] = result.iterations
            for batch in result.batches:
                parts = batches.setdefault(batch.space, [])
                same = is_whole and rows.start == 0
                parts.append(batch if same else batch.renumbered(block[batch.problems]))
    joined = (_joined(parts) for parts in batches.values())
    return MethodResult(
        tuple(replace(each, speed=VaryingSpeed(surface, each.problems)) for each in joined),
        iterations,
    )


def _taken(surface: BezierSurfaces, rows: Ints) -> Any:
    return surface.take(rows).control_points


def _solve_block(
    spaces: Sequence[Callable[[], TrialSpace]], problems: OffsetProblems, tolerance: float
) -> MethodResult:
    rest = np.arange(problems.count)
    iterations = np.full(problems.count, GUESS_STEPS)
    batches: list[PathBatch] = []
    offset, before = None, guess_space()
    steps = FIRST if len(spaces) > 1 else LATER
    for make_space in spaces:
        space = make_space()
        if space.size == 1:
            continue  # It has the straight line alone.
        every = len(rest) == problems.count
        iterations[... if every else rest] += steps[0]
        rung = Rung(before, space, *steps, tolerance)
        parts = list(_climbed(problems, rest, rung, offset))
        found = [part.done for part in parts if len(part.done.problems)]
        batches += found if every else [each.renumbered(rest[each.problems]) for each in found]
        keep = np.concatenate([part.left for part in parts])
        if len(keep) == 0:
            break
        offset = problems.xp.concat([part.offset for part in parts], axis=1)
        rest, before, steps = rest[keep], space, LATER
    return MethodResult(tuple(batches), iterations)


def _climbed(problems: OffsetProblems, rest: Ints, rung: Rung, offset: Any) -> Iterator[Climbed]:
    if compiled.serves(problems.nets) and compiled.is_served(rung.space):
        yield compiled.climb(problems, rest, rung, offset)
    else:
        yield from arrays.climb(problems, rest, rung, offset)


def _joined(batches: Sequence[PathBatch]) -> PathBatch:
    """One batch made of several on the same space."""
    if len(batches) == 1:
        return batches[0]
    reach, chord = ([getattr(batch, name) for batch in batches] for name in ("reach", "chord"))
    is_known = all(each is not None for each in reach)
    return PathBatch(
        np.concatenate([batch.problems for batch in batches]),
        batches[0].space,
        np.concatenate([batch.values for batch in batches]),
        Length.concatenated([batch.length for batch in batches]),
        np.concatenate([batch.converged for batch in batches]),
        np.concatenate([batch.singular for batch in batches]),
        reach=np.concatenate(reach) if is_known else None,
        chord=np.concatenate(chord) if is_known else None,
    )
