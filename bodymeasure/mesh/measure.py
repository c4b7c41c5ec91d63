"""The measuring of triangle meshes from any source."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Unit
from bodymeasure.atlas.queries.locations import FARTHEST, far_words
from bodymeasure.atlas.size import require_size
from bodymeasure.atlas.topology.components import connected_components
from bodymeasure.errors import InputError
from bodymeasure.mesh.arrays import TriangleMesh, part_of, triangle_mesh
from bodymeasure.mesh.coarseness import coarseness_error, length_of
from bodymeasure.mesh.exact import MeshPoint, exact_path
from bodymeasure.mesh.path import MeshPath
from bodymeasure.oracle import validate_mesh
from bodymeasure.oracle.libigl import closest_on_mesh
from bodymeasure.threads import one_blas_thread

MeshPlace = int | Array
"""A vertex by its number, or a position of shape (3,) on or near the mesh."""


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
        If a place is not a vertex, and libigl is not installed.
    ConvergenceError
        If the search ends before the path is known to be the shortest: on meshes of a million
        triangles and more.

    Notes
    -----
    The length is exact on the polyhedron, but for rounding (`bodymeasure.mesh.exact`). The error is
    estimated from the same path over triangles that are curved to meet the normals at the vertices,
    and cut into four (`bodymeasure.mesh.curved`).

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
    found = [_found(given, *pair) for pair in zip(names, places, strict=True)]
    whole, points = _component(given, [point for point, _ in found])
    validate_mesh(*whole)
    legs = [exact_path(whole, *ends) for ends in pairwise(points)]
    # A place on the way is the end of two legs, so that its rounding counts twice.
    error = 2.0 * sum(away for _, away in found)
    for leg, ends in zip(legs, pairwise(points), strict=True):
        error += coarseness_error(whole, ends, leg)
    chain = np.concatenate([legs[0], *(leg[1:] for leg in legs[1:])])
    known = None if unit is None else Unit.parse(unit)
    return MeshPath(sum(map(length_of, legs)), error, chain, known)


def _found(mesh: TriangleMesh, name: str, place: MeshPlace) -> tuple[MeshPoint, float]:
    """Return a place on the mesh, and how far rounding moves it."""
    if isinstance(place, (int, np.integer)) and not isinstance(place, bool):
        count = len(mesh.vertices)
        if not 0 <= place < count:
            raise InputError(
                f"{name} is vertex {place}, but the mesh's vertices are numbered 0 to {count - 1}"
            )
        if not (mesh.faces == place).any():
            raise InputError(f"{name} is vertex {place}, which belongs to no face; choose another")
        return MeshPoint.at_vertex(mesh, int(place)), 0.0
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
    point = MeshPoint.at_foot(mesh, int(face[0]), foot[0])
    return point, float(np.linalg.norm(point.position(mesh) - foot[0]))


def _component(mesh: TriangleMesh, places: list[MeshPoint]) -> tuple[TriangleMesh, list[MeshPoint]]:
    """Return the part of the mesh on which the first place lies, without unused vertices."""
    label = connected_components(
        mesh.faces.ravel(), np.roll(mesh.faces, -1, axis=1).ravel(), len(mesh.vertices)
    )[mesh.faces[:, 0]]
    here = label == label[places[0].face]
    for place in places:
        if not here[place.face]:
            # This raises the error, with the remedy.
            exact_path(mesh, places[0], place)
    part, _ = part_of(mesh, here)
    number = np.cumsum(here) - 1
    return part, [place._replace(face=int(number[place.face])) for place in places]
