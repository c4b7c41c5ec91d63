"""The shortest of clearly different ways between two points of an atlas."""

from collections.abc import Iterator

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas, require_atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.queries.locations import Location
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic.across.pieces.path import AtlasPath
from bodymeasure.geodesic.across.poles.leg import leg_between
from bodymeasure.geodesic.across.routes.finer import fine_route
from bodymeasure.geodesic.across.routes.graph import patch_graph
from bodymeasure.geodesic.across.routes.topology import topology
from bodymeasure.geodesic.across.routes.via_pairs import via_pairs
from bodymeasure.geodesic.across.routes.ways import along_way, way_through
from bodymeasure.geodesic.across.search.ends import checked_points
from bodymeasure.geodesic.across.search.leg import leg_along
from bodymeasure.geodesic.across.search.repair import SHORTER
from bodymeasure.threads import one_blas_thread

# Two paths count as one if they are nowhere farther apart, at equal parts of their lengths, than
# this part of the shorter one. Nobody chooses between ways a few micrometers to the left and to the
# right of a seam.
SAME = 0.02
# A way on the mesh that is nowhere farther from a known path than this would be pulled onto it.
NEAR = 0.05
# The parts of their lengths at which paths are compared.
PARTS = np.linspace(0.0, 1.0, 33)
# The longest way that is looked at: at first this many times the shortest one, then this many times
# the reach before, until enough is found or the reach is this many times the shortest way through
# the point that is farthest from both ends.
FIRST_REACH, FURTHER, FARTHEST = 1.5, 2.0, 2.0
# Rough ways are too long by less than this part. One that is still longer than the paths that are
# wanted is not looked at.
SLACK = 0.1
# The number of ways that are looked at in a region, at most.
MOST_WAYS = 16


@one_blas_thread()
def geodesic_alternatives(
    atlas: Atlas, start: Location, end: Location, count: int = 3
) -> tuple[AtlasPath, ...]:
    """Return the shortest different ways between two points: round the front or the back, say.

    Parameters
    ----------
    atlas : Atlas
    start, end : str, AtlasPoint or position of shape (3,)
        As for `geodesic_between`.
    count : int
        The number of paths that are wanted, at least 1.

    Returns
    -------
    tuple of AtlasPath
        The shortest first; fewer than `count` if no more are found. Each is shorter than all paths
        close to it, and its length can be trusted. Any two are somewhere further apart, at equal
        parts of their lengths, than 2 % of the shorter one's length.

    Raises
    ------
    InputError
        If a location is not on the atlas, the two are on parts that no seam joins, or `count` is
        not a whole number above 0.
    ConvergenceError
        If there is no path whose length can be trusted.

    Notes
    -----
    The search is for paths each third of which is the shortest between its own ends, as in
    `bodymeasure.geodesic.across.routes.via_pairs`: about a limb, those on either side and those
    that go round little more than once. Each is pulled straight on the mesh and refined as by
    `geodesic_between`. That none was missed is not proven.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> sides = ("side waist point left", "side waist point right")
    >>> paths = bm.geodesic_alternatives(body, *sides, count=2)
    >>> [f"{path.length:.4f} {body.unit}" for path in paths]
    ['0.3036 m', '0.3852 m']
    """
    if isinstance(count, bool) or not isinstance(count, int | np.integer) or count < 1:
        raise InputError(f"count is {count!r}; expected how many paths, a whole number above 0")
    require_atlas(atlas)
    neighbors = topology(atlas).neighbors
    (first, last), moves = checked_points(atlas, (start, end), ("the start", "the end"))
    shortest = leg_between(atlas, neighbors, first, last)
    # Paths with a length are shorter than all close to them.
    found = [shortest] if shortest.converged else []
    if not found or (count > 1 and shortest.length > 0.0):
        _search(atlas, neighbors, (first, last), count, found)
    if not found:
        raise ConvergenceError(shortest.status.sentence)
    shortest_first = sorted(found, key=lambda path: path.length)[:count]
    return tuple(path.with_ends_moved(*moves) for path in shortest_first)


def _search(
    atlas: Atlas,
    neighbors: Neighbors,
    points: tuple[AtlasPoint, AtlasPoint],
    count: int,
    found: list[AtlasPath],
) -> None:
    """Add other paths to those that are found, until there are enough."""
    for ways in _ways(atlas, points):
        for length, vias in ways:
            lengths = sorted(path.length for path in found)
            if len(found) >= count and length > lengths[count - 1] * (1.0 + SLACK):
                break
            path = _path(atlas, neighbors, points, vias, found)
            if path is None:
                continue
            same = [other for other in found if _are_one(path, other)]
            if all(path.length < other.length * (1.0 - SHORTER) for other in same):
                for other in same:
                    found.remove(other)
                found.append(path)
        if len(found) >= count:
            return


def _ways(
    atlas: Atlas, ends: tuple[AtlasPoint, AtlasPoint]
) -> Iterator[list[tuple[float, tuple[int, int]]]]:
    """The lengths of rough ways and the points they lead through, in wider and wider regions."""
    graph = patch_graph(atlas)
    to_start, to_end = (graph.distances(atlas, place) for place in ends)
    through = to_start + to_end
    farthest = FARTHEST * through[np.isfinite(through)].max()
    reach = FIRST_REACH * through.min()
    while True:
        pairs = via_pairs(graph, to_start, to_end, reach)
        yield [(length, (first, second)) for length, first, second in pairs[:MOST_WAYS]]
        if reach >= farthest:
            return
        reach *= FURTHER


def _path(
    atlas: Atlas,
    neighbors: Neighbors,
    points: tuple[AtlasPoint, AtlasPoint],
    vias: tuple[int, int],
    known: list[AtlasPath],
) -> AtlasPath | None:
    """The shortest path near a way; None if there is none, or if it is plainly a known one."""
    way = way_through(atlas, points, vias)
    if way is None:
        return None
    mesh = patch_graph(atlas).mesh
    course = along_way(way.points(mesh.surface), PARTS)
    if any(_apart(course, path.position(PARTS)) <= NEAR * path.length for path in known):
        return None
    route = fine_route(atlas, neighbors, points, way)
    if route is None:
        return None
    path = leg_along(atlas, neighbors, points, [route])
    return path if path.converged else None


def _are_one(path: AtlasPath, other: AtlasPath) -> bool:
    apart = _apart(path.position(PARTS), other.position(PARTS))
    return apart <= SAME * min(path.length, other.length)


def _apart(points: Array, others: Array) -> float:
    return float(np.linalg.norm(points - others, axis=1).max())
