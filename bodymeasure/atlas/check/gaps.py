"""Edges that nearly meet: seams with a gap, seams not joined by index, T-junctions."""

from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.check.degeneracy import SAME_PLACE
from bodymeasure.atlas.seams import edge_table, sides_of
from bodymeasure.atlas.topology.components import connected_components
from bodymeasure.bezier import bernstein, project

# Two free edges were meant to be one seam if they run this close together, as a part of the shorter
# edge's length and of the patches' width across it (9 mm at an edge of 9 cm). The width
# distinguishes the two long sides of a narrow strip, which are as far apart as the strip is wide,
# from two sides of a seam.
NEAR = 0.1
# An end touches an edge if it lies this close to it, as a part of the edge's length; an end that is
# meant to touch lies far closer.
TOUCHES = 0.01
# The parameters at which two edges are compared: cubics that agree at four agree everywhere, and
# curves of higher degrees nearly so.
_ALONG = np.linspace(0.0, 1.0, 9)
# Segments of an edge when a point's distance to it is taken; on a quarter circle their error is
# 2e-4 of its length, well under TOUCHES.
_SEGMENTS = 32
# Segments of a rational edge that is compared, whose points may crowd at one end.
_FINE = 512
# The number of pairs whose distance is taken at once, which bounds the memory where edges crowd.
_BLOCK = 10_000
# The number of products of a search through all pairs that takes less time than SciPy's import.
_MANY = 1_000_000
# The number of free edges that are considered near each one; no atlas has more at one place.
_NEIGHBORS = 8


class FreeEdges(NamedTuple):
    """Sides of patches that no other patch shares.

    Parameters
    ----------
    patch, side : ndarray of int, shape (edges,)
        The patch and the side of each edge; sides are in the order of `EDGES`.
    control_index : ndarray of int, shape (edges, degree + 1)
    control_points : ndarray, shape (edges, degree + 1, 3)
        Those of rational patches have their weights: (edges, degree + 1, 4).
    length, width : ndarray, shape (edges,)
        Length of the control polygon, and width of the patch across the side.
    """

    patch: Ints
    side: Ints
    control_index: Ints
    control_points: Array
    length: Array
    width: Array


class NearSeams(NamedTuple):
    """Pairs of free edges that run close together.

    Parameters
    ----------
    first, second : ndarray of int, shape (pairs,)
        Numbers of the free edges.
    distance : ndarray, shape (pairs,)
        Largest distance of points at equal parameters.
    coincide : ndarray of bool, shape (pairs,)
        Whether they differ by no more than rounding.
    turned : ndarray of bool, shape (pairs,)
        Whether the second runs against the first.
    """

    first: Ints
    second: Ints
    distance: Array
    coincide: Bools
    turned: Bools


def free_edges(
    control_points: Array,
    index: Ints,
    collapsed: Bools,
) -> FreeEdges:
    """Return the sides with one patch only, without the `collapsed` ones (patches, 4)."""
    table = edge_table(index)
    patch, side = np.nonzero((table.sides[table.edge] == 1) & ~collapsed)
    points = sides_of(control_points)[patch, side]
    in_space = project(control_points)
    steps = np.linalg.norm(np.diff(in_space, axis=1), axis=-1).sum(axis=1)
    steps_v = np.linalg.norm(np.diff(in_space, axis=2), axis=-1).sum(axis=2)
    # Sides 0 and 1 run with v, so that u leads across the patch; the median of the lines across.
    width = np.where(side < 2, np.median(steps, axis=1)[patch], np.median(steps_v, axis=1)[patch])
    length = np.linalg.norm(np.diff(project(points), axis=1), axis=-1).sum(axis=1)
    return FreeEdges(patch, side, table.control_index[patch, side], points, length, width)


def near_seams(edges: FreeEdges) -> NearSeams:
    """Return the pairs of free edges that run close together along their whole length."""
    first, second = _neighbors(edges)
    curves = _compared_points(edges.control_points, _ALONG)
    reach = NEAR * np.minimum(edges.length, edges.width)
    tolerance = np.minimum(reach[first], reach[second])

    def largest(points: Array, other: Array) -> Array:
        return np.asarray(np.linalg.norm(points - other, axis=-1).max(axis=-1))

    forwards = largest(curves[first], curves[second])
    backwards = largest(curves[first], curves[second, ::-1])
    turned = backwards < forwards
    distance = np.where(turned, backwards, forwards)
    # With weights that differ, a curve runs through the same points at other parameters.
    net = project(edges.control_points)
    other = np.where(turned[:, None, None], net[second, ::-1], net[second])
    coincide = largest(net[first], other) <= SAME_PLACE * edges.length[first]
    near = distance <= tolerance
    return NearSeams(first[near], second[near], distance[near], coincide[near], turned[near])


def _neighbors(edges: FreeEdges) -> tuple[Ints, Ints]:
    """Pairs of free edges whose middles are near each other, each pair once."""
    count = len(edges.patch)
    none = np.empty(0, dtype=np.int64)
    if count < 2:
        return none, none
    middles = _compared_points(edges.control_points, np.array([0.5]))[:, 0]
    reach = NEAR * np.minimum(edges.length, edges.width)
    most = float(reach.max()) * (1 + 1e-12)
    distance, found = _nearest(middles, middles, min(_NEIGHBORS, count))
    found = np.where(distance < most, found, count)
    first = np.repeat(np.arange(count), found.shape[1])
    second = found.ravel()
    pairs = np.stack([first, second], axis=1)[(second < count) & (second != first)]
    pairs = np.unique(np.sort(pairs, axis=1), axis=0)
    return pairs[:, 0], pairs[:, 1]


