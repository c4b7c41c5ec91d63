"""A body as a triangle mesh, which libraries are given."""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint, Tessellation, tessellate

# A path is looked for where one so many times as long as one that is known can reach.
ROOM = 1.02


@dataclass(frozen=True, eq=False)
class MeshedBody:
    """A body as triangles.

    Parameters
    ----------
    atlas : Atlas
    mesh : Tessellation
    """

    atlas: Atlas
    mesh: Tessellation

    @cached_property
    def flips(self) -> Any:
        """potpourri3d's solver on this mesh."""
        from potpourri3d import EdgeFlipGeodesicSolver

        return EdgeFlipGeodesicSolver(self.mesh.vertices, self.mesh.faces)

    @cached_property
    def trimesh(self) -> Any:
        """The mesh as trimesh's object."""
        return self.mesh.to_trimesh()

    def vertex(self, point: AtlasPoint) -> int:
        """Return the number of the vertex at a point of the atlas."""
        return self.nearest(self.atlas.position(point))

    def nearest(self, position: Array) -> int:
        """Return the number of the vertex nearest to a position."""
        return int(np.argmin(np.linalg.norm(self.mesh.vertices - position, axis=1)))

    def within_reach(self, ends: tuple[int, int], longest: float) -> tuple[Array, Ints, Ints]:
        """Return vertices and faces that a path between two vertices may reach, and its ends."""
        vertices, faces = self.mesh.vertices, self.mesh.faces
        way = sum(np.linalg.norm(vertices - vertices[end], axis=1) for end in ends)
        near = faces[(way < ROOM * longest)[faces].any(axis=1)]
        used, corners = np.unique(near, return_inverse=True)
        return vertices[used], corners.reshape(-1, 3), np.searchsorted(used, ends)


@lru_cache(maxsize=4)
def meshed_body(atlas: Atlas, segments: int) -> MeshedBody:
    """Return a body with so many segments along each edge of a patch."""
    return MeshedBody(atlas, tessellate(atlas, segments))
