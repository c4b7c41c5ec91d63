"""The point of an atlas that is closest to a given position."""

import numpy as np
import scipy
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.bezier import derivatives, evaluate, project
from bodymeasure.errors import InputError

# Samples a side of each patch. Every local minimum of the sampled distance starts a search, so the
# grid only has to separate neighbouring minima; a bicubic patch bends too little to need more.
SAMPLES = 12
# Positions are looked up in blocks, so that memory stays within some 100 MB.
BLOCK = 512
# Newton doubles its digits in a step: the slow ones are those where the distance is nearly
# stationary along a whole curve, as from the centre of a sphere.
MAX_ITERATIONS = 60
# Newton's error is squared by each step: after one of this size, in (u, v), only rounding is left.
STEP_TOLERANCE = 1e-12
# Halvings of a step before its search counts as arrived: 2^-30 of a step is below its rounding.
MAX_HALVINGS = 30
# Rounding of the offset from the target, as a part of the coordinates: steps near the end may seem
# uphill by that much.
ROUNDING = 1e-15
# Two patches' distances closer than this part of the atlas's size are the same point on their seam.
TIE_TOLERANCE = 1e-13


def closest_points(atlas: Atlas, positions: ArrayLike) -> tuple[tuple[AtlasPoint, ...], Array]:
    """Points of the smooth atlas that are closest to given positions.

    Parameters
    ----------
    atlas : Atlas
    positions : array_like, shape (k, 3)
        In the atlas's unit.

    Returns
    -------
    points : tuple of AtlasPoint, length k
        On a seam, the one on the patch with the lowest number.
    distances : ndarray, shape (k,)
        In the atlas's unit.

    Raises
    ------
    InputError
        If the positions have another shape, or are not finite.

    Notes
    -----
    A patch can hold the closest point only if one of its samples is closer than the closest sample
    plus the coarsest spacing; those patches are searched by Newton's method in the box
    ``[0, 1]^2``, from every local minimum over their samples.
    """
    positions = np.asarray(positions, dtype=np.float64)
    if positions.ndim != 2 or positions.shape[1] != 3:
        raise InputError(f"positions have shape {positions.shape}; expected (k, 3)")
    if not np.isfinite(positions).all():
        row = int(np.flatnonzero(~np.isfinite(positions).all(axis=1))[0])
        raise InputError(f"position {row} is {positions[row].tolist()}; expected finite numbers")
    search = _Search(atlas)
    points: list[AtlasPoint] = []
    distances = np.empty(len(positions))
    for first in range(0, len(positions), BLOCK):
        block = positions[first : first + BLOCK]
        found, distances[first : first + BLOCK] = search.run(block)
        points += found
    return tuple(points), distances


