"""The triangle mesh of an atlas over which the starts of paths are pulled straight."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.prepared import prepared
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.size import require_size
from bodymeasure.atlas.tessellation import tessellate
from bodymeasure.atlas.topology.edges import edges_of
from bodymeasure.geodesic.across.routes.faces import FaceMesh, OnFace


@dataclass(frozen=True, eq=False)
class RouteMesh:
    """A triangle mesh with the places of its faces on the patches.

    Parameters
    ----------
    surface : FaceMesh
    patch : list of int
        The patch of each face.
    parameters : ndarray, shape (f, 3, 2)
        (u, v) of each face's corners on its patch.
    free : ndarray of bool, shape (f, 3, 2)
        Whether u, or v, of a corner is arbitrary, since the corner lies on a collapsed side.
    number : ndarray of int, shape (patches, k, k, 2)
        The number of each triangle of a patch's cells; -1 where a collapsed side leaves none.
    sides : list of list of int
        The side of its patch on which each side of a face lies; -1 if it lies on none.
    """

    surface: FaceMesh
    patch: list[int]
    parameters: Array
    free: Bools
    number: Ints
    sides: list[list[int]]

    @classmethod
    def of(cls, atlas: Atlas, segments: int) -> "RouteMesh":
        """Return the mesh of an atlas's tessellation."""
        mesh = tessellate(atlas, segments)
        collapsed = edges_of(atlas).collapsed[mesh.face_patch]
        free = np.zeros(mesh.face_parameters.shape, bool)
        for side, edge in enumerate(EDGES):
            on = mesh.face_parameters[..., edge.fixed_axis] == edge.fixed_value
            free[..., 1 - edge.fixed_axis] |= on & collapsed[:, [side]]
        # The lower triangle of a cell is the first one, and the mean of its corners has u > v.
        cell = segments * mesh.face_parameters.mean(axis=1)
        row, column = np.floor(cell).astype(np.int64).T
        upper = (cell[:, 0] % 1.0 < cell[:, 1] % 1.0).astype(np.int64)
        number = np.full((len(atlas), segments, segments, 2), -1)
        number[mesh.face_patch, row, column, upper] = np.arange(len(mesh.faces))
        surface = FaceMesh.of_faces(mesh.vertices, mesh.faces)
        sides = _sides_of_patches(mesh.face_parameters, free).tolist()
        return cls(surface, mesh.face_patch.tolist(), mesh.face_parameters, free, number, sides)

    def holding(self, place: AtlasPoint) -> OnFace:
        """Return a point of the atlas as a point of a face on its patch."""
        segments = self.number.shape[1]
        row, column = (min(int(segments * each), segments - 1) for each in place[1:])
        u, v = segments * place.u - row, segments * place.v - column
        lower, upper = self.number[place.patch, row, column].tolist()
        if lower >= 0 and upper >= 0:
            if u >= v:
                return OnFace(lower, [1.0 - u, u - v, v])
            return OnFace(upper, [1.0 - v, u, v - u])
        # A collapsed side leaves one triangle of the cell, on whose tip a parameter is arbitrary.
        face = max(lower, upper)
        corners = (self.parameters[face] * segments - (row, column)).tolist()
        share = [
            (1.0 if free[0] else 1.0 - abs(a - u)) * (1.0 if free[1] else 1.0 - abs(b - v))
            for (a, b), free in zip(corners, self.free[face].tolist(), strict=True)
        ]
        return OnFace(face, [each / sum(share) for each in share])


def _sides_of_patches(parameters: Array, free: Bools) -> Ints:
    """The side of the patch on which each side of a face lies, shape (f, 3); -1 for none."""
    result = np.full(parameters.shape[:2], -1)
    for number, edge in reversed(list(enumerate(EDGES))):
        axis = edge.fixed_axis
        on = (parameters[..., axis] == edge.fixed_value) | free[..., axis]
        result[on & np.roll(on, -1, axis=1)] = number
    return result


@prepared
def whole_mesh(atlas: Atlas, segments: int) -> RouteMesh:
    """Return the mesh of an atlas's tessellation, which is kept for the next path.

    Raises
    ------
    InputError
        If squares of areas would overflow, so that no path could be found.
    """
    require_size(atlas.points[atlas.index].reshape(-1, 3), atlas.unit)
    return RouteMesh.of(atlas, segments)
