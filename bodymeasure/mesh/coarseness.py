"""How far a path's length over a mesh may be from that over the surface the mesh stands for."""

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas.topology.components import connected_components
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.mesh.arrays import TriangleMesh, face_spheres, part_of
from bodymeasure.mesh.curved import curved, vertex_normals
from bodymeasure.mesh.exact import ROUNDED, MeshPoint, exact_path
from bodymeasure.oracle import validate_mesh

# Lengths over meshes converge to the surface's with the square of the triangles' size, so that
# halving the triangles changes them by three quarters of the error.
MISSING = 4.0 / 3.0
# Factor for meshes whose triangles are of many sizes and shapes.
SAFETY = 3.0
# An arc of a circle whose sag is s times its chord is longer than that by 8/3 s^2.
ARC = 8.0 / 3.0
# The distances from a path within which the path over curved triangles is sought, as a part of its
# length and in edges of the mesh. It is the same path, slightly displaced.
ASIDE = 0.05
RINGS = 3.0


def coarseness_error(mesh: TriangleMesh, ends: tuple[MeshPoint, MeshPoint], path: Array) -> float:
    """Estimate how far a path's length is from that over the surface the mesh stands for.

    It is compared with the same path over triangles that are curved to meet the normals at the
    vertices, and cut into four (`bodymeasure.mesh.curved`).
    """
    length = length_of(path)
    if length == 0.0:
        return 0.0
    normals = vertex_normals(mesh)
    near = _near(mesh, ends[0], path, length)
    part, used = part_of(mesh, near)
    finer, sag = curved(part, normals[used])
    number = np.cumsum(near) - 1
    try:
        validate_mesh(*finer)
        first, last = (
            _quarter(place._replace(face=int(number[place.face])), len(part.faces))
            for place in ends
        )
        changed = length_of(exact_path(finer, first, last))
    except (ConvergenceError, InputError):
        # Normals that disagree fold the curved triangles over; nothing is known then.
        return float(np.inf)
    # Parts that bend one way may hide what others that bend the other way change.
    hidden = length * float(np.mean(ARC * sag**2))
    return SAFETY * MISSING * abs(changed - length) + hidden + ROUNDED * length


def length_of(points: Array) -> float:
    """Length of a chain of points (k, 3)."""
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def _near(mesh: TriangleMesh, start: MeshPoint, path: Array, length: float) -> Bools:
    """Return which faces lie beside a path, in one connected piece."""
    corners = mesh.vertices[mesh.faces]
    edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    # The path's own points lie on edges: no gap between two is longer than the longest edge.
    steps = max(1, int(np.ceil(edges.max() / np.median(edges))))
    t = np.arange(steps)[:, None, None] / steps
    dense = ((1.0 - t) * path[:-1] + t * path[1:]).reshape(-1, 3)
    # A large face may lie beside a path though none of its vertices does.
    center, radius = face_spheres(mesh)
    distance, _ = scipy.spatial.KDTree(np.vstack([dense, path[-1:]])).query(center)
    near = distance - radius <= max(ASIDE * length, RINGS * float(np.median(edges)))
    faces = mesh.faces[near]
    label = connected_components(
        faces.ravel(), np.roll(faces, -1, axis=1).ravel(), len(mesh.vertices)
    )[mesh.faces[:, 0]]
    return np.asarray(near & (label == label[start.face]))


def _quarter(place: MeshPoint, count: int) -> MeshPoint:
    """Return a place of a face in that of its four parts which holds it, in the order of `curved`.

    Parameters
    ----------
    place : MeshPoint
    count : int
        The number of faces before they are cut.
    """
    largest = int(np.argmax(place.weights))
    if place.weights[largest] >= 0.5:
        weights = 2.0 * place.weights
        weights[largest] -= 1.0
        return MeshPoint(place.face + largest * count, weights)
    # The middle of a side that leads away from a corner is opposite to the one before that.
    weights = 1.0 - 2.0 * np.roll(place.weights, 1)
    return MeshPoint(place.face + 3 * count, weights)
