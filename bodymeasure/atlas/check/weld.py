"""Welding: patches that are given without topology are joined where their edges coincide."""

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.check.degeneracy import collapsed_sides
from bodymeasure.atlas.check.gaps import free_edges, near_seams, welded_index
from bodymeasure.atlas.seams import EdgeTable, edge_table, sides_of, weights_differ
from bodymeasure.atlas.size import require_size
from bodymeasure.atlas.topology.components import connected_components


def weld(
    control_points: Array, tolerance: float | None = None, *, weights: Array | None = None
) -> tuple[Array, Ints]:
    """Join patches along edges that coincide, in either direction.

    Parameters
    ----------
    control_points : ndarray, shape (patches, degree + 1, degree + 1, 3)
        Finite positions in space; those of rational patches come without their weights.
    tolerance : float, optional
        Edges that run no farther apart than this are joined too, if that is little beside their
        length and their patches' width (`gaps.NEAR`). Without it, edges are joined whose control
        points differ by no more than rounding (`degeneracy.SAME_PLACE` of the edge's length).
    weights : ndarray, shape (patches, degree + 1, degree + 1), optional
        The weights of rational patches. Edges along which they are not proportional are not joined:
        their points at equal parameters differ.

    Returns
    -------
    points : ndarray, shape (n, 3)
        Control points that are joined are at the place of the first of them.
    index : ndarray of int, shape (patches, degree + 1, degree + 1)

    Raises
    ------
    InputError
        If the patches are so large or so small that their areas are no numbers.

    Notes
    -----
    The control points of an edge that is a single point become one. T-junctions and wider gaps stay
    as they are: `check_atlas` reports them.
    """
    require_size(control_points.reshape(-1, 3))
    shape = control_points.shape[:-1]
    own = np.arange(control_points[..., 0].size, dtype=np.int64).reshape(shape)
    places = same_places(control_points.reshape(-1, 3)).reshape(own.shape)
    collapsed = collapsed_sides(control_points)
    # Nearly always the coordinates are the same to the last bit; only the rest needs a tolerance.
    along = sides_of(np.ones(shape) if weights is None else weights)
    index = _join_same(own, edge_table(places), collapsed, along)
    free = free_edges(control_points, places, collapsed)
    numbers = edge_table(index).control_index[free.patch, free.side]
    near = near_seams(free)
    if tolerance is not None:
        near = near._replace(coincide=near.coincide | (near.distance <= tolerance))
    first, second = (along[free.patch, free.side][pair] for pair in (near.first, near.second))
    second = np.where(near.turned[:, None], second[:, ::-1], second)
    near = near._replace(coincide=near.coincide & ~weights_differ(first, second))
    index = welded_index(index, free._replace(control_index=numbers), near)
    _, first, index = np.unique(index, return_index=True, return_inverse=True)
    # Points are numbered in the order in which patches first name them.
    rank = np.empty_like(first)
    rank[np.argsort(first)] = np.arange(len(first))
    return control_points.reshape(-1, 3)[np.sort(first)], rank[index].reshape(own.shape)


def same_places(points: Array) -> Ints:
    """Number points (n, 3) so that those with the same coordinates have the same number."""
    number = np.zeros(len(points), dtype=np.int64)
    for axis in range(points.shape[1]):
        values, rank = np.unique(points[:, axis], return_inverse=True)
        _, number = np.unique(number * len(values) + rank, return_inverse=True)
    return number


def _join_same(own: Ints, table: EdgeTable, collapsed: Bools, weights: Array) -> Ints:
    """Return the index with sides on one edge joined, and collapsed sides made one point."""
    rows = edge_table(own).control_index.reshape(-1, own.shape[-1])
    backwards = table.reversed.reshape(-1, 1)
    along = np.where(backwards, rows[:, ::-1], rows)
    _, first = np.unique(table.edge.ravel(), return_index=True)
    leads = first[table.edge.ravel()]
    weights = weights.reshape(-1, own.shape[-1])
    weights = np.where(backwards, weights[:, ::-1], weights)
    apart = weights_differ(weights, weights[leads])
    leader = np.where(apart[:, None], along, along[leads])
    # A collapsed side is no edge that could be shared, but its ends are shared with other sides.
    leader = np.where(collapsed.reshape(-1, 1), along[:, :1], leader)
    return connected_components(leader.ravel(), along.ravel(), own.size)[own]
