"""The extent of patches in a direction, and the points that lie farthest."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.bezier import derivatives, evaluate, split
from bodymeasure.errors import InputError

# Halvings of a patch before Newton's method takes over, on a thousandth of the patch.
HALVINGS = 10
# Part of the atlas's size: points whose distances differ by less are equally far. Mirror images
# differ by their rounding.
TIE = 1e-9
# Rectangles at most that may hold the farthest point. A point takes a few dozen; a curve or an area
# takes more.
MOST = 4000
# Newton doubles its digits in each step.
STEPS = 20
# Part of a patch's side. Longer steps leave the rectangle that holds the farthest point.
LONGEST_STEP = 0.01
# Part of the atlas's size up to which sizes are found. Each halving brings control points four
# times as close to the surface: some ten of them are enough.
NEAR = 1e-7
MOST_HALVINGS = 20


class Farthest(NamedTuple):
    """Points that lie farthest, all equally far except for rounding.

    Parameters
    ----------
    points : tuple of AtlasPoint
        It may hold a point several times, once for each patch that it belongs to.
    at_limit : bool
        Whether something that lies as far may be just where the limits of height cut the surface.
    """

    points: tuple[AtlasPoint, ...]
    at_limit: bool


def farthest_on_patches(
    atlas: Atlas,
    patches: Ints,
    direction: Array,
    limits: tuple[float, float] = (-np.inf, np.inf),
) -> Farthest:
    """Return the points of some patches that lie farthest in a direction, between two heights.

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
        The points at which the surface itself turns back. Where a limit cuts the surface off before
        it does, they are not the farthest: see `Farthest.at_limit`.

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
    cells = _candidates(_coordinates(atlas.control_points[patches], along), limits, TIE * size)
    nets = atlas.control_points[patches[cells.row]]
    parameters = _climb(nets, direction, cells.middle)
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
    row: Ints
    middle: Array
    cut: Bools


def _coordinates(control_points: Array, along: Array) -> Array:
    """Two coordinates along directions (3, 2), and the weight they are to be divided by."""
    weight = control_points[..., 3:]
    if not weight.shape[-1]:
        weight = np.ones((*control_points.shape[:-1], 1))
    return np.concatenate([control_points[..., :3] @ along, weight], axis=-1)


def _candidates(nets: Array, limits: tuple[float, float], tie: float) -> _Candidates:
    """Small rectangles that may hold the farthest point between the limits.

    `nets` (k, m + 1, m + 1, 3) has the coordinate that is to be large, the height, and weights.
    """
    row, lower = np.arange(len(nets)), np.zeros((len(nets), 2))
    best, degree = -np.inf, nets.shape[1] - 1
    for depth in range(HALVINGS + 1):
        # Weights are positive, so that the projected control points enclose rational patches, too.
        values = nets[..., :2] / nets[..., 2:]
        low, high = values[..., 1].min(axis=(1, 2)), values[..., 1].max(axis=(1, 2))
        corner = values[:, ::degree, ::degree]
        allowed = (corner[..., 1] >= limits[0]) & (corner[..., 1] <= limits[1])
        if allowed.any():
            best = max(best, float(corner[..., 0][allowed].max()))
        keep = (high >= limits[0]) & (low <= limits[1])
        keep &= values[..., 0].max(axis=(1, 2)) >= best - tie
        nets, row, lower, low, high = (x[keep] for x in (nets, row, lower, low, high))
        if not len(nets):
            raise InputError("no part of these regions lies between the two heights")
        if len(nets) > MOST:
            raise InputError(_FLAT)
        if depth < HALVINGS:
            nets = split(nets).reshape(-1, *nets.shape[1:])
            row = np.repeat(row, 4)
            quarter = 0.5 ** (depth + 1) * np.array([[0, 0], [0, 1], [1, 0], [1, 1]])
            lower = (lower[:, None] + quarter).reshape(-1, 2)
    cut = (low <= limits[0]) | (high >= limits[1])
    return _Candidates(row, lower + 0.5 ** (HALVINGS + 1), cut)


_FLAT = (
    "the surface is flat there across the direction, so that many points are equally far; choose "
    "another rule, or pick the point"
)
# The most distinct points that mirror images give; more of them are a curve or an area.
DISTINCT = 8
# Part of the atlas's size: points closer than that are one. Newton's method ends far below.
SAME = 1e-6


def _refuse_flat(positions: Array, size: float) -> None:
    distinct: list[Array] = []
    for position in positions:
        if all(np.linalg.norm(position - other) > SAME * size for other in distinct):
            distinct.append(position)
        if len(distinct) > DISTINCT:
            raise InputError(_FLAT)


def _climb(nets: Array, direction: Array, start: Array) -> Array:
    """Newton's method for the points of patches farthest in a direction, in the box, from (k, 2).

    As in `bodymeasure.atlas.queries.closest`: coordinates on a bound that the slope presses
    outwards are held. The starts are so close that no step needs to be halved.
    """
    x = start
    for _ in range(STEPS):
        jet = derivatives(nets, x, order=2) @ direction
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


def size_along(atlas: Atlas, directions: Array) -> Array:
    """Return the sizes of the box around an atlas's surface.

    Parameters
    ----------
    atlas : Atlas
    directions : ndarray, shape (k, 3)
        Unit vectors.

    Returns
    -------
    ndarray, shape (k,)
        In the atlas's unit, to a part in ten million. The control points' box is larger.
    """
    nets = atlas.control_points
    tolerance = NEAR * float(np.ptp(atlas.points[atlas.index.ravel()], axis=0).max())
    return np.array(
        [_reach(nets, along, tolerance) + _reach(nets, -along, tolerance) for along in directions]
    )


def _reach(nets: Array, direction: Array, tolerance: float) -> float:
    """Return the greatest coordinate along a direction of patches (k, m + 1, m + 1, 3 or 4).

    Control points enclose their patch, and corners lie on it. Patches whose control points do not
    reach farther than some corner are dropped, and the others are quartered.
    """
    along, weights = nets[..., :3] @ direction, nets[..., 3:]
    parts = np.concatenate([along[..., None], weights], axis=-1)
    best = -np.inf
    for _ in range(MOST_HALVINGS):
        values = parts[..., 0] / parts[..., 1] if weights.shape[-1] else parts[..., 0]
        best = max(best, float(values[:, :: len(values[0]) - 1, :: len(values[0]) - 1].max()))
        parts = parts[values.max(axis=(1, 2)) > best + tolerance]
        if not len(parts):
            break
        parts = split(parts).reshape(-1, *parts.shape[1:])
    return best
