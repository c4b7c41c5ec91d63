"""A surface cut off at a plane."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from bodymeasure.scene.model import Surface


def clipped(surface: Surface, height: NDArray[np.float64]) -> Surface:
    """The part of a surface whose vertices have a height of at most zero.

    Parameters
    ----------
    surface : Surface
    height : ndarray, shape (n,)
        A linear function of the position, such as the distance from a plane, at the vertices.
        Triangles that it changes its sign in are cut along its zero line.
    """
    below = height[surface.triangles] <= 0.0
    count = below.sum(axis=1)
    whole = surface.triangles[count == 3]
    whole_patch = surface.patch[count == 3]
    cut = (count == 1) | (count == 2)
    # Turned so that the corner on its own, be it below or above, comes first.
    lone = np.where(count == 1, below.argmax(axis=1), (~below).argmax(axis=1))[cut]
    turn = (lone[:, None] + np.arange(3)) % 3
    a, b, c = np.take_along_axis(surface.triangles[cut], turn, axis=1).T
    start, end = np.concatenate([a, a]), np.concatenate([b, c])
    share = (height[start] / (height[start] - height[end]))[:, None]
    old = len(surface.points)
    ab = old + np.arange(len(a))
    ac = ab + len(a)
    one = count[cut] == 1
    pieces = [
        np.stack([a, ab, ac], axis=1)[one],
        np.stack([ab, b, c], axis=1)[~one],
        np.stack([ab, c, ac], axis=1)[~one],
    ]
    patch = surface.patch[cut]
    return replace(
        surface,
        points=np.concatenate([surface.points, _between(surface.points, start, end, share)]),
        normals=np.concatenate([surface.normals, _between(surface.normals, start, end, share)]),
        triangles=np.concatenate([whole, *pieces]),
        patch=np.concatenate([whole_patch, patch[one], patch[~one], patch[~one]]),
        faded=np.concatenate([surface.faded, surface.faded[start]]),
    )


def _between(
    values: NDArray[np.float64],
    start: NDArray[np.int64],
    end: NDArray[np.int64],
    share: NDArray[np.float64],
) -> NDArray[np.float64]:
    return np.asarray(values[start] + share * (values[end] - values[start]))
