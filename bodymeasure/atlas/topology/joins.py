"""The joints of patches: their number on each edge, the sides that they face, and their angles."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.normals import normal_vectors
from bodymeasure.atlas.seams import AXIS, VALUE, EdgeTable
from bodymeasure.atlas.topology.components import connected_components

# Points along a seam at which the normals of both sides are compared, with its ends.
_ALONG = np.linspace(0.0, 1.0, 9)
# Seams treated at once, which bounds the memory: a seam takes some 10 kB.
_BLOCK = 4096
# Part of the longest normal along a side: shorter normals are rounding, as at a sphere's pole.
NO_NORMAL = 1e-9
# The way round a patch that has the patch on its left runs with u along v = 0 and with v along
# u = 1, and against them along v = 1 and u = 0. The sides are in the order of EDGES.
_WITH_THE_ROUND = np.array([False, True, True, False])


def round_of_side(side: Ints) -> Bools:
    """Return whether sides, numbered as in `EDGES`, run so that the patch is on their left."""
    return _WITH_THE_ROUND[side]


class Seams(NamedTuple):
    """Edges that two patches share.

    Parameters
    ----------
    patch, side : ndarray of int, shape (seams, 2)
        Both sides of each seam; sides in the order of `EDGES`.
    against : ndarray of bool, shape (seams,)
        Whether the second side runs against the first.
    consistent : ndarray of bool, shape (seams,)
        Whether both patches face the same way.
    """

    patch: Ints
    side: Ints
    against: Bools
    consistent: Bools


def seams_of(table: EdgeTable, collapsed: Bools) -> Seams:
    """Return the edges that two sides share, without the `collapsed` sides (patches, 4)."""
    # An edge is left out if one of its sides belongs to a patch without area.
    single = np.zeros(len(table.sides), dtype=np.bool_)
    single[table.edge[collapsed]] = True
    shared = np.flatnonzero((table.sides[table.edge] == 2) & ~single[table.edge])
    order = np.argsort(table.edge.ravel()[shared], kind="stable")
    pairs = shared[order].reshape(-1, 2)
    patch, side = np.divmod(pairs, 4)
    turned = table.reversed.ravel()[pairs]
    ahead = _WITH_THE_ROUND[side] ^ turned
    return Seams(patch, side, turned[:, 0] != turned[:, 1], ahead[:, 0] != ahead[:, 1])


def turned_patches(seams: Seams, count: int) -> tuple[Ints, list[Ints]]:
    """Return the patches that face against the others of their part.

    Returns
    -------
    turned : ndarray of int
        The patches to turn round, which are the smaller number of each part.
    one_sided : list of ndarray of int
        Parts that cannot be made to face one way, such as a Moebius band.

    Notes
    -----
    The atlas's double cover has a node for each patch and each way it may face. There, a part with
    two sides falls in two, and a part with one side does not.
    """
    first, second = seams.patch.T
    other = np.where(seams.consistent, 0, count)
    rows = np.concatenate([first, first + count])
    columns = np.concatenate([second + other, second + count - other])
    label = connected_components(rows, columns, 2 * count)
    as_is, flipped = label[:count], label[count:]
    part = np.minimum(as_is, flipped)
    one_sided = np.unique(part[as_is == flipped])
    size, kept = np.bincount(part), np.bincount(part, weights=as_is == part)
    # Keep the way that most patches of the part face.
    keep_low = 2 * kept >= size
    turned = (as_is == part) != keep_low[part]
    return (
        np.flatnonzero(turned & (as_is != flipped)),
        [np.flatnonzero(part == number) for number in one_sided],
    )


def parts(seams: Seams, count: int) -> Ints:
    """Return the number of the connected part of each patch, shape (patches,)."""
    first, second = seams.patch.T
    return connected_components(first, second, count)


def kink_angles(control_points: Array, seams: Seams) -> Array:
    """Return the largest angle in degrees by which the normal jumps across each seam.

    Its shape is (seams,); it is zero where either side has no normal.
    """
    angles = np.empty(len(seams.patch))
    for first in range(0, len(angles), _BLOCK):
        block = slice(first, first + _BLOCK)
        part = Seams(
            seams.patch[block], seams.side[block], seams.against[block], seams.consistent[block]
        )
        angles[block] = _kink_angles(control_points, part)
    return angles


def _kink_angles(control_points: Array, seams: Seams) -> Array:
    patch = seams.patch
    nets = control_points[patch]
    parameters = np.empty((*patch.shape, len(_ALONG), 2))
    fixed_axis, fixed_value = AXIS[seams.side], VALUE[seams.side]
    along = np.broadcast_to(_ALONG, parameters.shape[:-1]).copy()
    along[seams.against, 1] = _ALONG[::-1]
    across = np.broadcast_to(fixed_value[..., None], along.shape)
    parameters[..., 0] = np.where(fixed_axis[..., None] == 0, across, along)
    parameters[..., 1] = np.where(fixed_axis[..., None] == 0, along, across)
    normals = normal_vectors(nets, parameters)
    size = np.linalg.norm(normals, axis=-1, keepdims=True)
    normals[(size <= NO_NORMAL * size.max(axis=-2, keepdims=True))[..., 0]] = 0.0
    normals[~seams.consistent, 1] *= -1.0
    left, right = normals[:, 0], normals[:, 1]
    sine = np.linalg.norm(np.cross(left, right), axis=-1)
    cosine = np.einsum("skc,skc->sk", left, right)
    # Where one side has no normal, both are zero, and so is the angle.
    return np.asarray(np.degrees(np.arctan2(sine, cosine)).max(axis=-1, initial=0.0))


def over_sides(table: EdgeTable) -> tuple[Ints, Ints, Bools]:
    """Return the patch and the side over each side, and whether that side runs against it.

    All have the shape (patches, 4); patch and side are -1 on a boundary.
    """
    to_patch = np.full(table.edge.shape, -1, dtype=np.int64)
    to_side = np.full(table.edge.shape, -1, dtype=np.int64)
    flipped = np.zeros(table.edge.shape, dtype=np.bool_)
    seams = seams_of(table, np.zeros(table.edge.shape, dtype=np.bool_))
    for one, other in ((0, 1), (1, 0)):
        here = seams.patch[:, one], seams.side[:, one]
        to_patch[here], to_side[here] = seams.patch[:, other], seams.side[:, other]
        flipped[here] = seams.against
    return to_patch, to_side, flipped


def on_sides(x: Array) -> tuple[Ints, Ints]:
    """Return the rows of x (k, 2) that lie on sides, and the sides; a corner lies on two."""
    row, side = np.nonzero(x[:, AXIS] == VALUE)
    return row, side


def entered(x: Array, side: Ints, to_side: Ints, flipped: Bools) -> Array:
    """Return the parameters of points on sides, on the patches over those sides."""
    rows = np.arange(len(x))
    along = x[rows, 1 - AXIS[side]]
    result = np.empty_like(x)
    result[rows, AXIS[to_side]] = VALUE[to_side]
    result[rows, 1 - AXIS[to_side]] = np.where(flipped, 1.0 - along, along)
    return result
