"""How far patches extend in a direction."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.bezier import split

# Of the atlas's size. Each halving brings control points four times as close to the surface: some
# ten of them are enough.
NEAR = 1e-7
MOST_HALVINGS = 20


def size_along(atlas: Atlas, directions: Array) -> Array:
    """Sizes of the box round an atlas's surface.

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
        [
            _farthest(nets, along, tolerance) + _farthest(nets, -along, tolerance)
            for along in directions
        ]
    )


def _farthest(nets: Array, direction: Array, tolerance: float) -> float:
    """The greatest coordinate along a direction of points of patches (k, m + 1, m + 1, 3 or 4).

    Control points enclose their patch, corners lie on it: patches whose control points do not come
    farther than some corner are dropped, the others quartered.
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
