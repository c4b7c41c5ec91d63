"""The triangle mesh of an atlas over which the starts of paths are pulled straight."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

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
    patch : ndarray of int, shape (f,)
        The patch of each face.
    parameters : ndarray, shape (f, 3, 2)
        (u, v) of each face's corners on its patch.
    free : ndarray of bool, shape (f, 3, 2)
        Whether u, or v, of a corner is arbitrary, since the corner lies on a collapsed side.
    number : ndarray of int, shape (patches, k, k, 2)
        The number of each triangle of a patch's cells; -1 where a collapsed side leaves none.
    sides : ndarray of int, shape (f, 3)
        The side of its patch on which each side of a face lies; -1 if it lies on none.
    """

    surface: FaceMesh
    patch: Ints
    parameters: Array
    free: Bools
    number: Ints
    sides: Ints

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
        sides = _sides_of_patches(mesh.face_parameters, free)
        return cls(surface, mesh.face_patch, mesh.face_parameters, free, number, sides)

    @property
    def segments(self) -> int:
        """The number of steps along a patch's edge."""
        return int(self.number.shape[1])

    @property
    def corners(self) -> Ints:
        """The vertices of the faces, shape (f, 3)."""
        return self.surface.arrays.faces

    @cached_property
    def vertex(self) -> Ints:
        """The vertex at each point of the patches' grids, shape (patches, k + 1, k + 1); or -1."""
        lines = self.segments + 1
        result = np.full((len(self.number), lines, lines), -1)
        row, column = np.moveaxis(np.rint(self.segments * self.parameters).astype(np.int64), -1, 0)
        result[self.patch[:, None], row, column] = self.corners
        return result

    @cached_property
    def _rows(self) -> list[list[list[int]]]:
        """The vertices in lists, which Python reads faster."""
        rows: list[list[list[int]]] = self.vertex.tolist()
        return rows

    def on_grid(self, patch: int, vertex: int) -> tuple[int, int]:
        """Return a point of a patch's grid, the first one, at which a vertex lies."""
        rows = self._rows[patch]
        return next((i, row.index(vertex)) for i, row in enumerate(rows) if vertex in row)

    def between(self, patch: int, here: Sequence[int], there: Sequence[int]) -> list[int]:
        """Return the vertices of a patch along edges between two points of its grid."""
        rows, (i, j) = self._rows[patch], here
        steps = unit_steps(there[0] - i, there[1] - j)
        return [each for a, b in steps if (each := rows[i + a][j + b]) >= 0]

    def holding(self, place: AtlasPoint) -> OnFace:
        """Return a point of the atlas as a point of a face on its patch."""
        segments = self.segments
        row, column = (min(int(segments * each), segments - 1) for each in place[1:])
        cells = self.number[place.patch]
        if cells[row, column].max() < 0:
            # Where two collapsed sides meet, the cell is a line: a side of the cell next to it.
            row = min(max(row, 1), segments - 2)
        u = min(max(segments * place.u - row, 0.0), 1.0)
        v = segments * place.v - column
        lower, upper = cells[row, column].tolist()
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


@lru_cache(maxsize=4096)
def unit_steps(rows: int, columns: int) -> tuple[tuple[int, int], ...]:
    """Return the places on the way, along lines of a grid or along its diagonals, to a place."""
    steps = max(abs(rows), abs(columns))
    result = [(0, 0)]
    for number in range(1, steps + 1):
        i, j = ((2 * each * number + steps) // (2 * steps) for each in (rows, columns))
        # Cells are cut along one diagonal only.
        if (i - result[-1][0]) * (j - result[-1][1]) < 0:
            result.append((i, result[-1][1]))
        result.append((i, j))
    return tuple(result)


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
