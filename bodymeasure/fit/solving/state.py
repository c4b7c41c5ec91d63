"""A body of the space in a pose, and the points on it that are compared with a scan."""

from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.sparse import csr_matrix
from scipy.spatial import cKDTree

from bodymeasure._typing import Array, Ints
from bodymeasure.fit.model import (
    Bones,
    body_model,
    bones_of,
    limit_matrix,
    pose_derivatives,
    shape_derivatives,
    skeleton,
    skinned,
)


@dataclass(frozen=True, eq=False)
class State:
    """A body of the space in a pose.

    Parameters
    ----------
    coefficients : ndarray, shape (120,)
    rotations : ndarray, shape (31, 3)
    shift : ndarray, shape (3,)
    """

    coefficients: Array
    rotations: Array
    shift: Array

    @property
    def bones(self) -> Bones:
        """The bones of the body."""
        return bones_of(self.coefficients, self.rotations, self.shift)


@dataclass(frozen=True, eq=False)
class Surface:
    """The limit positions of a body's vertices.

    They are skinned as vertices are, with weights averaged in the same way as positions: the
    surface to which a scan is compared differs from that of the skinned vertices by 0.1 mm.

    Parameters
    ----------
    rest, points, normals : ndarray, shape (13380, 3)
        Positions in the A-pose, positions and unit normals in the pose.
    bones : Bones
    """

    rest: Array
    points: Array
    normals: Array
    bones: Bones

    def derivatives(self, rows: Ints, count: int, joints: Ints) -> tuple[Array, Array]:
        """Return how some points move with shape and pose: (n, 3, count), (n, 3, joints, 3)."""
        _, components, weights = _limits()
        chosen = components[rows, :, :count].transpose(2, 0, 1)
        return (
            shape_derivatives(chosen, self.bones, weights[rows]),
            pose_derivatives(self.rest[rows], self.bones, weights[rows], joints),
        )

    def tree(self) -> cKDTree:
        """Return a search tree of the points."""
        return cKDTree(self.points)


def surface_of(state: State) -> Surface:
    """Return the limit positions of a body."""
    mean, components, weights = _limits()
    used = int(np.max(np.flatnonzero(state.coefficients), initial=0)) + 1
    rest = mean + components[:, :, :used] @ state.coefficients[:used]
    bones = state.bones
    points = skinned(rest, bones, weights)
    return Surface(rest, points, normals_of(points), bones)


def normals_of(points: Array) -> Array:
    """Return unit normals at the vertices of the body's mesh, shape (13380, 3)."""
    return normals_at(points, body_model().quads)


def normals_at(points: Array, quads: Ints) -> Array:
    """Return unit normals at the vertices of a quad mesh."""
    corners = points[quads]
    crossed = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    sums = np.zeros_like(points)
    for corner in quads.T:
        for axis in range(3):
            sums[:, axis] += np.bincount(corner, crossed[:, axis], len(points))
    return np.asarray(sums / np.maximum(np.linalg.norm(sums, axis=1, keepdims=True), 1e-12))


@cache
def even_vertices(count: int) -> Ints:
    """Return the numbers of so many vertices, spread evenly over the surface, always the same."""
    share = body_model().vertex_weight
    chosen = np.random.default_rng(1).choice(len(share), count, replace=False, p=share)
    return np.sort(chosen)


@cache
def _limits() -> tuple[Array, Array, csr_matrix]:
    """Limits of the mean (n, 3) and of the components (n, 3, 120), and their bones' shares."""
    model, matrix = body_model(), limit_matrix()
    flat = model.components.transpose(1, 2, 0).reshape(len(model.mean), -1)
    components = (matrix @ flat).reshape(len(model.mean), 3, -1)
    return matrix @ model.mean, components, (matrix @ skeleton().weights).tocsr()
