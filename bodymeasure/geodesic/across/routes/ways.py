"""Rough ways between two points: those among which the shortest path is likely to lie.

Half of a shortest path leads from its start to its middle, and half from there to its end, each
the shortest. So the shortest ways of a graph through the points halfway, of which no neighboring
point has a shorter one, hold one near the shortest path. As the graph's ways are too long by some
parts in a hundred, that may be another one than the shortest of them.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.geodesic.across.routes.graph import PatchGraph, Reach, patch_graph
from bodymeasure.geodesic.across.routes.strips import StraightWay, straight_way
from bodymeasure.native import WaysWanted, first_ways_straightened, is_compiled

Ends = tuple[AtlasPoint, AtlasPoint]

# Ways that are nowhere farther apart than this part of their length, at these parts of it, lead to
# the same path.
NEAR, COURSE = 0.01, np.linspace(0.0, 1.0, 33)


class Scope(NamedTuple):
    """How widely ways are sought.

    Parameters
    ----------
    longer : float
        Ways of the graph that are longer than its shortest by more than this part of it are left
        out. They are too long by some parts in a hundred, by different amounts.
    still_longer : float
        So are ways that are longer than the shortest by this part once they are pulled straight.
    parts : tuple of float
        The parts of the length at which the points are picked through which ways lead.
    spread : float
        Points that are picked there are farther apart than this part of the length.
    most : int
        The number of ways that are pulled straight, at most.
    """

    longer: float = 0.06
    still_longer: float = 0.012
    parts: tuple[float, ...] = (0.5, 0.25, 0.75)
    spread: float = 0.07
    most: int = 24


USUAL = Scope()


def first_ways(
    atlas: Atlas, start: AtlasPoint, end: AtlasPoint, scope: Scope = USUAL
) -> list[StraightWay]:
    """Return different ways between two points, pulled straight on the mesh; the shortest first.

    There are none if no seams join the points.
    """
    graph = patch_graph(atlas)
    found = _compiled_ways(atlas, graph, (start, end), scope)
    if found is None:
        found = _straight_ways(atlas, graph, (start, end), scope)
    ways = sorted(found, key=lambda way: way.length)
    different: list[StraightWay] = []
    courses: list[Array] = []
    for way in ways:
        if way.length > (1.0 + scope.still_longer) * ways[0].length:
            break
        course = along_way(way.points(graph.mesh.surface), COURSE)
        if all(np.abs(course - other).max() > NEAR * way.length for other in courses):
            different.append(way)
            courses.append(course)
    return different


def _compiled_ways(
    atlas: Atlas, graph: PatchGraph, ends: Ends, scope: Scope
) -> list[StraightWay] | None:
    """Return what `_straight_ways` does; None if no kernel serves."""
    if not is_compiled() or graph.mesh.surface.forks:
        return None
    start, end = (graph.joined_end(atlas, place) for place in ends)
    wanted = WaysWanted(scope.longer, scope.spread, scope.parts, scope.most)
    arrays = graph.mesh.surface.arrays
    found = first_ways_straightened(arrays, graph.arrays, (start, end), wanted)
    return None if found is None else list(map(StraightWay.of, found))


def _straight_ways(atlas: Atlas, graph: PatchGraph, ends: Ends, scope: Scope) -> list[StraightWay]:
    """Return the rough ways with different strips once they are pulled straight."""
    begin, finish = (graph.reach(atlas, end) for end in ends)
    start, end = (graph.mesh.holding(end) for end in ends)
    begun: set[bytes] = set()
    found: dict[bytes, StraightWay] = {}
    for vertices in _rough_ways(graph, begin, finish, scope):
        key = vertices.tobytes()
        if key in begun or len(begun) == scope.most:
            continue
        begun.add(key)
        way = straight_way(graph.mesh.surface, (start, end), vertices)
        if way is not None:
            found.setdefault(way.strip.tobytes(), way)
    return list(found.values())


def way_through(atlas: Atlas, ends: Ends, vertices: tuple[int, ...]) -> StraightWay | None:
    """Return the way that leads through vertices of the graph at first, pulled straight."""
    graph = patch_graph(atlas)
    whole: list[Ints] = []
    start = ends[0]
    for vertex in vertices:
        whole += graph.ways(graph.reach(atlas, start), np.array([vertex]))
        start = graph.places[vertex]
    (back,) = graph.ways(graph.reach(atlas, ends[1]), np.array(vertices[-1:]))
    whole.append(back[::-1])
    first, last = (graph.mesh.holding(end) for end in ends)
    return straight_way(graph.mesh.surface, (first, last), np.concatenate(whole))


def along_way(points: Array, parts: Array) -> Array:
    """Return the points of a polygon at parts of its length, shape (len(parts), 3)."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    bounds = np.concatenate([[0.0], np.cumsum(steps)])
    return np.stack([np.interp(parts * bounds[-1], bounds, axis) for axis in points.T], axis=-1)


