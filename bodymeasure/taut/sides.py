"""The sides of patches, numbered as in `bodymeasure.atlas.EDGES`, and what is beyond them."""

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.seams import EDGES, EdgeTable

# Of each side: the parameter that is fixed on it, and at what.
AXIS = np.array([edge.fixed_axis for edge in EDGES])
VALUE = np.array([edge.fixed_value for edge in EDGES])


def over_sides(table: EdgeTable) -> tuple[Ints, Ints, Bools]:
    """Patch and side over each side (patches, 4), -1 on a boundary, and whether it runs against."""
    to_patch = np.full(table.edge.shape, -1, dtype=np.int64)
    to_side = np.full(table.edge.shape, -1, dtype=np.int64)
    flipped = np.zeros(table.edge.shape, dtype=np.bool_)
    shared = np.flatnonzero(table.sides[table.edge.ravel()] == 2)
    pairs = shared[np.argsort(table.edge.ravel()[shared], kind="stable")].reshape(-1, 2)
    against = table.reversed.ravel()[pairs]
    for one, other in ((0, 1), (1, 0)):
        here, there = np.divmod(pairs[:, one], 4), np.divmod(pairs[:, other], 4)
        to_patch[here], to_side[here] = there
        flipped[here] = against[:, 0] != against[:, 1]
    return to_patch, to_side, flipped


def on_sides(x: Array) -> tuple[Ints, Ints]:
    """Rows and sides of the parameters that lie on sides; a corner lies on two."""
    on = np.stack([x[:, edge.fixed_axis] == edge.fixed_value for edge in EDGES], axis=1)
    row, side = np.nonzero(on)
    return row, side


def entered(x: Array, side: Ints, to_side: Ints, flipped: Bools) -> Array:
    """Parameters of the same points on the patches over their sides."""
    rows = np.arange(len(x))
    along = x[rows, 1 - AXIS[side]]
    result = np.empty_like(x)
    result[rows, AXIS[to_side]] = VALUE[to_side]
    result[rows, 1 - AXIS[to_side]] = np.where(flipped, 1.0 - along, along)
    return result
