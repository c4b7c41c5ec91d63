"""The paper's two methods and the truth on many patches, in worker processes."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.oracle.workers import map_in_processes
from bodymeasure.paper.data.truth import true_diagonals
from bodymeasure.paper.method.ritz_table import solve_ritz
from bodymeasure.paper.method.two_function_solve import solve_two_functions

Result = TypeVar("Result")

# The number of patches that a worker gets at once, which is some seconds of work. It is fixed, so
# that what is computed together does not depend on the number of workers.
CHUNK = 20


@dataclass(frozen=True, eq=False)
class Comparison:
    """The results on a set of patches; arrays of shape (patches,).

    Parameters
    ----------
    inside_length, all_length : ndarray
        Lengths by two radial functions: the shortest solution inside the patch, and of all; NaN
        without a solution.
    collocation_point : ndarray
        The collocation point of `inside_length`; NaN without a solution.
    roots, roots_inside : ndarray of int
        Numbers of real solutions at the collocation point 1/2, and of those that stay inside.
    degenerate : ndarray of int
        Number of collocation points that were refused because the determinant was zero.
    ritz_length : ndarray
    ritz_order : ndarray of int
    ritz_stopped, ritz_inside : ndarray of bool
        Whether the change fell under the bound, and whether the path stays in the patch.
    true_length, true_error : ndarray
        Length of the converged shortest path and its estimated error; NaN and infinite where
        unknown.
    turns_back, along_edge : ndarray of bool
        Whether the true path does so.
    rbf_seconds, ritz_seconds : ndarray
        Processor times of each patch by itself, for the solution inside the patch and for Ritz.
    """

    inside_length: Array
    all_length: Array
    collocation_point: Array
    roots: Ints
    roots_inside: Ints
    degenerate: Ints
    ritz_length: Array
    ritz_order: Ints
    ritz_stopped: Bools
    ritz_inside: Bools
    true_length: Array
    true_error: Array
    turns_back: Bools
    along_edge: Bools
    rbf_seconds: Array
    ritz_seconds: Array

    def __len__(self) -> int:
        return len(self.roots)

    def take(self, rows: slice) -> "Comparison":
        """Return some of the patches."""
        return Comparison(**{f.name: getattr(self, f.name)[rows] for f in fields(self)})


def compare(
    control_points: Array,
    *,
    processes: int,
    progress: Callable[[int], None] | None = None,
) -> Comparison:
    """Solve for the diagonals from (0, 0) to (1, 1) by both methods, and to convergence.

    Parameters
    ----------
    control_points : ndarray, shape (patches, 4, 4, 3)
    processes : int
        Worker processes. The results do not depend on their number.
    progress : callable, optional
        Called with the number of patches that are done.
    """
    chunks = in_chunks(control_points)
    advance = None if progress is None else _patches_done(progress, len(control_points))
    parts = map_in_processes(
        compare_chunk, chunks, processes=processes, progress=advance, apart=True
    )
    return joined(Comparison, parts)


def joined(kind: type[Result], parts: Sequence[Result]) -> Result:
    """Return results on parts of a batch, dataclasses of arrays, as one of the whole batch."""
    names = [field.name for field in fields(kind)]  # type: ignore[arg-type]
    return kind(**{name: np.concatenate([getattr(p, name) for p in parts]) for name in names})


def in_chunks(control_points: Array) -> list[Array]:
    """Return patches in the parts in which they are sent to workers."""
    return [control_points[i : i + CHUNK] for i in range(0, len(control_points), CHUNK)]


def _patches_done(progress: Callable[[int], None], total: int) -> Callable[[int], None]:
    return lambda chunks: progress(min(chunks * CHUNK, total))


def compare_chunk(control_points: Array) -> Comparison:
    """Return `compare` for a few patches, without workers."""
    every = solve_two_functions(control_points, "all")
    truth = true_diagonals(control_points)
    inside, rbf_seconds = _one_by_one(_solve_inside, control_points)
    ritz, ritz_seconds = _one_by_one(solve_ritz, control_points)
    return Comparison(
        inside_length=_joined(inside, "length"),
        all_length=every.length,
        collocation_point=_joined(inside, "collocation_point"),
        roots=every.roots,
        roots_inside=every.inside,
        degenerate=every.degenerate + _joined(inside, "degenerate"),
        ritz_length=_joined(ritz, "length"),
        ritz_order=_joined(ritz, "order"),
        ritz_stopped=_joined(ritz, "stopped"),
        ritz_inside=_joined(ritz, "inside"),
        true_length=truth.length,
        true_error=truth.error,
        turns_back=truth.turns_back,
        along_edge=truth.along_edge,
        rbf_seconds=rbf_seconds,
        ritz_seconds=ritz_seconds,
    )


def _solve_inside(control_points: Array) -> Any:
    return solve_two_functions(control_points, "inside")


def _one_by_one(
    solve: Callable[[Array], Result], control_points: Array
) -> tuple[list[Result], Array]:
    """Return the solution for each patch by itself, and its processor time, as in the paper."""
    results, seconds = [], []
    for net in control_points:
        begin = time.thread_time()
        results.append(solve(net[None]))
        seconds.append(time.thread_time() - begin)
    return results, np.array(seconds)


def _joined(solutions: list[Any], name: str) -> NDArray[Any]:
    return np.concatenate([getattr(solution, name) for solution in solutions])
