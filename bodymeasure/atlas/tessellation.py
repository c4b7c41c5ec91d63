"""Triangle meshes of an atlas, welded along its seams."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.seams import EDGES, edge_table
from bodymeasure.bezier import evaluate
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.threads import one_blas_thread

if TYPE_CHECKING:
    from trimesh import Trimesh


class Patches(Protocol):
    """The data of an atlas that a tessellation needs."""

    @property
    def index(self) -> Ints:
        """Number of each patch's control points, shape (patches, degree + 1, degree + 1)."""

    @property
    def control_points(self) -> Array:
        """Control points of every patch, shape (patches, degree + 1, degree + 1, 3 or 4)."""


@dataclass(frozen=True, eq=False)
class Tessellation:
    """A triangle mesh, with the point of the atlas at each of its vertices.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
        Positions on the surface, in the atlas's unit.
    faces : ndarray of int, shape (f, 3)
        Vertex numbers, ordered so that each patch's normals point along ``S_u x S_v``.
    patch : ndarray of int, shape (n,)
        A patch that holds each vertex; on a seam, the one with the lowest number.
    parameters : ndarray, shape (n, 2)
        Each vertex's (u, v) on that patch.
    face_patch : ndarray of int, shape (f,)
        The patch that each face belongs to.
    face_parameters : ndarray, shape (f, 3, 2)
        (u, v) of each face's corners on the face's own patch.
    """

    vertices: Array
    faces: Ints
    patch: Ints
    parameters: Array
    face_patch: Ints
    face_parameters: Array

    def __repr__(self) -> str:
        vertices, faces = len(self.vertices), len(self.faces)
        return f"<Tessellation of {vertices:,} vertices and {faces:,} triangles>"

    def to_trimesh(self) -> "Trimesh":
        """Return the mesh as a `trimesh.Trimesh`, with vertex attributes ``patch``, u and v.

        Raises
        ------
        MissingExtraError
            If trimesh is not installed.
        """
        try:
            import trimesh
        except ImportError:
            raise MissingExtraError("the mesh export", "trimesh", "oracle") from None
        return trimesh.Trimesh(
            self.vertices,
            self.faces,
            vertex_attributes={
                # GLB files hold no wider whole numbers.
                "patch": self.patch.astype(np.uint16 if self.patch.max() < 2**16 else np.uint32),
                "u": self.parameters[:, 0],
                "v": self.parameters[:, 1],
            },
            process=False,
        )


@one_blas_thread()
def tessellate(atlas: Patches, segments: int) -> Tessellation:
    """Return a triangle mesh of the whole atlas, every patch edge cut into equal parameter steps.

    Patches that share an edge or a corner by index share its vertices; nothing is welded because
    it happens to be near. An edge whose control points are one becomes one vertex.

    Parameters
    ----------
    atlas : Atlas
    segments : int
        Number of steps along each patch edge, at least 1.

    Returns
    -------
    Tessellation

    Raises
    ------
    InputError
        If `segments` is no whole number, or less than 1.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> mesh = tessellate(bm.load_sample("paraboloid"), 8)
    >>> mesh.vertices.shape, mesh.faces.shape
    ((81, 3), (128, 3))
    """
    if not isinstance(segments, (int, np.integer)) or segments < 1:
        raise InputError(f"segments is {segments}; expected at least 1 a patch edge")
    grid = _welded_grids(atlas.index, segments)
    # Number the vertices in the order in which patches first use them: the first is the owner.
    flat, first = np.unique(grid, return_index=True)
    patch, place = np.divmod(first, (segments + 1) ** 2)
    parameters = np.stack(np.divmod(place, segments + 1), axis=-1) / segments
    vertices = evaluate(atlas.control_points[patch], parameters)
    faces = grid_faces(np.searchsorted(flat, grid))
    face_patch = np.repeat(np.arange(len(atlas.index)), 2 * segments**2)
    proper = _has_three_corners(faces)
    return Tessellation(
        vertices,
        faces[proper],
        patch,
        parameters,
        face_patch[proper],
        _corner_parameters(len(atlas.index), segments)[proper],
    )


def grid_faces(grid: Ints) -> Ints:
    """Return two triangles for each cell of grids of vertex numbers, cut from (0, 0) to (1, 1).

    Parameters
    ----------
    grid : ndarray of int, shape (*batch, k + 1, l + 1)
        Vertex numbers; axis -2 runs with u, axis -1 with v.

    Returns
    -------
    ndarray of int, shape (faces, 3)
        2 k l triangles for each grid, grid after grid.
    """
    a, b = grid[..., :-1, :-1], grid[..., 1:, :-1]
    c, d = grid[..., 1:, 1:], grid[..., :-1, 1:]
    cells = np.stack([np.stack([a, b, c], axis=-1), np.stack([a, c, d], axis=-1)], axis=-2)
    return cells.reshape(-1, 3).astype(np.int64)


def _corner_parameters(count: int, segments: int) -> Array:
    """(u, v) of the corners of all faces of `count` patches, shape (faces, 3, 2)."""
    places = grid_faces(np.arange((segments + 1) ** 2).reshape(segments + 1, segments + 1))
    one = np.stack(np.divmod(places, segments + 1), axis=-1) / segments
    return np.tile(one, (count, 1, 1))


def _has_three_corners(faces: Ints) -> Bools:
    """Return which faces have three different corners; half of those on a collapsed edge do not."""
    return np.asarray((faces != np.roll(faces, 1, axis=1)).all(axis=1))


def _welded_grids(index: Ints, segments: int) -> Ints:
    """Vertex numbers, with gaps, of every patch's grid: corners, then edges, then interiors."""
    count = len(index)
    inside = segments - 1
    table = edge_table(index)
    grid = np.empty((count, segments + 1, segments + 1), dtype=np.int64)
    offset = int(index.max()) + 1

    for side, edge in enumerate(EDGES):
        forwards = np.arange(inside)
        steps = np.where(table.reversed[:, side, None], forwards[::-1], forwards)
        numbers = offset + table.edge[:, side, None] * inside + steps
        collapsed = table.collapsed[:, side]
        numbers[collapsed] = table.control_index[collapsed, side, :1]
        rows = grid if edge.fixed_axis == 0 else grid.swapaxes(1, 2)
        rows[:, int(edge.fixed_value) * segments, 1:-1] = numbers
    offset += len(table.sides) * inside

    for i in (0, 1):
        for j in (0, 1):
            grid[:, i * segments, j * segments] = index[:, -i, -j]
    grid[:, 1:-1, 1:-1] = offset + np.arange(count * inside**2).reshape(count, inside, inside)
    return grid
