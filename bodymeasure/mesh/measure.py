"""The measuring of triangle meshes from any source."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas import Unit
from bodymeasure.atlas.queries.locations import FARTHEST, far_words
from bodymeasure.atlas.size import require_size
from bodymeasure.errors import InputError
from bodymeasure.mesh.arrays import TriangleMesh, face_spheres, part_of, triangle_mesh
from bodymeasure.mesh.curved import curved, vertex_normals
from bodymeasure.mesh.exact import exact_path, joined_to, length_of
from bodymeasure.mesh.insert import inserted
from bodymeasure.mesh.path import MeshPath
from bodymeasure.oracle import validate_mesh
from bodymeasure.oracle.libigl import closest_on_mesh
from bodymeasure.threads import one_blas_thread

MeshPlace = int | Array
"""A vertex by its number, or a position of shape (3,) on or near the mesh."""

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


@one_blas_thread()
def measure_mesh(
    mesh: object,
    start: MeshPlace,
    end: MeshPlace,
    via: Sequence[MeshPlace] = (),
    *,
    unit: Unit | str | None = None,
) -> MeshPath:
    """Find the shortest path over a triangle mesh, and estimate what the mesh's coarseness costs.

    It measures the mesh, not a smooth surface: for that, use `geodesic_between` on an atlas.

    Parameters
    ----------
    mesh : trimesh.Trimesh, pyvista.PolyData or pair of array_like
        A manifold surface, oriented one way; vertices (n, 3) and faces (f, 3) if a pair.
    start, end : int or array_like of shape (3,)
        Vertices by number, or positions; these are moved to the closest point of the mesh.
    via : sequence of such
        Places that the path leads through, in order.
    unit : Unit or str, optional
        Unit of the mesh's coordinates, which is only passed on.

    Returns
    -------
    MeshPath

    Raises
    ------
    InputError
        If the mesh is not an oriented manifold of triangles (the message names the face or edge), a
        place is not on it, or no edges join two.
    MissingExtraError
        If pygeodesic or libigl is not installed.

    Notes
    -----
    The length is exact on the polyhedron (`bodymeasure.mesh.exact`). The error is estimated from
    the same path over triangles that are curved to meet the normals at the vertices, and cut into
    four (`bodymeasure.mesh.curved`).

    Examples
    --------
    >>> import bodymeasure as bm
    >>> vertices = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)]
    >>> path = bm.measure_mesh((vertices, [(0, 1, 2), (0, 2, 3)]), (0.0, 0.5, 0.0), 2, unit="cm")
    >>> print(f"{path.length:.6f} {path.unit}")
    1.118034 cm
    """
    given = triangle_mesh(mesh)
    if not np.isfinite(given.vertices).all():
        row = int(np.flatnonzero(~np.isfinite(given.vertices).all(axis=1))[0])
        raise InputError(f"mesh vertex {row} is not finite; expected three finite coordinates")
    require_size(given.vertices, what="the mesh")
    places = [start, *via, end]
    names = ["the start", *(f"via place {i}" for i in range(len(via))), "the end"]
    whole, numbers, moved = given, [], 0.0
    for name, place in zip(names, places, strict=True):
        whole, number, away = _with_vertex(whole, len(given.vertices), name, place)
        numbers.append(number)
        # A place on the way is the end of two legs, so that its move counts twice.
        moved += 2.0 * away
    whole, numbers = _component(whole, numbers)
    validate_mesh(*whole)
    legs = [exact_path(whole, *ends) for ends in pairwise(numbers)]
    error = sum(_error(whole, ends, leg) for leg, ends in zip(legs, pairwise(numbers), strict=True))
    points = np.concatenate([legs[0], *(leg[1:] for leg in legs[1:])])
    known = None if unit is None else Unit.parse(unit)
    return MeshPath(sum(map(length_of, legs)), float(error) + moved, points, known)


def _with_vertex(
    mesh: TriangleMesh, count: int, name: str, place: MeshPlace
) -> tuple[TriangleMesh, int, float]:
    """Return the mesh with a place as a vertex, its number, and how far it was moved."""
    if isinstance(place, (int, np.integer)) and not isinstance(place, bool):
        if not 0 <= place < count:
            raise InputError(
                f"{name} is vertex {place}, but the mesh's vertices are numbered 0 to {count - 1}"
            )
        if not (mesh.faces == place).any():
            raise InputError(f"{name} is vertex {place}, which belongs to no face; choose another")
        return mesh, int(place), 0.0
    try:
        position = np.asarray(place, dtype=np.float64)
    except (TypeError, ValueError):
        position = np.empty(0)
    if position.shape != (3,) or not np.isfinite(position).all():
        raise InputError(
            f"{name} is {place!r}; expected the number of a vertex, or three finite coordinates"
        )
    foot, face = closest_on_mesh(mesh.vertices, mesh.faces, position[None])
    distance = float(np.linalg.norm(foot[0] - position))
    size = float(np.linalg.norm(np.ptp(mesh.vertices[mesh.faces.ravel()], axis=0)))
    if distance > FARTHEST * size:
        said = far_words(name, position, distance, FARTHEST * size, surface="the mesh")
        raise InputError(
            f"{said}; its size is {size:.3g}: check the position's coordinates, and its unit"
        )
    more, number = inserted(mesh, int(face[0]), foot[0])
    return more, number, float(np.linalg.norm(more.vertices[number] - foot[0]))


def _component(mesh: TriangleMesh, numbers: list[int]) -> tuple[TriangleMesh, list[int]]:
    """Return the part of the mesh on which the first place lies, without unused vertices."""
    reached = joined_to(mesh, numbers[0])
    apart = [number for number in numbers if not reached[number]]
    if apart:
        # This raises the error, with the remedy.
        exact_path(mesh, numbers[0], apart[0])
    part, used = part_of(mesh, np.asarray(reached[mesh.faces].all(axis=1)))
    return part, [int(np.searchsorted(used, number)) for number in numbers]


def _error(mesh: TriangleMesh, ends: tuple[int, int], path: Array) -> float:
    """Estimate how far a path's length is from that over the surface the mesh stands for."""
    length = length_of(path)
    if length == 0.0:
        return 0.0
    normals = vertex_normals(mesh)
    part, used = part_of(mesh, _near(mesh, path, length))
    finer, sag = curved(part, normals[used])
    first, last = (int(np.searchsorted(used, number)) for number in ends)
    try:
        validate_mesh(*finer)
        changed = length_of(exact_path(finer, first, last))
    except InputError:
        # Normals that disagree fold the curved triangles over; nothing is known then.
        return float(np.inf)
    # Parts that bend one way may hide what others that bend the other way change.
    return SAFETY * MISSING * abs(changed - length) + length * float(np.mean(ARC * sag**2))


def _near(mesh: TriangleMesh, path: Array, length: float) -> Bools:
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
    part, used = part_of(mesh, near)
    start = int(np.searchsorted(used, np.argmin(np.linalg.norm(mesh.vertices - path[0], axis=1))))
    near[near] = joined_to(part, start)[part.faces].all(axis=1)
    return np.asarray(near)
