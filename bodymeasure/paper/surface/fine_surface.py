"""The surface to which an atlas was fitted, as meshes that converge to it."""

from dataclasses import dataclass

import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.oracle.libigl import closest_on_mesh
from bodymeasure.subdivision import (
    QuadMesh,
    fill_pinches,
    limit_positions,
    part,
    quads_within,
    subdivide,
    triangles,
)

# Steps of subdivision of the meshes. The quads of a mannequin have sides of 1.8 cm, and of 4, 2 and
# 1 mm after 2, 3 and 4 steps. The error of distances on a mesh is of second order in that; after
# extrapolation it is 3e-6 of them in the median, a two hundredth of the differences of an atlas.
LEVELS = (2, 3, 4)
# The same for a quick run, whose errors are 4e-5 of the lengths, in a third of the time.
QUICK_LEVELS = (1, 2, 3)

# The closest points are sought on ever finer meshes around them, down to so many steps, where the
# sides of the meshes are 0.03 mm. The error of a point along the surface is its distance from it
# times the error of the normal of a face, some 0.2 mm times 1e-4.
CLOSEST_LEVEL = 9
# Rings of quads that are kept around the vertex closest to a position. The first holds the closest
# point; after a step, one more is needed for the next closest vertex, and one for its limit.
RINGS = 3


@dataclass(frozen=True, eq=False)
class FineSurface:
    """Meshes of a Catmull-Clark surface, from coarse to fine; their vertices lie on the surface.

    Parameters
    ----------
    levels : tuple of int
        Steps of subdivision of each mesh.
    control_mesh : QuadMesh
        The control mesh after `levels[0]` steps.
    meshes : tuple of QuadMesh
        At each level, with the vertices moved to their limits.
    """

    levels: tuple[int, ...]
    control_mesh: QuadMesh
    meshes: tuple[QuadMesh, ...]

    @property
    def segments(self) -> tuple[int, ...]:
        """The number of parts of a side of a quad at each level, for the extrapolation."""
        return tuple(2**level for level in self.levels)

    def faces(self, step: int) -> Ints:
        """Return the triangles of a mesh, two for each quad in their order."""
        return triangles(self.meshes[step].quads)


def fine_surface(mesh: QuadMesh, levels: tuple[int, ...] = LEVELS) -> FineSurface:
    """Return the meshes of a surface by subdivision of its control mesh.

    Parameters
    ----------
    mesh : QuadMesh
    levels : tuple of int
        Steps of subdivision, each one more than the one before.
    """
    for _ in range(levels[0]):
        mesh = subdivide(mesh)
    first, meshes = mesh, []
    for _ in levels:
        meshes.append(QuadMesh(limit_positions(mesh), mesh.quads))
        mesh = subdivide(mesh) if len(meshes) < len(levels) else mesh
    return FineSurface(levels, first, tuple(meshes))


def closest_limit_points(surface: FineSurface, positions: Array) -> Array:
    """Return points of the limit surface that are closest to given positions, shape (k, 3).

    The neighborhoods of the closest vertices are subdivided together and reduced to those of the
    closest of the new vertices, again and again.
    """
    mesh = surface.control_mesh
    for level in range(surface.levels[0], CLOSEST_LEVEL + 1):
        limits = limit_positions(mesh)
        _, closest = scipy.spatial.KDTree(limits).query(positions)
        if level < CLOSEST_LEVEL:
            near = fill_pinches(mesh, quads_within(mesh, closest, RINGS))
            mesh = subdivide(part(mesh, near)[0])
    inner = quads_within(mesh, closest, 1)
    return closest_on_mesh(limits, triangles(mesh.quads[inner]), positions)[0]
