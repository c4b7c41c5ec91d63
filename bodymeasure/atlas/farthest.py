"""The points of patches, or of their open edges, that lie farthest in a direction."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES, edge_table
from bodymeasure.bezier import derivatives, evaluate, split
from bodymeasure.errors import InputError

# Halvings of a patch before Newton's method takes over, on a thousandth of the patch.
HALVINGS = 10
# Of the atlas's size: what lies farther by less is as far. Mirror images differ by their rounding.
TIE = 1e-9
# Rectangles that may hold the farthest point. It takes a few dozen; more where it is no point.
MOST = 4000
# Newton doubles its digits in each step.
STEPS = 20
# Of a patch's side. Steps that are longer leave the rectangle that holds the farthest point.
LONGEST_STEP = 0.01


class Farthest(NamedTuple):
    """Points that lie farthest, all equally far but for rounding.

    Parameters
    ----------
    points : tuple of AtlasPoint
        May hold a point several times, from each patch that it belongs to.
    at_limit : bool
        Whether something that lies as far may be just where the limits of height cut the surface.
    """

    points: tuple[AtlasPoint, ...]
    at_limit: bool


def farthest_on_patches(
    atlas: Atlas,
    patches: NDArray[np.int64],
    direction: NDArray[np.float64],
    limits: tuple[float, float] = (-np.inf, np.inf),
) -> Farthest:
    """Points of some patches that lie farthest in a direction, between two heights.

    Parameters
    ----------
    atlas : Atlas
    patches : ndarray of int, shape (k,)
    direction : ndarray, shape (3,)
        A unit vector.
    limits : tuple of float
        Lowest and highest coordinate along the atlas's way up.

    Returns
    -------
    Farthest
        Of the points at which the surface itself turns back. Where a limit cuts the surface off
        before it does, they are not the farthest: see `Farthest.at_limit`.

    Raises
    ------
    InputError
        If nothing lies between the heights, or whole curves or areas are equally far.

    Notes
    -----
    Bernstein coefficients bound a rectangle's coordinates. Those that cannot hold the farthest
    point are dropped and the others quartered; Newton's method in the box ``[0, 1]^2`` does the
    rest.
    """
    size = float(np.ptp(atlas.points, axis=0).max())
    along = np.stack([direction, atlas.axes.up_vector], axis=-1)
    cells = _candidates(atlas.control_points[patches] @ along, limits, TIE * size)
    nets = atlas.control_points[patches[cells.row]]
    parameters = _climb(nets @ direction, cells.middle)
    position = evaluate(nets, parameters)
    height = position @ atlas.axes.up_vector
    inside = (height >= limits[0] - TIE * size) & (height <= limits[1] + TIE * size)
    at_limit = bool(cells.cut.any())
    if not inside.any():
        return Farthest((), at_limit)
    far = np.where(inside, position @ direction, -np.inf)
    best = np.flatnonzero(far >= far.max() - TIE * size)
    _refuse_flat(position[best], size)
    points = [
        AtlasPoint(int(patches[cells.row[k]]), *np.asarray(parameters[k]).tolist()) for k in best
    ]
    return Farthest(tuple(dict.fromkeys(points)), at_limit)


class _Candidates(NamedTuple):
    row: NDArray[np.int64]
    middle: NDArray[np.float64]
    cut: NDArray[np.bool_]


def _candidates(nets: NDArray[np.float64], limits: tuple[float, float], tie: float) -> _Candidates:
    """Small rectangles that may hold the farthest point between the limits.

    `nets` (k, 4, 4, 2) has the coordinate that is to be large, and the height.
    """
    row, lower = np.arange(len(nets)), np.zeros((len(nets), 2))
    best = -np.inf
    for depth in range(HALVINGS + 1):
        low, high = nets[..., 1].min(axis=(1, 2)), nets[..., 1].max(axis=(1, 2))
        corner = nets[:, ::3, ::3]
        allowed = (corner[..., 1] >= limits[0]) & (corner[..., 1] <= limits[1])
        if allowed.any():
            best = max(best, float(corner[..., 0][allowed].max()))
        keep = (high >= limits[0]) & (low <= limits[1])
        keep &= nets[..., 0].max(axis=(1, 2)) >= best - tie
        nets, row, lower, low, high = (x[keep] for x in (nets, row, lower, low, high))
        if not len(nets):
            raise InputError("no part of these regions lies between the two heights")
        if len(nets) > MOST:
            raise InputError(_FLAT)
        if depth < HALVINGS:
            nets = split(nets).reshape(-1, 4, 4, 2)
            row = np.repeat(row, 4)
            quarter = 0.5 ** (depth + 1) * np.array([[0, 0], [0, 1], [1, 0], [1, 1]])
            lower = (lower[:, None] + quarter).reshape(-1, 2)
    cut = (low <= limits[0]) | (high >= limits[1])
    return _Candidates(row, lower + 0.5 ** (HALVINGS + 1), cut)


_FLAT = (
    "the surface is flat there across the direction, so that many points are equally far; choose "
    "another rule, or pick the point"
)
# Points more than which are no mirror images of one another, but a curve or an area.
DISTINCT = 8
# Of the atlas's size: points closer than that are one. Newton's method ends far below.
SAME = 1e-6


def _refuse_flat(positions: NDArray[np.float64], size: float) -> None:
    distinct: list[NDArray[np.float64]] = []
    for position in positions:
        if all(np.linalg.norm(position - other) > SAME * size for other in distinct):
            distinct.append(position)
        if len(distinct) > DISTINCT:
            raise InputError(_FLAT)


def _climb(nets: NDArray[np.float64], start: NDArray[np.float64]) -> NDArray[np.float64]:
    """Newton's method for the maximum of scalar patches (k, 4, 4) in the box, from (k, 2).

    As in `bodymeasure.atlas.closest`: coordinates on a bound that the slope presses outwards are
    held. The starts are so close that no step needs to be halved.
    """
    x = start
    for _ in range(STEPS):
        jet = derivatives(nets[..., None], x, order=2)[..., 0]
        slope = np.stack([jet[:, 1, 0], jet[:, 0, 1]], axis=-1)
        held = ((x <= 0.0) & (slope < 0.0)) | ((x >= 1.0) & (slope > 0.0))
        slope = np.where(held, 0.0, slope)
        bend = np.stack([jet[:, 2, 0], jet[:, 1, 1], jet[:, 1, 1], jet[:, 0, 2]], axis=-1)
        either = held[:, :, None] | held[:, None, :]
        hessian = np.where(either, -np.eye(2), bend.reshape(-1, 2, 2))
        determinant = hessian[:, 0, 0] * hessian[:, 1, 1] - hessian[:, 0, 1] ** 2
        concave = (hessian[:, 0, 0] < 0.0) & (determinant > 0.0)
        hessian = np.where(concave[:, None, None], hessian, -np.eye(2))
        newton = -np.linalg.solve(hessian, slope[..., None])[..., 0]
        steepest = np.abs(slope).max(axis=1, keepdims=True)
        uphill = LONGEST_STEP * slope / np.where(steepest > 0.0, steepest, 1.0)
        step = np.where(concave[:, None], newton, uphill)
        x = np.clip(x + np.clip(step, -LONGEST_STEP, LONGEST_STEP), 0.0, 1.0)
    return x


def farthest_on_boundary(
    atlas: Atlas, patches: NDArray[np.int64], direction: NDArray[np.float64]
) -> Farthest:
    """Points of the open edges of some patches that lie farthest in a direction.

    Parameters
    ----------
    atlas : Atlas
    patches : ndarray of int, shape (k,)
    direction : ndarray, shape (3,)
        A unit vector.

    Raises
    ------
    InputError
        If these patches have no open edge, or many points are equally far.
    """
    table = edge_table(atlas.index)
    control = table.control_index[patches]
    is_open = (table.sides[table.edge[patches]] == 1) & (control != control[:, :, :1]).any(axis=2)
    if not is_open.any():
        raise InputError("the atlas has no open boundary in these regions; choose others")
    row, side = np.nonzero(is_open)
    size = float(np.ptp(atlas.points, axis=0).max())
    cubics = atlas.points[control[row, side]] @ direction
    along = _turning_points(cubics)
    edge, number = np.nonzero(np.isfinite(along))
    along = along[edge, number]
    fixed = np.array([e.fixed_value for e in EDGES])[side[edge]]
    over_v = np.array([e.fixed_axis for e in EDGES])[side[edge]] == 0
    parameters = np.where(
        over_v[:, None], np.stack([fixed, along], axis=-1), np.stack([along, fixed], axis=-1)
    )
    patch = patches[row[edge]]
    position = evaluate(atlas.control_points[patch], parameters)
    far = position @ direction
    best = np.flatnonzero(far >= far.max() - TIE * size)
    if (cubics.min(axis=1) >= far.max() - TIE * size).any():
        raise InputError(_FLAT)
    points = [AtlasPoint(int(patch[k]), *parameters[k].tolist()) for k in best]
    return Farthest(tuple(dict.fromkeys(points)), at_limit=False)


def _turning_points(cubics: NDArray[np.float64]) -> NDArray[np.float64]:
    """Ends of [0, 1] and roots of the slopes of cubics (k, 4), shape (k, 4); NaN where none is."""
    first, second, third = np.diff(cubics, axis=1).T
    # The slope is a t^2 + 2 b t + c; its roots without cancellation.
    a, b, c = first - 2.0 * second + third, second - first, first
    root = np.sqrt(np.maximum(b * b - a * c, 0.0))
    q = -(b + np.where(b < 0.0, -root, root))
    roots = np.stack([_ratio(q, a), _ratio(c, q)], axis=1)
    roots[(roots < 0.0) | (roots > 1.0)] = np.nan
    ends = np.broadcast_to([0.0, 1.0], (len(cubics), 2))
    return np.concatenate([ends, roots], axis=1)


def _ratio(top: NDArray[np.float64], bottom: NDArray[np.float64]) -> NDArray[np.float64]:
    with np.errstate(over="ignore"):
        return np.divide(top, bottom, out=np.full_like(top, np.nan), where=bottom != 0.0)
