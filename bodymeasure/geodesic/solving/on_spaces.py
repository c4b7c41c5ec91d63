"""Solving on trial spaces in turn, each larger than the last, until the length is known."""

from collections.abc import Callable, Sequence
from typing import Protocol

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.lengths.measure import measure_length
from bodymeasure.geodesic.solving.newton import MAX_ITERATIONS, NewtonResult, newton
from bodymeasure.geodesic.solving.protocol import MethodResult, PathBatch
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

# The relative error that is asked for. The correction about doubles the number of digits, so that
# this takes far fewer functions than paths of that accuracy would.
TOLERANCE = 1e-10
# On all but the last trial space, Newton's method is given up after this many steps: a few stubborn
# problems are cheaper with more functions.
FIRST_ITERATIONS = 6
# A path this far outside [0, 1], in u or v, is not brought back by more functions: it is a hundred
# times the error of a path on 8 functions that has not converged.
FAR_OUTSIDE = 0.02
# The number of problems that are solved at once, whose arrays then fit the processor's cache.
CHUNK = 384


class Solver(Protocol):
    """A function that finds nodal values of many problems on one trial space, such as `newton`."""

    def __call__(
        self, surface: Surface, space: TrialSpace, start: Array, *, max_iterations: int
    ) -> NewtonResult:
        """Return nodal values, from a guess of shape (problems, 2, n + 1) whose ends stay."""


def solve_on_spaces(
    spaces: Sequence[Callable[[], TrialSpace]],
    surface: Surface,
    ends: tuple[Array, Array],
    *,
    tolerance: float,
    solver: Solver = newton,
) -> MethodResult:
    """Solve a batch of problems; those that fail on one trial space go on to the next.

    The first guess is the straight line in (u, v), and later the path on the previous space.

    Parameters
    ----------
    spaces : sequence of callable
        Functions that make the trial spaces when they are needed, in the order of their use.
    surface : Surface
    ends : tuple of ndarray
        The starts and the ends, both of shape (problems, 2).
    tolerance : float
        The relative error of the length that is asked for.
    solver : Solver
    """
    start, end = ends
    iterations = np.zeros(len(start), np.int64)
    is_open = np.ones(len(start), bool)
    batches: list[PathBatch] = []
    guess: TrialSpace | None = None
    paths = np.empty((len(start), 2, 0))
    for number, make_space in enumerate(spaces, start=1):
        space, is_last = make_space(), number == len(spaces)
        limit = MAX_ITERATIONS if is_last else FIRST_ITERATIONS
        rest = np.flatnonzero(is_open)
        values = straight(start, end, space.nodes)
        if guess is not None:
            known = rest[np.isfinite(paths[rest, 0, 0])]
            values[known] = paths[known] @ guess.matrices(space.nodes)[0].T
        for chunk in np.split(rest, range(CHUNK, len(rest), CHUNK)):
            part = surface.take(chunk)
            found = solver(part, space, values[chunk], max_iterations=limit)
            iterations[chunk] += found.iterations
            if not (is_last or found.converged.any()):
                # All go on to the next space, from the straight line; no length is asked for.
                values[chunk] = np.nan
                continue
            batch = _measured(part, space, chunk, found, tolerance)
            done = batch.converged | (is_last or is_far_outside(batch, found.converged))
            values[chunk] = np.where(found.converged[:, None, None], found.values, np.nan)
            is_open[chunk] = ~done
            batches.append(batch.take(np.flatnonzero(done)))
        paths, guess = values, space
        if not is_open.any():
            break
    return MethodResult(tuple(batch for batch in batches if len(batch.problems)), iterations)


def _measured(
    surface: Surface,
    space: TrialSpace,
    problems: Ints,
    found: NewtonResult,
    tolerance: float,
) -> PathBatch:
    length = measure_length(surface, space, found.values)
    converged = found.converged & length.is_known_to(tolerance)
    return PathBatch(problems, space, found.values, length, converged, found.singular)


def is_far_outside(batch: PathBatch, solved: Bools) -> Bools:
    """Return which paths leave their patch so far that more functions would not bring them back.

    They have no length on the patch, and the polynomials that continue it may be wild.
    """
    result = np.zeros(len(batch.problems), bool)
    rows = np.flatnonzero(~batch.converged & solved)
    result[rows] = batch.space.leaves_patch(batch.values[rows], FAR_OUTSIDE)
    return result


def straight(start: Array, end: Array, nodes: Array) -> Array:
    """Return the nodal values of straight lines in (u, v), shape (problems, 2, n + 1)."""
    line: Array = start[:, :, None] + (end - start)[:, :, None] * nodes
    line[:, :, -1] = end
    return line