def _rough_ways(graph: PatchGraph, begin: Reach, finish: Reach, scope: Scope) -> Iterator[Ints]:
    """Yield the vertices of rough ways along the edges of the mesh, the likeliest first.

    Some follow on themselves.
    """
    through = begin.distances + finish.distances
    if not np.isfinite(through).any():
        return
    only = int(np.argmin(through))
    least = float(through[only])
    ways = [(least, only, only, -1)]
    for part in scope.parts:
        steps = _over_level(graph, (begin, finish), part, (1.0 + scope.longer) * least)
        ways += _spread(graph, steps, scope.spread * least)
    first, last, step = np.array([way[1:] for way in sorted(ways)]).T
    halves = graph.ways(begin, first), graph.along[step], graph.ways(finish, last)
    for ahead, between, back in zip(*halves, strict=True):
        yield np.concatenate([ahead, between[between >= 0], back[::-1]])


class _Steps(NamedTuple):
    """Steps of a graph, those of the shortest ways first; arrays of shape (steps,).

    Parameters
    ----------
    whole : ndarray
        The length of the way over each.
    first, last, number : ndarray of int
        The vertices at its ends, and its number.
    """

    whole: Array
    first: Ints
    last: Ints
    number: Ints


def _over_level(
    graph: PatchGraph, reaches: tuple[Reach, Reach], part: float, most: float
) -> _Steps:
    """The steps over which ways pass a part of their length, which is `most` at most.

    From each vertex there is only the one of the shortest way.
    """
    ahead, back = (reach.distances for reach in reaches)
    near = np.flatnonzero(ahead + back <= most)
    # It is positive beyond that part of the length.
    beyond = np.full(len(ahead), -np.inf)
    beyond[near] = (1.0 - part) * ahead[near] - part * back[near]
    first, step = _steps_from(graph, near[beyond[near] <= 0.0])
    last = graph.steps.indices[step]
    rows = np.flatnonzero(beyond[last] > 0.0)
    first, step, last = first[rows], step[rows], last[rows]
    whole = ahead[first] + graph.steps.data[step] + back[last]
    order = np.argsort(whole, kind="stable")
    order = order[: np.searchsorted(whole[order], most, side="right")]
    order = order[np.sort(np.unique(first[order], return_index=True)[1])]
    return _Steps(whole[order], first[order], last[order], step[order])


def _spread(graph: PatchGraph, steps: _Steps, apart: float) -> list[tuple[float, int, int, int]]:
    """The steps each of which begins farther than a distance from those before it."""
    places = graph.vertices[steps.first]
    picked: list[int] = []
    left = np.arange(len(places))
    while len(left):
        picked.append(int(left[0]))
        off = places[left] - places[left[0]]
        left = left[np.einsum("ij,ij->i", off, off) > apart * apart]
    return list(zip(*(each[picked].tolist() for each in steps), strict=True))


def _steps_from(graph: PatchGraph, vertices: Ints) -> tuple[Ints, Ints]:
    """The steps from some vertices: the vertex of each, and its number."""
    begins, ends = graph.steps.indptr[vertices], graph.steps.indptr[vertices + 1]
    count = ends - begins
    first = np.repeat(vertices, count)
    step = np.arange(count.sum()) + np.repeat(begins - np.cumsum(count) + count, count)
    return first, step
