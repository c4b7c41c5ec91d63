"""Labels in two columns beside a picture, joined to their points by leaders that do not cross."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools

# Distance of neighbouring labels in a column, in heights of a label.
PITCH = 1.3
# Leaders that touch rather than cross: twice the area, in squared pixels, of what they overlap by.
TOUCHING = 1e-9


@dataclass(frozen=True, eq=False)
class Columns:
    """Where labels may stand.

    Parameters
    ----------
    left, right : float
        Inner edges of the two columns, in pixels: labels end at `left`, or begin at `right`.
    top, bottom : float
        Ends of both columns.
    label_height : float
        The labels', if there is room for it.
    """

    left: float
    right: float
    top: float
    bottom: float
    label_height: float


@dataclass(frozen=True, eq=False)
class Layout:
    """Where labels stand.

    Parameters
    ----------
    on_right : ndarray of bool, shape (n,)
        Whether a label stands in the right column.
    anchor : ndarray, shape (n, 2)
        Where its leader ends: the point that it labels.
    y : ndarray, shape (n,)
        The middle of the label.
    label_height : float
        At most what was asked for; less if the columns hold no more.
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
        Two points of each thing labeled, in pixels from the top left: where a leader from the
        left, and one from the right, would end. Between the columns; the first is not to the right
        of the second.
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
    the anchors' heights as their distance allows. Of two leaders that cross, the labels change
    places: that shortens the leaders, so that it comes to an end.
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
    """Which things are labeled from the right: as many as from the left, if that can be had.

    They are taken in the order of their middles, and the others must end before they begin.
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
    """The places nearest to some wanted ones, in their order, at least a pitch apart.

    By pooling neighbours that are too near to one another: the least squares of the distances.
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
    """Places (n,) for anchors (n, 2), changed among them until no two leaders cross."""
    y = places.copy()
    while True:
        # Where leader j's ends lie from leader i: right of it at the column, left at the anchor.
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
