"""The faces of a mesh beside the patches that stand for them: distances and lengths."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.subdivision.patches.grid import grid_jets
from bodymeasure.subdivision.patches.loop_schaefer import PatchNets
from bodymeasure.subdivision.patches.projection import closest_on_patches
from bodymeasure.subdivision.polygon_mesh import PolygonMesh
from bodymeasure.subdivision.sums import sum_at

# Steps along the sides of a patch with which its area is found.
STEPS = 8
# Patches that are compared at once, so that memory stays within some 100 MB.
BLOCK = 5000


class MeshDeviation(NamedTuple):
    """The deviation of patches from the faces of a mesh.

    Parameters
    ----------
    distance, rms : float
        The largest distance and the root mean square of all.
    lengths : float
        The relative difference of lengths, positive if the mesh's are longer: the root of the ratio
        of the areas, less 1, which is the mean over all places and directions. A girth of a round
        limb differs by up to twice as much.
    """

    distance: float
    rms: float
    lengths: float


def flat_places(mesh: PolygonMesh, places: Array) -> Array:
    """Return places on the faces for the vertices of the mesh that `refined` makes of another.

    Parameters
    ----------
    mesh : PolygonMesh
        The mesh that is refined.
    places : ndarray, shape (n, 3)
        Places on the original faces for its vertices.
    """
    middles = sum_at(mesh.face, places[mesh.corners], len(mesh.sizes)) / mesh.sizes[:, None]
    return np.concatenate([places, places[mesh.ends].mean(axis=1), middles])


def mesh_deviation(places: Array, quads: Ints, nets: PatchNets) -> MeshDeviation:
    """Return the deviation of patches from the faces of a mesh.

    Parameters
    ----------
    places : ndarray, shape (n, 3)
        Places on the faces, those of `flat_places`.
    quads : ndarray of int, shape (patches, 4)
        The numbers of those that belong to the corners of each patch.
    nets : PatchNets
    """
    distances = face_distances(places, quads, nets)
    # The corners of patches and the middles of their sides belong to several; the nearest counts.
    at_corners = np.full(len(places), np.inf)
    np.minimum.at(at_corners, quads, distances[:, :4])
    every = np.concatenate([at_corners[np.unique(quads)], distances[:, 4:].ravel()])
    return MeshDeviation(
        float(every.max()),
        float(np.sqrt((every**2).mean())),
        _lengths(places[quads], nets.points[nets.index]),
    )


def face_distances(places: Array, quads: Ints, nets: PatchNets) -> Array:
    """Return the distances of places on the faces from patches, shape (patches, 9).

    They are the corners of each patch, the middles of its sides, and its middle; the parameters are
    those of `mesh_deviation`.
    """
    control_points = nets.points[nets.index]
    return np.concatenate(
        [
            _distances(places[quads[first : first + BLOCK]], control_points[first : first + BLOCK])
            for first in range(0, len(quads), BLOCK)
        ]
    )


def _distances(corners: Array, nets: Array) -> Array:
    """Distances of the corners, middles of sides and middle of each face, (patches, 9)."""
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    start = np.concatenate([square, (square + np.roll(square, -1, 0)) / 2.0, [[0.5, 0.5]]])
    sides = (corners + np.roll(corners, -1, axis=1)) / 2.0
    targets = np.concatenate([corners, sides, corners.mean(axis=1, keepdims=True)], axis=1)
    offsets, _ = closest_on_patches(nets, targets, np.broadcast_to(start, (len(nets), 9, 2)))
    return np.asarray(np.linalg.norm(offsets, axis=-1))


def _lengths(corners: Array, nets: Array) -> float:
    """The relative difference of lengths: the root of the ratio of areas, less 1."""
    side = np.linspace(0.0, 1.0, STEPS + 1)
    surface = 0.0
    for first in range(0, len(nets), BLOCK):
        some = nets[first : first + BLOCK]
        points = grid_jets(some, side, 0)[..., 0, 0, :]
        cells = [points[:, :-1, :-1], points[:, 1:, :-1], points[:, 1:, 1:], points[:, :-1, 1:]]
        surface += _area(np.stack(cells, axis=-2))
    return float(np.sqrt(_area(corners) / surface) - 1.0) if surface > 0.0 else 0.0


def _area(quads: Array) -> float:
    diagonals = quads[..., 2, :] - quads[..., 0, :], quads[..., 3, :] - quads[..., 1, :]
    return 0.5 * float(np.linalg.norm(np.cross(*diagonals), axis=-1).sum())