class _Search:
    """Samples of an atlas, made once for all blocks of positions."""

    def __init__(self, atlas: Atlas) -> None:
        self.nets = atlas.control_points
        side = np.linspace(0.0, 1.0, SAMPLES)
        self.grid = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1)
        shape = (len(atlas), SAMPLES, SAMPLES, 2)
        self.samples = evaluate(self.nets, np.broadcast_to(self.grid, shape))
        self.tree = scipy.spatial.KDTree(self.samples.reshape(-1, 3))
        self.spacing = _spacing(self.nets)
        self.size = float(np.ptp(self.samples.reshape(-1, 3), axis=0).max())

    def run(self, positions: Array) -> tuple[list[AtlasPoint], Array]:
        nearest, _ = self.tree.query(positions)
        within = self.tree.query_ball_point(positions, (nearest + self.spacing) * (1.0 + 1e-12))
        patches = [np.unique(np.asarray(hits) // SAMPLES**2) for hits in within]
        row = np.repeat(np.arange(len(positions)), [len(found) for found in patches])
        patch = np.concatenate(patches) if patches else np.empty(0, dtype=np.int64)

        # Of the distances to each candidate's samples, every local minimum starts a search.
        squared = ((self.samples[patch] - positions[row, None, None]) ** 2).sum(axis=-1)
        candidate, i, j = np.nonzero(_local_minima(squared))
        row, patch = row[candidate], patch[candidate]
        parameters, distance = _descend(self.nets[patch], positions[row], self.grid[i, j])

        best = np.full(len(positions), np.inf)
        np.minimum.at(best, row, distance)
        tied = distance <= best[row] + TIE_TOLERANCE * self.size
        # Candidates are sorted by patch within each row, so the first tied one is the lowest.
        rows, first = np.unique(row[tied], return_index=True)
        chosen = np.flatnonzero(tied)[first]
        points = [
            AtlasPoint(int(patch[k]), float(parameters[k, 0]), float(parameters[k, 1]))
            for k in chosen
        ]
        result = np.empty(len(positions))
        result[rows] = distance[chosen]
        return points, result


def _spacing(nets: Array) -> float:
    """How far a point of the atlas can lie from the closest sample, at most.

    A point is at most half a cell from a sample in u and in v, and no curve on a patch is faster
    than its derivative's longest control vector, times the square of the ratio of its weights if it
    is rational: M. Floater, Computer Aided Geometric Design 9 (1992) 161-174.
    """
    points, degree = project(nets), nets.shape[-3] - 1
    weights = nets[..., 3] if nets.shape[-1] == 4 else np.ones(nets.shape[:-1])
    ratio = (weights.max(axis=(-2, -1)) / weights.min(axis=(-2, -1))) ** 2
    speeds = [
        (np.linalg.norm(np.diff(points, axis=axis), axis=-1).max(axis=(-2, -1)) * ratio).max()
        for axis in (-3, -2)
    ]
    return float(degree * sum(speeds) * 0.5 / (SAMPLES - 1))


def _local_minima(values: Array) -> Bools:
    """Where no neighbour on the grid of the last two axes is lower, shape as `values`."""
    padded = np.pad(values, [(0, 0), (1, 1), (1, 1)], constant_values=np.inf)
    count = values.shape[-1]
    result = np.ones(values.shape, dtype=np.bool_)
    for i in range(3):
        for j in range(3):
            result &= values <= padded[:, i : i + count, j : j + count]
    return result


def _descend(nets: Array, targets: Array, start: Array) -> tuple[Array, Array]:
    """Newton's method for the closest point in the box, one problem a row.

    Returns parameters (k, 2) and distances (k,).

    Notes
    -----
    Projected Newton after D. Bertsekas, SIAM J. Control Optim. 20 (1982) 221-246: a coordinate on
    its bound which the gradient presses outwards is held; the others take a Newton step (a
    Gauss-Newton step where the Hessian is not positive definite), which is projected and halved
    until the distance falls.
    """
    x = start.copy()
    value = _half_square(nets, targets, x)
    largest = np.abs(project(nets)).max(axis=(1, 2, 3))
    rounding = ROUNDING * (largest + np.abs(targets).max(axis=1))
    busy = np.arange(len(x))
    for _ in range(MAX_ITERATIONS):
        if not len(busy):
            break
        step = _step(nets[busy], targets[busy], x[busy])
        change = np.zeros(len(busy))
        uphill = np.arange(len(busy))
        for halvings in range(MAX_HALVINGS):
            k = busy[uphill]
            trial = np.clip(x[k] + 0.5**halvings * step[uphill], 0.0, 1.0)
            trial_value = _half_square(nets[k], targets[k], trial)
            slack = rounding[k] * (np.sqrt(value[k]) + rounding[k])
            good = trial_value <= value[k] + slack
            change[uphill[good]] = np.abs(trial - x[k])[good].max(axis=-1)
            x[k[good]], value[k[good]] = trial[good], trial_value[good]
            uphill = uphill[~good]
            if not len(uphill):
                break
        # A search that no step improves has arrived, too: its change stays 0.
        busy = busy[change > STEP_TOLERANCE]
    return x, np.sqrt(2.0 * value)


def _half_square(nets: Array, targets: Array, x: Array) -> Array:
    return np.asarray(0.5 * ((evaluate(nets, x) - targets) ** 2).sum(axis=-1))


def _step(nets: Array, targets: Array, x: Array) -> Array:
    """Newton step of the coordinates that are free, shape (k, 2)."""
    s = derivatives(nets, x, order=2)
    tangents = np.stack([s[:, 1, 0], s[:, 0, 1]], axis=1)
    offset = s[:, 0, 0] - targets
    gradient = (tangents @ offset[..., None])[..., 0]
    metric = tangents @ tangents.swapaxes(1, 2)
    bend = np.stack([s[:, 2, 0], s[:, 1, 1], s[:, 1, 1], s[:, 0, 2]], axis=1)
    hessian = metric + (bend @ offset[..., None]).reshape(-1, 2, 2)

    held = ((x <= 0.0) & (gradient > 0.0)) | ((x >= 1.0) & (gradient < 0.0))
    trace = np.trace(metric, axis1=1, axis2=2)[:, None, None]
    # A damped metric is positive definite even where a tangent vanishes.
    damped = metric + (1e-9 * trace + np.finfo(np.float64).tiny) * np.eye(2)
    hessian, damped = _freeze(hessian, held), _freeze(damped, held)
    determinant = hessian[:, 0, 0] * hessian[:, 1, 1] - hessian[:, 0, 1] ** 2
    # Sylvester's criterion, with room for rounding.
    room = 1e-14 * np.abs(hessian).max(axis=(1, 2)) ** 2
    convex = (hessian[:, 0, 0] > 0.0) & (determinant > room)
    matrix = np.where(convex[:, None, None], hessian, damped)
    return -np.linalg.solve(matrix, np.where(held, 0.0, gradient)[..., None])[..., 0]


def _freeze(matrix: Array, held: Bools) -> Array:
    """The matrix with the held coordinates cut off from the others; their diagonal stays > 0."""
    result = np.where(held[:, :, None] | held[:, None, :], 0.0, matrix)
    largest = np.abs(matrix).max(axis=(1, 2))
    for axis in range(2):
        result[held[:, axis], axis, axis] = largest[held[:, axis]]
    return result
