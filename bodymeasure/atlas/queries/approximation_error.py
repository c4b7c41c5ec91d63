"""The difference that an approximation makes to lengths."""

from functools import lru_cache

import numpy as np
import scipy
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Ints
from bodymeasure.arguments import numbers
from bodymeasure.atlas.approximation import extent
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.bezier import evaluate
from bodymeasure.errors import InputError
from bodymeasure.threads import one_blas_thread

# Samples along a side of each patch, inside it, that tell which patch a position lies on.
SAMPLES = 6


@one_blas_thread()
def approximation_error(atlas: Atlas, positions: ArrayLike) -> float:
    """Return a bound on the error of a curve's length that comes from the atlas's approximation.

    The patches of a mesh approximate its Catmull-Clark surface. This is how much a length over the
    patches may differ from the same length on that surface.

    Parameters
    ----------
    atlas : Atlas
    positions : array_like, shape (k, 3)
        Points along the curve, in order and in the atlas's unit.

    Returns
    -------
    float
        In the atlas's unit; 0 if the atlas approximates nothing.

    Raises
    ------
    InputError
        If the positions have another shape.

    Notes
    -----
    It is the sum over the pieces of the curve of their lengths times the stretch of the patch under
    each (`Approximation`). To first order in the distance of the two surfaces, a shortest path on
    one is as long as its image on the other, so that the bound for this curve is one for the
    shortest path as well.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> path = bm.geodesic_between(body, "back neck point", "bust point left")
    >>> bm.approximation_error(body, path.position([0.0, 0.5, 1.0]))
    0.0
    """
    points = numbers(positions, "positions", "numbers (k, 3)")
    if points.ndim != 2 or points.shape[1] != 3:
        raise InputError(f"positions have shape {points.shape}; expected (k, 3)")
    if atlas.approximation is None or len(points) < 2:
        return 0.0
    middles = (points[1:] + points[:-1]) / 2.0
    lengths = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return float(atlas.approximation.stretch[nearest_patches(atlas, middles)] @ lengths)


def distances_from_surface(atlas: Atlas, positions: Array) -> Array:
    """Return bounds on the distances of points of the patches from the surface, shape (k,)."""
    if atlas.approximation is None:
        return np.zeros(len(positions))
    distance = atlas.approximation.distance[nearest_patches(atlas, positions)]
    return np.asarray(extent(atlas.points) * distance)


def nearest_patches(atlas: Atlas, positions: Array) -> Ints:
    """Return the patches that lie closest to positions (k, 3), as their samples tell."""
    return np.asarray(_samples(atlas).query(positions)[1] // SAMPLES**2)


@lru_cache(maxsize=4)
def _samples(atlas: Atlas) -> "scipy.spatial.KDTree":
    side = (np.arange(SAMPLES) + 0.5) / SAMPLES
    grid = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1)
    samples = evaluate(atlas.control_points, np.broadcast_to(grid, (len(atlas), *grid.shape)))
    return scipy.spatial.KDTree(samples.reshape(-1, 3))
