"""One bicubic Bezier patch for each quad: approximate Catmull-Clark surfaces.

C. Loop and S. Schaefer, "Approximating Catmull-Clark subdivision surfaces with bicubic patches",
ACM Transactions on Graphics 27 (2008).
"""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError
from bodymeasure.subdivision.darts import dart_limits
from bodymeasure.subdivision.polygon_mesh import PolygonMesh
from bodymeasure.subdivision.sums import sum_at

# Places (i, j) in a patch's net of what belongs to corner k of its quad: the corner itself, the
# edge point beside it towards corner k + 1, that towards corner k - 1, and the inner point. u runs
# from corner 0 to corner 1, v from corner 0 to corner 3.
_CORNER = ((0, 0), (3, 0), (3, 3), (0, 3))
_TO_NEXT = ((1, 0), (3, 1), (2, 3), (0, 2))
_TO_LAST = ((0, 1), (2, 0), (3, 2), (1, 3))
_INNER = ((1, 1), (2, 1), (2, 2), (1, 2))


@dataclass(frozen=True, eq=False)
class PatchNets:
    """Bicubic patches that share control points by index.

    Parameters
    ----------
    points : ndarray, shape (n, 3)
    index : ndarray of int, shape (patches, 4, 4)
    """

    points: Array
    index: Ints


def loop_schaefer(mesh: PolygonMesh) -> PatchNets:
    """Return the patches of a mesh of quads.

    Parameters
    ----------
    mesh : PolygonMesh
        A mesh of quads alone; `quads_of` makes one of any other.

    Returns
    -------
    PatchNets
        In the order of the quads. u runs from a quad's first corner to its second, v to its last.

    Raises
    ------
    InputError
        If a face is no quad.

    Notes
    -----
    Where all four corners are regular (four quads round them, two on a boundary or crease, one at a
    corner) the patch is the Catmull-Clark limit surface itself, a bicubic B-spline. Elsewhere the
    corners are on it, but the patches meet with small kinks. Neighbors share their edge's four
    control points everywhere.

    Along the boundary and along creases the surface ends in the cubic B-spline of its polygon.
    Corners stay where they are (`PolygonMesh.corner_vertices`). A crease that ends inside the
    surface fades out; its end lies on the limit surface.
    """
    if (mesh.sizes != 4).any():
        raise InputError("a face is no quad; expected four corners in each")
    quads = mesh.corners.reshape(-1, 4)
    inner = _inner_points(mesh)
    edge_points = _edge_points(mesh, inner)
    corner_points = _corner_points(mesh, inner)

    # An edge has two points, the first beside its lower vertex.
    edge_number = len(corner_points) + 2 * mesh.edge
    upwards = mesh.corners < mesh.heads
    near_tail = (edge_number + ~upwards).reshape(-1, 4)
    near_head = (edge_number + upwards).reshape(-1, 4)
    inner_number = len(corner_points) + len(edge_points) + np.arange(quads.size).reshape(-1, 4)
    index = np.empty((len(quads), 4, 4), dtype=np.int64)
    for k in range(4):
        index[:, *_CORNER[k]] = quads[:, k]
        index[:, *_TO_NEXT[k]] = near_tail[:, k]
        index[:, *_TO_LAST[k]] = near_head[:, k - 1]
        index[:, *_INNER[k]] = inner_number[:, k]
    return PatchNets(np.concatenate([corner_points, edge_points, inner]), index)


def vertex_limits(mesh: PolygonMesh) -> Array:
    """Return the limits of the vertices of a mesh of quads on its surface, shape (vertices, 3).

    Vertices without a face have none, and are 0.
    """
    return _corner_points(mesh, _inner_points(mesh))


def _inner_points(mesh: PolygonMesh) -> Array:
    """The inner control point beside each corner of each quad, shape (corners, 3)."""
    vertices, corners = mesh.vertices, mesh.corners
    opposite = mesh.following[mesh.following]
    # A quad is a quarter of the way round a smooth vertex if it is one of four, round a crease if
    # it is one of two. A corner weighs the same however many quads lie round it, and so does a
    # crease that turns round one: against repeated subdivision this is close to the best.
    quads = np.bincount(mesh.sector)[mesh.sector]
    along = mesh.crease_vertices[corners]
    weight = np.where(along, 2 * np.maximum(quads, 2), quads)
    weight = np.where(mesh.corner_vertices[corners], 4, weight)[:, None]
    total = (
        weight * vertices[corners]
        + 2.0 * (vertices[mesh.heads] + vertices[corners[mesh.preceding]])
        + vertices[corners[opposite]]
    )
    inner = np.asarray(total / (weight + 5.0))
    # Their mean is the limit of a smooth vertex; where a crease ends, they follow the limit.
    darts, limits = dart_limits(mesh)
    if len(darts):
        moved = np.zeros_like(vertices)
        moved[darts] = limits - _means(mesh, inner)[darts]
        inner += moved[corners]
    return inner


def _means(mesh: PolygonMesh, inner: Array) -> Array:
    """The mean of the inner control points round each vertex, shape (vertices, 3)."""
    count = len(mesh.vertices)
    faces = np.bincount(mesh.corners, minlength=count)[:, None]
    return np.asarray(sum_at(mesh.corners, inner, count) / np.maximum(faces, 1))


def _edge_points(mesh: PolygonMesh, inner: Array) -> Array:
    """The two control points inside each edge, shape (2 edges, 3)."""
    upwards = mesh.corners < mesh.heads
    # Beside each half-edge lie two inner points, one at its tail and one at its head.
    number = 2 * mesh.edge
    at = np.concatenate([number + ~upwards, number + upwards])
    beside = np.concatenate([inner, inner[mesh.following]])
    smooth = sum_at(at, beside, 2 * len(mesh.ends)) / np.repeat(mesh.sides, 2)[:, None]
    # On sharp edges, the points are those of the cubic B-spline curve.
    own = mesh.vertices[mesh.ends].reshape(-1, 3)
    other = mesh.vertices[mesh.ends[:, ::-1]].reshape(-1, 3)
    follows = (
        np.repeat(mesh.sharp, 2) & (mesh.crease_vertices | mesh.corner_vertices)[mesh.ends.ravel()]
    )
    return np.where(follows[:, None], (2.0 * own + other) / 3.0, smooth)


def _corner_points(mesh: PolygonMesh, inner: Array) -> Array:
    """Return the limit of each vertex, shape (vertices, 3)."""
    count, points = len(mesh.vertices), _means(mesh, inner)
    ends = mesh.ends[mesh.sharp]
    neighbors = sum_at(ends.ravel(), mesh.vertices[ends[:, ::-1]].reshape(-1, 3), count)
    curve = (4.0 * mesh.vertices + neighbors) / 6.0
    points = np.where(mesh.crease_vertices[:, None], curve, points)
    return np.where(mesh.corner_vertices[:, None], mesh.vertices, points)
