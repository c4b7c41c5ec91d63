"""Labels in two columns beside a picture, joined to their points by leaders that do not cross."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools

# Distance of neighboring labels in a column, in heights of a label.
PITCH = 1.3
# Leaders touch rather than cross if twice the area of their overlap is less than this, in squared
# pixels.
TOUCHING = 1e-9


@dataclass(frozen=True, eq=False)
class Columns:
    """The places where labels may stand.

    Parameters
    ----------
    left, right : float
        Inner edges of the two columns, in pixels: labels end at `left`, or begin at `right`.
    top, bottom : float
        Ends of both columns.
    label_height : float
        The height of labels, if there is room for it.
    """

    left: float
    right: float
    top: float
    bottom: float
    label_height: float


@dataclass(frozen=True, eq=False)
class Layout:
    """The places where labels stand.

    Parameters
    ----------
    on_right : ndarray of bool, shape (n,)
        Whether a label stands in the right column.
    anchor : ndarray, shape (n, 2)
        The point that it labels, at which its leader ends.
    y : ndarray, shape (n,)
        The middle of the label.
    label_height : float
        The height that was asked for, or less if the columns would not hold the labels.
    """

    on_right: Bools
    anchor: Array
    y: Array
    label_height: float


def place_labels(leftmost: Array, rightmost: Array, columns: Columns) -> Layout:
    """Place labels in two columns.

    Parameters
    ----------
    leftmost, rightmost : ndarray, shape (n, 2)
        Two points of each thing labeled, in pixels from the top left, at which a leader from the
        left and one from the right would end. They lie between the columns, and the first is not
        to the right of the second.
    columns : Columns

    Returns
    -------
    Layout
        Labels of a column are at least a label's height apart, and leaders, which run straight from
        the column's inner edge at the label's middle to the anchor, do not cross.

    Notes
    -----
    All things labeled from the left have their anchors to the left of a vertical line, the others
    to the right of it, which keeps the columns' leaders apart. In a column, places are as near to
    the anchors' heights as their distance allows. The labels of two leaders that cross change
    places; that shortens the leaders, so that it comes to an end.
    """
    count = len(leftmost)
    on_right = _sides(leftmost, rightmost)
    anchor = np.where(on_right[:, None], rightmost, leftmost)
    fullest = max(int(on_right.sum()), int(count - on_right.sum()), 1)
    room = (columns.bottom - columns.top) / fullest
    height = min(columns.label_height, room / PITCH)
    y = np.empty(count)
    for side, edge in ((False, columns.left), (True, columns.right)):
        rows = np.flatnonzero(on_right == side)
        rows = rows[np.argsort(anchor[rows, 1], kind="stable")]
        places = _spread(anchor[rows, 1], columns, PITCH * height)
        y[rows] = _uncrossed(anchor[rows], edge, places)
    return Layout(on_right, anchor, y, height)


def _sides(leftmost: Array, rightmost: Array) -> Bools:
    """Choose the things that are labeled from the right, if possible as many as from the left.

    In the order of their middles, those on the left must end before those on the right begin.
    """
    count = len(leftmost)
    order = np.argsort(leftmost[:, 0] + rightmost[:, 0], kind="stable")
    left_end = np.maximum.accumulate(np.append(-np.inf, leftmost[order, 0]))
    right_start = np.minimum.accumulate(np.append(np.inf, rightmost[order, 0][::-1]))[::-1]
    cuts = np.flatnonzero(left_end <= right_start)
    cut = cuts[np.argmin(np.abs(2 * cuts - count))]
    on_right = np.zeros(count, dtype=np.bool_)
    on_right[order[cut:]] = True
    return on_right


def _spread(wanted: Array, columns: Columns, pitch: float) -> Array:
    """Return the places nearest to some wanted ones, in their order, at least a pitch apart.

    Pooling neighbors that are too near to one another minimizes the squared distances.
    """
    count = len(wanted)
    offset = pitch * np.arange(count)
    pools: list[tuple[float, int]] = []
    for value in wanted - offset:
        mean, size = float(value), 1
        while pools and pools[-1][0] > mean:
            before, length = pools.pop()
            mean = (mean * size + before * length) / (size + length)
            size += length
        pools.append((mean, size))
    level = np.repeat([mean for mean, _ in pools], [size for _, size in pools])
    first = columns.top + pitch / 2
    last = max(columns.bottom - pitch / 2 - pitch * (count - 1), first)
    return np.asarray(np.clip(level, first, last) + offset)


def _uncrossed(anchors: Array, edge: float, places: Array) -> Array:
    """Exchange the places (n,) of anchors (n, 2) until no two leaders cross."""
    y = places.copy()
    while True:
        # The side of leader i on which the ends of leader j lie, at the column and at the anchor.
        along = anchors - np.stack([np.full(len(y), edge), y], axis=1)
        place = y[None, :] - y[:, None]
        anchor = anchors[None, :] - anchors[:, None]
        at_column = along[:, None, 0] * place
        at_anchor = along[:, None, 0] * anchor[..., 1] - along[:, None, 1] * anchor[..., 0]
        apart = (at_column * at_anchor < 0.0) & (np.abs(at_anchor) > TOUCHING)
        crossing = np.argwhere(apart & apart.T)
        if len(crossing) == 0:
            return y
        first, second = crossing[0]
        y[[first, second]] = y[[second, first]]
