"""Distances over the tessellation of each patch, by libigl or by edge flips."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.arguments import require_progress
from bodymeasure.bezier import evaluate
from bodymeasure.errors import InputError
from bodymeasure.oracle.extrapolate import richardson
from bodymeasure.oracle.flips import flip_distances
from bodymeasure.oracle.grid import grid_lines, refined_grid
from bodymeasure.oracle.libigl import ROUND_OFF, exact_distance, heat_distances, require_libigl
from bodymeasure.oracle.validate import validate_mesh
from bodymeasure.oracle.workers import map_in_processes

# Chosen with tests/benchmarks/patches/oracle_levels.py: the extrapolated length is within 4e-7 of
# the smooth one in the median over a body's diagonals, for 30 ms of one core each.
LEVELS = (5, 10, 15, 20)

Engine = Literal["libigl", "flips"]
"""What measures distances over meshes: libigl's exact algorithm, or potpourri3d's edge flips."""

# The place of the level whose mesh serves the heat method, which is no better on finer ones.
HEAT = 1

# Patches a worker measures at a time: some tenths of a second.
CHUNK = 4


@dataclass(frozen=True, eq=False)
class MeshDistances:
    """Distances between pairs of points of patches, over meshes of each patch alone.

    Parameters
    ----------
    exact : ndarray, shape (patches, pairs)
        Length of the shortest path in the patch, extrapolated from exact polyhedral distances.
    exact_uncertainty : ndarray, shape (patches, pairs)
        How far `exact` may be off, estimated from the disagreement of its levels.
    heat : ndarray, shape (patches, pairs)
        Distance by the heat method on the mesh of the second level: right to about 1 %.
    by_level : ndarray, shape (patches, pairs, len(levels))
        Exact polyhedral distances on the mesh of each level.
    levels : tuple of int
        Segments of a patch along u (along v there are 8/5 as many), coarsest first.
    failures : mapping of int to str
        Patches that have no valid mesh, and why; all their distances are NaN.
    """

    exact: Array
    exact_uncertainty: Array
    heat: Array
    by_level: Array
    levels: tuple[int, ...]
    failures: Mapping[int, str]


class _Task(NamedTuple):
    control_points: Array
    start: Array
    end: Array


class _Outcome(NamedTuple):
    """The results of one patch: a row for each pair, and why the patch failed, if it did.

    A row has the distances by level, the heat distance, and how far the ends were moved.
    """

    rows: Array
    failure: str | None


def mesh_distances(
    control_points: ArrayLike,
    start: ArrayLike,
    end: ArrayLike,
    *,
    levels: tuple[int, ...] = LEVELS,
    engine: Engine = "libigl",
    processes: int = 1,
    progress: Callable[[int], None] | None = None,
) -> MeshDistances:
    """Return shortest distances within patches, found on meshes, to check a method's lengths.

    Each patch is meshed alone, so that paths stay in it. Grid lines run through the end points at
    every level; they may lie anywhere in the patch.

    Parameters
    ----------
    control_points : array_like, shape (patches, m + 1, n + 1, 3)
    start, end : array_like, shape (patches, pairs, 2)
        (u, v) in [0, 1].
    levels : tuple of int
        Segments of a patch along u for each mesh, ascending; at least two, all multiples of the
        first. Three or more make the uncertainty sharp.
    engine : {"libigl", "flips"}
        What measures. Edge flips take a fifth of the time, and bound distances from above.
    processes : int
        Worker processes; 1 works here. With more, a script needs the guard
        ``if __name__ == "__main__":``, since workers import it.
    progress : callable, optional
        Called with the number of pairs measured so far.

    Returns
    -------
    MeshDistances

    Raises
    ------
    InputError
        If a shape or value is not what is said above.
    MissingExtraError
        If libigl is not installed.
    WorkerError
        If a worker process died.

    Examples
    --------
    >>> import numpy as np
    >>> third = np.arange(4) / 3
    >>> square = np.stack([*np.meshgrid(third, third, indexing="ij"), np.zeros((4, 4))], axis=-1)
    >>> measured = mesh_distances(square[None], [[(0, 0)]], [[(1, 1)]])
    >>> print(f"{measured.exact[0, 0]:.6f}")
    1.414214
    """
    nets, starts, ends = _checked(control_points, start, end)
    levels = _checked_levels(levels)
    if isinstance(processes, bool) or not isinstance(processes, int) or processes < 1:
        raise InputError(f"processes is {processes!r}; expected at least 1, a whole number")
    require_progress(progress)
    require_libigl()

    count, pairs = starts.shape[:2]
    tasks = [_Task(*task) for task in zip(nets, starts, ends, strict=True)]
    chunks = [tasks[i : i + CHUNK] for i in range(0, count, CHUNK)]

    def count_pairs(finished_chunks: int) -> None:
        if progress is not None:
            progress(min(finished_chunks * CHUNK, count) * pairs)

    chunk_outcomes = map_in_processes(
        partial(_measure_chunk, levels=levels, engine=engine),
        chunks,
        processes=processes,
        progress=count_pairs,
    )
    outcomes = [outcome for chunk in chunk_outcomes for outcome in chunk]
    rows = np.stack([outcome.rows for outcome in outcomes])
    by_level, heat, moved = rows[..., :-2], rows[..., -2], rows[..., -1]
    exact, uncertainty = richardson(by_level, levels)
    return MeshDistances(
        exact=exact,
        exact_uncertainty=uncertainty + moved + ROUND_OFF * exact,
        heat=heat,
        by_level=by_level,
        levels=levels,
        failures={i: o.failure for i, o in enumerate(outcomes) if o.failure is not None},
    )


def _measure_chunk(
    tasks: list[_Task], *, levels: tuple[int, ...], engine: Engine
) -> list[_Outcome]:
    return [_measure(task, levels, engine) for task in tasks]


def _measure(task: _Task, levels: tuple[int, ...], engine: Engine) -> _Outcome:
    """All pairs of one patch; those that ask for the same grid lines share the meshes."""
    rows = np.full((len(task.start), len(levels) + 2), np.nan)
    groups: dict[tuple[bytes, ...], list[int]] = {}
    for pair, ends in enumerate(zip(task.start, task.end, strict=True)):
        lines = grid_lines(np.array(ends))
        groups.setdefault(tuple(line.tobytes() for line in lines), []).append(pair)
    try:
        for group in groups.values():
            part = _Task(task.control_points, task.start[group], task.end[group])
            rows[group] = _measure_group(part, levels, engine)
    except InputError as error:
        return _Outcome(np.full_like(rows, np.nan), str(error))
    return _Outcome(rows, None)


def _measure_group(task: _Task, levels: tuple[int, ...], engine: Engine) -> Array:
    by_level = np.zeros((len(task.start), len(levels)))
    lines = grid_lines(np.array([task.start[0], task.end[0]]))
    for level, segments in enumerate(levels):
        grid = refined_grid(*lines, levels[0], segments // levels[0])
        vertices, faces, number = grid.mesh(task.control_points)
        validate_mesh(vertices, faces)
        sources = number[[grid.vertex(point) for point in task.start]]
        targets = number[[grid.vertex(point) for point in task.end]]
        if engine == "flips":
            by_level[:, level] = flip_distances(vertices, faces, sources, targets)
        else:
            for pair, (source, target) in enumerate(zip(sources, targets, strict=True)):
                if source != target:
                    by_level[pair, level] = exact_distance(vertices, faces, source, target)
        if level == HEAT:
            distinct, place = np.unique(sources, return_inverse=True)
            heat = heat_distances(vertices, faces, distinct)[place, targets]
    moved = np.zeros(len(task.start))
    for points, numbers in ((task.start, sources), (task.end, targets)):
        positions = evaluate(task.control_points, points)
        moved += np.linalg.norm(positions - vertices[numbers], axis=-1)
    return np.column_stack([by_level, heat, moved])


def _checked(
    control_points: ArrayLike, start: ArrayLike, end: ArrayLike
) -> tuple[Array, Array, Array]:
    nets = np.asarray(control_points, dtype=np.float64)
    if (
        nets.ndim != 4
        or nets.shape[3] not in (3, 4)
        or min(nets.shape[:3]) < 1
        or min(nets.shape[1:3]) < 2
    ):
        raise InputError(
            f"control points have shape {nets.shape}; expected (patches, 4, 4, 3), other degrees, "
            "or four coordinates for rational patches"
        )
    broken = np.flatnonzero(~np.isfinite(nets).all(axis=(1, 2, 3)))
    if len(broken):
        raise InputError(f"patch {broken[0]} has control points that are not finite")
    ends = []
    for name, points in (("start", start), ("end", end)):
        array = np.asarray(points, dtype=np.float64)
        if array.ndim != 3 or array.shape[0] != len(nets) or array.shape[2] != 2:
            raise InputError(
                f"{name} has shape {array.shape}; expected ({len(nets)}, pairs, 2): "
                "(u, v) for each patch and pair"
            )
        outside = np.argwhere(~((array >= 0.0) & (array <= 1.0)).all(axis=-1))
        if len(outside):
            patch, pair = outside[0]
            raise InputError(
                f"{name} of pair {pair} on patch {patch} is (u, v) = "
                f"{tuple(array[patch, pair].tolist())}; expected both in [0, 1]"
            )
        ends.append(array)
    if ends[0].shape != ends[1].shape:
        raise InputError(
            f"start has shape {ends[0].shape}, but end has {ends[1].shape}; expected the same"
        )
    return nets, ends[0], ends[1]


def _checked_levels(levels: tuple[int, ...]) -> tuple[int, ...]:
    levels = tuple(int(level) for level in levels)
    valid = len(levels) >= 2 and levels[0] >= 1
    if not (
        valid
        and all(low < high for low, high in pairwise(levels))
        and all(level % levels[0] == 0 for level in levels)
    ):
        raise InputError(
            f"levels are {levels}; expected at least two ascending multiples of the first, "
            f"such as {LEVELS}"
        )
    return levels
