"""A scan as points with normals, evenly spread: meshes of any size cost the same."""

from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np
from scipy.sparse import csr_matrix
from scipy.spatial import cKDTree

from bodymeasure._typing import Array, Bools, Ints

# A body has 1.6 to 2.2 square meters, so that points are 4 to 5 mm apart.
POINTS = 100_000
# Points so near the rim of a hole are closest to all that lies beyond it, in meters.
RIM = 0.012
# Two fifths of the way to the surface through the corners: right for decimated meshes (on the scan
# of 5,000 triangles in tests/data, girths are 2 mm too small at 0.1 and 3.6 mm too large at 0.25),
# and half of the fault of a mesh with corners on the surface, which matters for large triangles.
BULGE = 0.2
# Normals at sharp edges say nothing of the surface beside them; in meters.
MOST_BULGE = 0.003
# Rims are sampled in steps of this, in meters.
_RIM_STEP = 0.003


@dataclass(frozen=True, eq=False)
class Cloud:
    """Points on a scan.

    Parameters
    ----------
    points, normals : ndarray, shape (n, 3)
        Positions in meters, and outward unit normals.
    at_rim : ndarray of bool, shape (n,)
        Which of them lie within 12 mm of the rim of a hole.
    tree : scipy.spatial.cKDTree
        A search tree of the points.
    """

    points: Array
    normals: Array
    at_rim: Bools
    tree: Any

    def moved(self, turn: Array, shift: Array) -> Self:
        """Return the cloud after a rotation, shape (3, 3), and then a shift, shape (3,)."""
        points = self.points @ turn.T + shift
        normals = self.normals @ turn.T
        return replace(self, points=points, normals=normals, tree=cKDTree(points))

    def some(self, count: int, rng: np.random.Generator) -> Ints:
        """Return the numbers of so many random points that are not at a rim."""
        inner = np.flatnonzero(~self.at_rim)
        inner = inner if len(inner) else np.arange(len(self.points))
        return rng.choice(inner, min(count, len(inner)), replace=False)


def cloud_of(vertices: Array, triangles: Ints, count: int = POINTS) -> Cloud:
    """Return points on a welded and oriented mesh, always the same ones.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
        In meters.
    triangles : ndarray of int, shape (m, 3)
    count : int
        How many points.
    """
    corners = vertices[triangles]
    crossed = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = _vertex_normals(triangles, crossed, len(vertices))
    # Evenly spaced in the area passed through, so that no part is left out by chance.
    passed = np.cumsum(np.linalg.norm(crossed, axis=1))
    wanted = (np.arange(count) + 0.5) / count * passed[-1]
    chosen = np.minimum(np.searchsorted(passed, wanted), len(triangles) - 1)
    first, second = np.random.default_rng(0).random((2, count))
    over = first + second > 1.0
    first[over], second[over] = 1.0 - first[over], 1.0 - second[over]
    shares = np.stack([1.0 - first - second, first, second], axis=1)
    points = _bulged(corners[chosen], normals[triangles[chosen]], shares)
    smooth = np.einsum("nc,ncd->nd", shares, normals[triangles[chosen]])
    size = np.linalg.norm(smooth, axis=1, keepdims=True)
    flat = crossed[chosen] / np.linalg.norm(crossed[chosen], axis=1, keepdims=True)
    smooth = np.where(size > 1e-6, smooth / np.maximum(size, 1e-6), flat)
    rim = _rim(vertices, triangles)
    at_rim = np.zeros(count, dtype=bool)
    if len(rim):
        at_rim = cKDTree(rim).query(points, distance_upper_bound=RIM)[0] < RIM
    return Cloud(points, smooth, at_rim, cKDTree(points))


def _vertex_normals(triangles: Ints, crossed: Array, count: int) -> Array:
    """Area-weighted normals of the vertices, of unit length or zero."""
    rows, columns = triangles.ravel(), np.repeat(np.arange(len(triangles)), 3)
    shape = (count, len(triangles))
    sums = csr_matrix((np.ones(len(rows)), (rows, columns)), shape=shape) @ crossed
    size = np.linalg.norm(sums, axis=1, keepdims=True)
    return np.asarray(sums / np.where(size > 0.0, size, 1.0))


def _bulged(corners: Array, normals: Array, shares: Array) -> Array:
    """Points of triangles, moved towards the curved surface that these stand for.

    The chord of a circle lies as far inside it, at each point, as half the mean of the distances
    from the tangents at its ends; the same holds for triangles and spheres. Triangles of 2 cm lie
    a millimeter inside an arm. Where the corners lie on the surface, that is the way to go; but
    decimation puts them outside, about as far as it leaves the middles of triangles inside.
    """
    flat = np.einsum("nc,ncd->nd", shares, corners)
    heights = np.einsum("ncd,ncd->nc", corners - flat[:, None], normals)
    bulge = BULGE * np.einsum("nc,nc,ncd->nd", shares, heights, normals)
    size = np.linalg.norm(bulge, axis=1, keepdims=True)
    return np.asarray(flat + bulge * np.minimum(1.0, MOST_BULGE / np.maximum(size, 1e-12)))


def _rim(vertices: Array, triangles: Ints) -> Array:
    """Points along the edges that belong to one triangle only, shape (k, 3)."""
    ends = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    keys = ends.min(axis=1) * len(vertices) + ends.max(axis=1)
    _, first, counts = np.unique(keys, return_index=True, return_counts=True)
    tails, heads = vertices[ends[first[counts == 1]]].transpose(1, 0, 2)
    steps = np.ceil(np.linalg.norm(heads - tails, axis=1) / _RIM_STEP).astype(int) + 1
    which = np.repeat(np.arange(len(steps)), steps)
    along = (np.arange(len(which)) - np.repeat(np.cumsum(steps) - steps, steps)) / steps[which]
    return np.asarray(tails[which] + along[:, None] * (heads - tails)[which])
