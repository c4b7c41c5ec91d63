"""A correspondence from one fit: each point of the fitted surface as a place on the other mesh.

The point of our surface at each vertex is written by the barycentric coordinates of the closest
point of the mesh. On another body of the topology these points lie on its triangles, and our
vertices are those whose surface runs through them. Where the mesh has no surface that belongs to
ours, as within the mouth, points are carried by the affine map that suits the rim of that region
best, so that the region turns and grows with its surroundings.
"""

from dataclasses import replace

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas import tessellate
from bodymeasure.errors import FitError, MissingExtraError
from bodymeasure.fit.model import atlas_of_vertices, body_model
from bodymeasure.fit.topology.correspondence import (
    Gives,
    Topology,
    edge_keys,
    mapped_vertices,
)
from bodymeasure.fit.topology.polygons import Polygons
from bodymeasure.fit.topology.surface import sample_matrix

# A fit lies within a millimeter of its mesh; what is farther away than these meters is other
# surface, or none.
NEAR = 0.008
# The cosine of the largest angle between the normals of points that belong together.
FACING = 0.5
# Weights below this are zero but for rounding.
INSIDE = 1e-6
# Each point of a region without surface takes so many of the nearest into its rim, so that the rim
# has extent in all directions.
RIM = 12
# A rim that is flat to this part of its size says nothing of the direction across.
FLAT = 1e-3
# Less than this share of the part that the atlas covers is no whole body.
LEAST_SHARE = 0.97
# Steps along a patch's side at which the accuracy is measured.
SEGMENTS = 4
# Weights are stored with single precision.
DIGITS = np.float32


def topology_of_fit(mesh: Polygons, vertices: Array, fitted: Array, name: str) -> Topology:
    """Return the correspondence between a mesh and our quad mesh, fitted to it.

    Parameters
    ----------
    mesh : Polygons
    vertices : ndarray, shape (n, 3)
        The mesh's vertices in meters, in the frame of the fit.
    fitted : ndarray, shape (13380, 3)
        Control vertices.
    name : str
        What the topology is called.

    Raises
    ------
    FitError
        If too little of the fitted surface lies on the mesh.
    """
    points = sample_matrix() @ fitted
    corners, weights, near = _places(vertices, mesh.triangles, points, _normals(points))
    model = body_model()
    share = float(near[: len(model.mean)][np.unique(model.quads[model.covered])].mean())
    if share < LEAST_SHARE:
        raise FitError(
            f"only {100.0 * share:.0f} % of the fitted body lies on the mesh; expected "
            f"{100.0 * LEAST_SHARE:.0f} % at least; fit a whole body of the model in its rest pose"
        )
    rows = np.repeat(np.flatnonzero(near), 3)
    on_mesh = csr_matrix(
        (weights[near].ravel(), (rows, corners[near].ravel())), shape=(len(points), len(vertices))
    )
    carried = _carried(points, near) @ on_mesh
    total = (on_mesh + carried).tocsr()
    total.data = total.data.astype(DIGITS).astype(np.float64)
    made = Topology(
        name=name,
        edges=np.unique(np.sort(mesh.edges, axis=1), axis=0),
        points=total,
        gives=Gives.SAMPLES,
        source=f"Mapped by the correspondence of the topology {name!r}, made from one fit.",
        accuracy=0.0,
    )
    atlas = tessellate(atlas_of_vertices(mapped_vertices(vertices, made)), SEGMENTS)
    squares = _nearest(atlas.vertices, vertices, mesh.triangles)[0]
    return replace(made, accuracy=float(np.sqrt(squares.mean())))


def _places(
    vertices: Array, triangles: Ints, points: Array, normals: Array
) -> tuple[Ints, Array, Bools]:
    """Return corners (k, 3), barycentric weights (k, 3) and whether a place belongs to a point."""
    squares, face, nearest = _nearest(points, vertices, triangles)
    corners = triangles[face]
    a, b, c = np.moveaxis(vertices[corners], 1, 0)
    across = np.cross(b - a, c - a)
    double = np.maximum((across * across).sum(axis=1), 1e-30)
    second = (np.cross(nearest - a, c - a) * across).sum(axis=1) / double
    third = (np.cross(b - a, nearest - a) * across).sum(axis=1) / double
    weights = np.clip(np.stack([1.0 - second - third, second, third], axis=1), 0.0, 1.0)
    weights /= weights.sum(axis=1, keepdims=True)
    agree = (across * normals).sum(axis=1) / np.sqrt(double)
    # What is closest to a rim of the mesh lies beyond it.
    beyond = (weights * _on_rim(triangles, len(vertices))[corners]).sum(axis=1) > 1.0 - INSIDE
    return corners, weights, (np.sqrt(squares) < NEAR) & (agree > FACING) & ~beyond


def _nearest(points: Array, vertices: Array, triangles: Ints) -> tuple[Array, Ints, Array]:
    """Return squared distances from a mesh, the closest triangles, and the closest points."""
    try:
        import igl
    except ImportError:
        raise MissingExtraError("a correspondence", "libigl", "fit") from None
    squares, face, nearest = igl.point_mesh_squared_distance(points, vertices, triangles)[:3]
    return squares, face, nearest


def _on_rim(triangles: Ints, count: int) -> Bools:
    """Return which vertices are ends of an edge that one triangle alone has."""
    ends = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    _, first, times = np.unique(edge_keys(ends, count), return_index=True, return_counts=True)
    result = np.zeros(count, dtype=np.bool_)
    result[ends[first[times == 1]]] = True
    return result


def _normals(points: Array) -> Array:
    """Unit normals of our mesh at its samples, outwards."""
    quads = body_model().quads
    first, second, third, fourth = np.moveaxis(points[quads], 1, 0)
    areas = np.cross(third - first, fourth - second)
    sums = np.zeros((len(points) - len(quads), 3))
    np.add.at(sums, quads, areas[:, None])
    normals = np.concatenate([sums, areas])
    return np.asarray(normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30))


def _carried(points: Array, near: Bools) -> csr_matrix:
    """Return weights, (26758, 26758), of points on the mesh for those that are not."""
    quads, count = body_model().quads, len(points)
    rows: list[Ints] = []
    columns: list[Ints] = []
    values: list[Array] = []
    # The middle of a quad is beside its corners.
    middles = np.repeat(np.arange(count - len(quads), count), 4)
    beside = np.stack([quads.ravel(), middles], axis=1)
    off = beside[~near[beside].any(axis=1)]
    links = csr_matrix((np.ones(len(off)), (off[:, 0], off[:, 1])), shape=(count, count))
    region = np.where(near, -1, connected_components(links, directed=False)[1])
    tree, on = cKDTree(points[near]), np.flatnonzero(near)
    for number in np.unique(region[~near]):
        inside = np.flatnonzero(region == number)
        touching = beside[(region[beside] == number).any(axis=1)]
        around = on[tree.query(points[inside], RIM)[1].ravel()]
        rim = np.union1d(touching[near[touching]], around)
        # The weights of least squares that keep affine functions.
        middle = points[rim].mean(axis=0)
        known = np.column_stack([np.ones(len(rim)), points[rim] - middle])
        wanted = np.column_stack([np.ones(len(inside)), points[inside] - middle])
        weights = wanted @ np.linalg.pinv(known, rcond=FLAT)
        rows.append(np.repeat(inside, len(rim)))
        columns.append(np.tile(rim, len(inside)))
        values.append(weights.ravel())
    if not rows:
        return csr_matrix((count, count))
    where = (np.concatenate(rows), np.concatenate(columns))
    return csr_matrix((np.concatenate(values), where), shape=(count, count))
