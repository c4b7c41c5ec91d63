"""The points of patches and of an atlas that are closest to given positions."""

import numpy as np
import scipy
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint, on_edges
from bodymeasure.atlas.prepared import prepared
from bodymeasure.atlas.queries.feet import descend
from bodymeasure.bezier import derivatives, evaluate, project
from bodymeasure.errors import InputError
from bodymeasure.threads import one_blas_thread

# Samples along a side of each patch. Every local minimum of the sampled distance starts a search,
# so that the grid only has to separate neighboring minima; a bicubic patch bends too little to need
# more.
SAMPLES = 12
# Positions are looked up in blocks, so that memory stays within some 100 MB.
BLOCK = 512
# The last step in (u, v): Newton's error is squared by each step, so that only rounding is left.
LAST_STEP = 1e-12
# Part of the atlas's size that is rounding: two patches whose distances differ by less meet at the
# closest point, and a point this near to an edge is on it.
TIE_TOLERANCE = 1e-13


def closest_points(atlas: Atlas, positions: ArrayLike) -> tuple[tuple[AtlasPoint, ...], Array]:
    """Return the points of the smooth atlas that are closest to given positions.

    Parameters
    ----------
    atlas : Atlas
    positions : array_like, shape (k, 3)
        In the atlas's unit.

    Returns
    -------
    points : tuple of AtlasPoint, length k
        A point on a seam is given on the patch with the lowest number.
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

    Examples
    --------
    >>> import bodymeasure as bm
    >>> points, distances = closest_points(bm.load_sample("paraboloid"), [(0.0, 0.0, -2.0)])
    >>> print(points[0], distances[0])
    AtlasPoint(patch=0, u=0.0, v=0.0) 2.0
    """
    positions = np.asarray(positions, dtype=np.float64)
    if positions.ndim != 2 or positions.shape[1] != 3:
        raise InputError(f"positions have shape {positions.shape}; expected (k, 3)")
    if not np.isfinite(positions).all():
        row = int(np.flatnonzero(~np.isfinite(positions).all(axis=1))[0])
        raise InputError(f"position {row} is {positions[row].tolist()}; expected finite numbers")
    search = _search_of(atlas)
    points: list[AtlasPoint] = []
    distances = np.empty(len(positions))
    for first in range(0, len(positions), BLOCK):
        block = positions[first : first + BLOCK]
        found, distances[first : first + BLOCK] = search.run(block)
        points += found
    return tuple(points), distances


@one_blas_thread()
def closest_point(atlas: Atlas, position: ArrayLike) -> tuple[AtlasPoint, float]:
    """Return the point of the smooth atlas that is closest to a position, and its distance.

    Parameters
    ----------
    atlas : Atlas
    position : array_like, shape (3,)
        In the atlas's unit; it may be anywhere in space.

    Returns
    -------
    point : AtlasPoint
        A point on a seam is given on the patch with the lowest number.
    distance : float
        In the atlas's unit.

    Raises
    ------
    InputError
        If the position is not three finite numbers.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> paraboloid = bm.load_sample("paraboloid")
    >>> bm.closest_point(paraboloid, (0.0, 0.0, -2.0))
    (AtlasPoint(patch=0, u=0.0, v=0.0), 2.0)
    """
    try:
        given = np.asarray(position, dtype=np.float64)
    except (TypeError, ValueError):
        given = np.empty(0)
    if given.shape != (3,) or not np.isfinite(given).all():
        raise InputError(f"the position is {position!r}; expected three finite numbers")
    points, distances = closest_points(atlas, given[None])
    return points[0], float(distances[0])


class _Search:
    """The samples of an atlas, which all searches for closest points share."""

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

        # Every local minimum of the distances to a candidate's samples starts a search.
        squared = ((self.samples[patch] - positions[row, None, None]) ** 2).sum(axis=-1)
        candidate, i, j = np.nonzero(_local_minima(squared))
        row, patch = row[candidate], patch[candidate]
        nets = self.nets[patch]

        def jets(rows: Ints, x: Array) -> Array:
            return derivatives(nets[rows], x, order=2)

        parameters, found_squared = descend(jets, positions[row], self.grid[i, j], LAST_STEP)
        parameters, distance = self._on_edges(nets, parameters), np.sqrt(found_squared)

        best = np.full(len(positions), np.inf)
        np.minimum.at(best, row, distance)
        tied = distance <= best[row] + TIE_TOLERANCE * self.size
        # Candidates are sorted by patch within each row, so the first tied one is the lowest.
        rows, first = np.unique(row[tied], return_index=True)
        chosen = np.flatnonzero(tied)[first]
        points = [AtlasPoint(int(patch[k]), *parameters[k].tolist()) for k in chosen]
        result = np.empty(len(positions))
        result[rows] = distance[chosen]
        return points, result

    def _on_edges(self, nets: Array, parameters: Array) -> Array:
        """Parameters (k, 2) that are exactly 0 or 1 where rounding alone keeps them from it."""
        edge = on_edges(parameters)
        rows = np.flatnonzero((edge != parameters).any(axis=1))
        move = evaluate(nets[rows], edge[rows]) - evaluate(nets[rows], parameters[rows])
        far = np.linalg.norm(move, axis=1) > TIE_TOLERANCE * self.size
        edge[rows[far]] = parameters[rows[far]]
        return edge


@prepared
def _search_of(atlas: Atlas) -> _Search:
    return _Search(atlas)


def _spacing(nets: Array) -> float:
    """Return a bound of how far a point of the atlas can lie from the closest sample.

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
    """Return where no neighbor on the grid of the last two axes is lower, shape as `values`."""
    padded = np.pad(values, [(0, 0), (1, 1), (1, 1)], constant_values=np.inf)
    count = values.shape[-1]
    result = np.ones(values.shape, dtype=np.bool_)
    for i in range(3):
        for j in range(3):
            result &= values <= padded[:, i : i + count, j : j + count]
    return result