def _nearest(points: Array, places: Array, count: int) -> tuple[Array, Ints]:
    """The distances and numbers of the points nearest to places, shape (..., 3): the nearest first.

    Atlases have few free edges, for which SciPy, whose import takes a tenth of a second, need not
    be loaded.
    """
    if len(points) * places.size > _MANY:
        distance, found = scipy.spatial.KDTree(points).query(places, k=[*range(1, count + 1)])
        return distance, found
    steps = places[..., None, :] - points
    every = np.sqrt(np.einsum("...c,...c->...", steps, steps))
    found = np.argsort(every, axis=-1, kind="stable")[..., :count]
    return np.take_along_axis(every, found, axis=-1), found


def welded_index(index: Ints, edges: FreeEdges, seams: NearSeams) -> Ints:
    """Return the index as it would be if edges that coincide were joined."""
    forwards = edges.control_index
    first = forwards[seams.first[seams.coincide]]
    second = forwards[seams.second[seams.coincide]]
    second = np.where(seams.turned[seams.coincide, None], second[:, ::-1], second)
    count = int(index.max()) + 1
    return connected_components(first.ravel(), second.ravel(), count)[index]


def t_junctions(edges: FreeEdges) -> tuple[Ints, Ints]:
    """Return the ends of free edges that lie inside another free edge.

    Returns
    -------
    edge, other : ndarray of int, shape (junctions,)
        The free edge that is touched, and one whose end touches it.
    """
    none = np.empty(0, dtype=np.int64)
    if len(edges.patch) < 2:
        return none, none
    vertices, where = np.unique(edges.control_index[:, [0, -1]].ravel(), return_index=True)
    owner, positions = where // 2, project(edges.control_points[:, [0, -1]]).reshape(-1, 3)[where]
    # An end inside an edge is nearer to one of eight points along it than the edge's own ends are.
    along = np.arange(1, 8) / 8
    samples = _points(edges.control_points, along)
    distance, nearest = _nearest(positions, samples, min(3, len(positions)))
    edge = np.broadcast_to(np.arange(len(samples))[:, None, None], distance.shape)
    # Curves are shorter than their control polygons, but their speed varies: hence 1/8, not 1/16.
    near = distance <= (1 / 8 + TOUCHES) * edges.length[edge]
    edge, vertex = np.unique(np.stack([edge[near], nearest[near]], axis=1), axis=0).T
    own = (vertices[vertex, None] == edges.control_index[edge][:, [0, -1]]).any(axis=1)
    edge, vertex = edge[~own], vertex[~own]
    separation = np.concatenate(
        [
            _distance_inside(edges.control_points[edge[block]], positions[vertex[block]])
            for block in np.array_split(np.arange(len(edge)), 1 + len(edge) // _BLOCK)
        ]
    )
    touching = separation <= TOUCHES * np.minimum(edges.length, edges.width)[edge]
    return edge[touching], owner[vertex[touching]]


def _distance_inside(curves: Array, points: Array) -> Array:
    """Distance of points (n, 3) from curves (n, k, 3 or 4), infinite where an end is nearest."""
    polyline = _points(curves, np.linspace(0.0, 1.0, _SEGMENTS + 1))
    start, step = polyline[:, :-1], np.diff(polyline, axis=1)
    squared = np.einsum("nsc,nsc->ns", step, step)
    along = np.einsum("nsc,nsc->ns", points[:, None] - start, step)
    along = np.clip(along / np.where(squared > 0.0, squared, 1.0), 0.0, 1.0)
    foot = start + along[..., None] * step
    distance = np.linalg.norm(points[:, None] - foot, axis=-1)
    nearest = distance.argmin(axis=1)
    row = np.arange(len(points))
    # Within a segment of an end, two edges merely share a corner that is not joined.
    at_end = (nearest == 0) | (nearest == _SEGMENTS - 1)
    return np.where(at_end, np.inf, distance[row, nearest])


def _points(curves: Array, t: Array) -> Array:
    """Points (n, len(t), 3) of curves with control points (n, k, 3 or 4)."""
    return project(bernstein(curves.shape[1] - 1, t)[:, 0] @ curves)


def _compared_points(curves: Array, t: Array) -> Array:
    """Return the points at which edges are compared: at t, or at parts t of a rational length.

    With different weights, one curve may be run along at many speeds.
    """
    if curves.shape[-1] == 3:
        return _points(curves, t)
    fine = _points(curves, np.linspace(0.0, 1.0, _FINE + 1))
    steps = np.linalg.norm(np.diff(fine, axis=1), axis=-1)
    way = np.concatenate([np.zeros((len(fine), 1)), np.cumsum(steps, axis=1)], axis=1)
    at = np.arange(_FINE + 1, dtype=np.float64)
    place = np.stack([np.interp(t * w[-1], w, at) for w in way]) if len(way) else way[:, : len(t)]
    before = np.minimum(place.astype(np.int64), _FINE - 1)
    rest = (place - before)[..., None]
    row = np.arange(len(fine))[:, None]
    return np.asarray((1.0 - rest) * fine[row, before] + rest * fine[row, before + 1])
