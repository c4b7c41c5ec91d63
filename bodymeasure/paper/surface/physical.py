"""The paper's physical lengths: shortest distances on the surface to which an atlas was fitted."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.oracle.extrapolate import richardson
from bodymeasure.oracle.libigl import ROUND_OFF, exact_distance
from bodymeasure.oracle.validate import validate_mesh
from bodymeasure.oracle.workers import map_in_processes
from bodymeasure.paper.surface.corridor import Corridors, shortest_way_out
from bodymeasure.paper.surface.fine_surface import FineSurface
from bodymeasure.paper.surface.insertion import insert_point
from bodymeasure.subdivision import QuadMesh, triangles

# Half widths of corridors, as parts of the length of the path. The first one is taken that no path
# as short can leave. A straight detour by 0.15 of the length is longer by 4 %; next to the bends of
# a body, the straight distances that prove it are shorter.
HALF_WIDTHS = (0.15, 0.2, 0.3, 0.45, 0.7, 1.0)


class PhysicalLengths(NamedTuple):
    """Lengths of shortest paths over a surface and their uncertainties, each of shape (k,)."""

    length: Array
    uncertainty: Array


class _Task(NamedTuple):
    meshes: tuple[QuadMesh, ...]
    start: Array
    end: Array
    way_out: float


def physical_lengths(
    surface: FineSurface,
    paths: Array,
    ends: Array,
    *,
    processes: int = 1,
    progress: Callable[[int], None] | None = None,
) -> PhysicalLengths:
    """Return shortest distances between pairs of points of a surface, by libigl's exact geodesics.

    Each is measured on a part of the surface that the shortest path cannot leave, at all levels,
    and extrapolated.

    Parameters
    ----------
    surface : FineSurface
    paths : ndarray, shape (k, p, 3)
        Points of some path along the surface between each pair. The surface around it is cut out,
        and its length limits how far the shortest path can go.
    ends : ndarray, shape (k, 2, 3)
        Points of the limit surface.
    processes : int
        Worker processes.
    progress : callable, optional
        Called with the number of distances measured so far.

    Raises
    ------
    MissingExtraError
        If libigl is not installed.
    """
    corridors = Corridors(surface)
    tasks = [_task(corridors, path, *pair) for path, pair in zip(paths, ends, strict=True)]
    by_level = map_in_processes(_measure, tasks, processes=processes, progress=progress)
    length, uncertainty = richardson(np.array(by_level), surface.segments)
    # A shorter path than the one found would have to leave the corridor, which takes `way_out`.
    left_out = np.maximum(length - [task.way_out for task in tasks], 0.0)
    return PhysicalLengths(length, uncertainty + left_out + ROUND_OFF * length)


def _task(corridors: Corridors, path: Array, start: Array, end: Array) -> _Task:
    length = float(np.linalg.norm(np.diff(path, axis=0), axis=-1).sum())
    for half_width in HALF_WIDTHS:
        chosen = corridors.around(path, half_width * length)
        meshes = tuple(corridors.meshes(chosen))
        way_out = shortest_way_out(meshes[-1], start, end)
        if way_out > length:
            break
    return _Task(meshes, start, end, way_out)


def _measure(task: _Task) -> list[float]:
    """Return the distance on the mesh of each level."""
    distances = []
    for mesh in task.meshes:
        vertices, faces = mesh.vertices, triangles(mesh.quads)
        vertices, faces, start = insert_point(vertices, faces, task.start)
        vertices, faces, end = insert_point(vertices, faces, task.end)
        if start == end or (vertices[start] != task.start).any():
            raise InputError(
                f"points {task.start.tolist()} and {task.end.tolist()} share a face of the mesh; "
                "they are too near each other for its size"
            )
        validate_mesh(vertices, faces)
        distances.append(exact_distance(vertices, faces, start, end))
    return distances
