"""The patches of a mesh, as many as its surface needs, and how well they approximate it."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas import Approximation, ApproximationKind
from bodymeasure.atlas.approximation import extent
from bodymeasure.errors import InputError
from bodymeasure.subdivision import (
    PatchNets,
    PolygonMesh,
    children_places,
    face_distances,
    fitted,
    flat_places,
    interpolating,
    limit_deviation,
    loop_schaefer,
    mesh_deviation,
    refined,
)

# A mesh is refined until its patches deviate by at most this part of its mean edge, unless that
# takes more patches than these; with more, lengths take longer, and what they lack is stated.
DEVIATION = 1e-4
FEW = 500
# The number of patches up to which a mesh is refined for a deviation that a user asks for.
MANY = 200_000
# No step of subdivision divides the deviation by more; the usual factor is 6.
BEST_FACTOR = 16.0
# A surface that leaves a face by more than this part of the face's mean edge overshoots; an arc
# of 90 degrees leaves its chord by 0.2 of it, and the surface through the corners of a cube its
# sides by 0.34.
OVERSHOOT = 0.5


class Approximated(NamedTuple):
    """The patches of a mesh.

    Parameters
    ----------
    nets : PatchNets
    face : ndarray of int, shape (patches,)
        The face that each comes from.
    at_corner : ndarray of int, shape (patches,)
        The corner of the face, if that is no quad.
    corners : ndarray, shape (patches, 3, 2)
        The parameters on the face, or at its corner, at (u, v) = (0, 0), (1, 0) and (0, 1).
    approximation : Approximation
    """

    nets: PatchNets
    face: Ints
    at_corner: Ints
    corners: Array
    approximation: Approximation


def approximate(
    mesh: PolygonMesh, holes: Bools, deviation: float | None = None, *, interpolate: bool = False
) -> Approximated:
    """Return the patches of a mesh but for those of its holes.

    Parameters
    ----------
    mesh : PolygonMesh
    holes : ndarray of bool, shape (faces,)
    deviation : float, optional
        The largest distance from the Catmull-Clark surface.
    interpolate : bool
        Whether that runs through the vertices of the mesh.

    Raises
    ------
    InputError
        If that takes too many patches, or no surface through the vertices is close to the faces.
    """
    wanted = deviation
    if wanted is None:
        wanted = DEVIATION * float(
            np.linalg.norm(np.diff(mesh.vertices[mesh.ends], axis=1), axis=2).mean()
        )
    most = FEW if deviation is None else MANY
    places, face = mesh.vertices, np.arange(len(mesh.sizes))
    at_corner, squares = _first_squares(mesh)
    if interpolate:
        mesh = _through_vertices(mesh)
    if not (mesh.sizes == 4).all():
        mesh, places, face = _refined(mesh, places, face)
    while True:
        nets = fitted(mesh, loop_schaefer(mesh))
        found, kept = limit_deviation(mesh, nets), ~holes[face]
        largest = float(found.distance[kept].max())
        if largest <= wanted or _out_of_reach(largest / wanted, most / len(face)):
            break
        mesh, places, face = _refined(mesh, places, face)
        at_corner, squares = np.repeat(at_corner, 4), children_places(squares)
    if deviation is not None and largest > deviation:
        raise InputError(
            f"{len(face)} patches still deviate by {largest:.2g} from the surface of the mesh, and "
            f"{MANY} would not reach {deviation:g}; take a larger deviation"
        )
    used, index = np.unique(nets.index[kept], return_inverse=True)
    chosen = PatchNets(nets.points[used], index.reshape(-1, 4, 4))
    quads = mesh.corners.reshape(-1, 4)[kept]
    size, on_mesh = extent(chosen.points) or 1.0, mesh_deviation(places, quads, chosen)
    return Approximated(
        chosen,
        face[kept],
        at_corner[kept],
        squares[kept][:, [0, 1, 3]],
        Approximation(
            ApproximationKind.INTERPOLATED if interpolate else ApproximationKind.SMOOTHED,
            _short(found.distance[kept] / size),
            _short(found.stretch[kept]),
            *_short(
                np.array([on_mesh.distance / size, on_mesh.rms / size, on_mesh.lengths])
            ).tolist(),
        ),
    )


def _out_of_reach(factor: float, more: float) -> bool:
    """Whether so many times as many patches cannot divide the deviation by a factor."""
    steps = int(np.log(more) / np.log(4.0)) if more >= 4.0 else 0
    return steps == 0 or factor > BEST_FACTOR**steps


def _refined(mesh: PolygonMesh, places: Array, face: Ints) -> tuple[PolygonMesh, Array, Ints]:
    """Return the mesh after a step, with places on the original faces and the face of each quad."""
    return refined(mesh), flat_places(mesh, places), face[mesh.face]


def _first_squares(mesh: PolygonMesh) -> tuple[Ints, Array]:
    """Return the corner of its face for each first quad of a mesh, and the (s, t) of its corners.

    If there are other polygons than quads, each face becomes a quad for each of its corners.
    """
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    if (mesh.sizes == 4).all():
        count = len(mesh.sizes)
        return np.zeros(count, dtype=np.int64), np.broadcast_to(square, (count, 4, 2))
    first = np.cumsum(mesh.sizes) - mesh.sizes
    at_corner = np.arange(len(mesh.corners)) - first[mesh.face]
    of_quads = children_places(square[None])[at_corner % 4]
    return at_corner, np.where((mesh.sizes == 4)[mesh.face][:, None, None], of_quads, square)


def _through_vertices(mesh: PolygonMesh) -> PolygonMesh:
    """Return the mesh whose surface runs through the vertices of another, close to its faces."""
    result = interpolating(mesh)
    places, face, quads = mesh.vertices, np.arange(len(mesh.sizes)), result
    if not (mesh.sizes == 4).all():
        places, face, quads = flat_places(mesh, places), mesh.face, refined(result)
    away = face_distances(places, quads.corners.reshape(-1, 4), loop_schaefer(quads)).max(axis=1)
    edges = np.linalg.norm(mesh.vertices[mesh.corners] - mesh.vertices[mesh.heads], axis=1)
    edge = np.bincount(mesh.face, edges) / mesh.sizes
    worst = int(np.argmax(away / edge[face]))
    if away[worst] > OVERSHOOT * edge[face[worst]]:
        raise InputError(
            "a smooth surface through the vertices of the mesh overshoots: it lies "
            f"{away[worst]:.2g} from {mesh.called([face[worst]])}, whose edges are "
            f"{edge[face[worst]]:.2g} long; leave out interpolation, or smooth the mesh where it "
            "was made"
        )
    return result


def _short(values: Array) -> Array:
    """Return numbers of three digits, which files hold as such."""
    return np.array([float(f"{value:.2e}") for value in values.tolist()])
