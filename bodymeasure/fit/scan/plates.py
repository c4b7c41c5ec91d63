"""Floors, plates and stools: large flat parts that have all of the mesh on one side."""

import itertools

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.fit.scan.weld import area_vectors

# In square meters: both soles of a large pair of shoes have less.
LEAST_AREA = 0.1
# In meters: how far triangles lie from their plane, with a scanner's noise and a floor's dents.
THICKNESS = 0.02
# A plane has at most this part of its area as much deeper or higher again; a round back, whose caps
# grow with their depth, has all of it.
BESIDE = 0.3
# In meters: how high the top of a stool may lie above the floor.
HIGHEST = 0.6
# Cosine of the angle between the normals of triangles and that of their plane.
ALONG = 0.8
# Facets of the hull whose normals differ by less than this cosine are one candidate.
_ALIKE = 0.996
# Depths are counted in halves of a layer, so that each layer lies within two of them.
_BIN = 0.5 * THICKNESS
# Points over a mesh at which depths are counted, and into how many a side of a large triangle is
# cut for them: the few triangles of a coarse mesh would look like layers.
_PLACES, _MOST_STEPS = 50_000, 12
# A mesh has few large flat sides; a box has six.
_CANDIDATES = 12


def plates(vertices: Array, triangles: Ints) -> Bools:
    """Return which triangles belong to flat plates, shape (m,).

    A floor is a supporting plane of the mesh with much area along it. What lies between it and the
    highest parallel plane within `HIGHEST` that has as much area, such as the upper side of a plate
    or the top of a stool, belongs to it.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
        In meters.
    triangles : ndarray of int, shape (m, 3)
    """
    areas = area_vectors(vertices, triangles)
    found = np.zeros(len(triangles), dtype=np.bool_)
    places, row = _places(vertices, triangles)
    area = np.linalg.norm(areas, axis=1)
    spread = (area / np.bincount(row))[row]
    try:
        normals = _hull_normals(vertices)
    except scipy.spatial.QhullError:  # all vertices lie in one plane
        return ~found
    for normal in normals:
        heights = vertices @ normal
        depth = heights.max() - places @ normal
        facing = areas @ normal
        tops = [
            _deepest(depth[side[row]], spread[side[row]])
            for side in (facing > ALONG * area, -facing > ALONG * area)
        ]
        if any(first <= 1 for first, _ in tops):
            lowest = heights.max() - heights[triangles].min(axis=1)
            found |= lowest <= (max(last for _, last in tops) + 4) * _BIN
    return found


def _places(vertices: Array, triangles: Ints) -> tuple[Array, Ints]:
    """Return points over the triangles, evenly on each, and the triangle of each point."""
    steps = int(np.clip(np.ceil(np.sqrt(_PLACES / len(triangles))), 1, _MOST_STEPS))
    i, j = (each.ravel() for each in np.meshgrid(np.arange(steps), np.arange(steps)))
    up, down = i + j < steps, i + j < steps - 1
    first = np.concatenate([i[up] + 1 / 3, i[down] + 2 / 3]) / steps
    second = np.concatenate([j[up] + 1 / 3, j[down] + 2 / 3]) / steps
    weights = np.stack([1.0 - first - second, first, second], axis=1)
    places = np.einsum("km,nmi->nki", weights, vertices[triangles])
    return places.reshape(-1, 3), np.repeat(np.arange(len(triangles)), len(weights))


def _deepest(depth: Array, area: Array) -> tuple[int, int]:
    """Return the bins of the first and of the last flat layer below a supporting plane."""
    last = int(HIGHEST / _BIN)
    bins = np.minimum(np.maximum(depth, 0.0) / _BIN, last).astype(np.int64)
    # The last bin holds all that is deeper.
    filled = np.bincount(bins, area, last + 1)[:last]
    layers = filled[:-1] + filled[1:]
    padded = np.pad(layers, 2)
    beside = np.maximum(padded[:-4], padded[4:])
    flat = np.flatnonzero((layers >= LEAST_AREA) & (beside <= BESIDE * layers))
    return (int(flat[0]), int(flat[-1])) if len(flat) else (last, -1)


def _hull_normals(vertices: Array) -> list[Array]:
    """Return the outward normals of the largest flat sides of the hull of a mesh."""
    hull = scipy.spatial.ConvexHull(vertices)
    normals = hull.equations[:, :3]
    corners = vertices[hull.simplices]
    area = 0.5 * np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    left = np.ones(len(area), dtype=np.bool_)
    result: list[Array] = []
    for facet in itertools.islice(np.argsort(-area), 10 * _CANDIDATES):
        if not left[facet] or len(result) == _CANDIDATES:
            continue
        alike = left & (normals @ normals[facet] > _ALIKE)
        if area[alike].sum() >= LEAST_AREA:
            mean = area[alike] @ normals[alike]
            result.append(mean / np.linalg.norm(mean))
        left &= ~alike
    return result
