"""Catmull-Clark subdivision and its limit.

E. Catmull and J. Clark, "Recursively generated B-spline surfaces on arbitrary topological meshes",
Computer-Aided Design 10 (1978): on a regular mesh the limit is the bicubic B-spline surface with
the mesh as its control points. The boundary's limit is the cubic B-spline curve of its polygon, as
H. Biermann, A. Levin and D. Zorin have it, "Piecewise smooth subdivision surfaces with normal
control", SIGGRAPH 2000; corners are rounded like the rest of it.
"""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError
from bodymeasure.subdivision.quad_mesh import QuadMesh
from bodymeasure.subdivision.sums import sum_at


def subdivide(mesh: QuadMesh) -> QuadMesh:
    """Do one step of Catmull-Clark subdivision.

    Returns
    -------
    QuadMesh
        Vertices: those of `mesh` in their new places, then one for each edge, then one for each
        quad. Quad f becomes the quads 4 f to 4 f + 3; the child 4 f + k begins at corner k of f.
    """
    vertices, quads, edges = mesh.vertices, mesh.quads, mesh.edges
    quad_points = vertices[quads].mean(axis=1)
    midpoints = vertices[edges.ends].mean(axis=1)

    across = sum_at(edges.of_side, quad_points, len(edges.ends)) / 2.0
    boundary = edges.boundary[:, None]
    edge_points = np.where(boundary, midpoints, (midpoints + across) / 2.0)

    # Round an inner vertex there are as many quads as edges.
    valence = np.bincount(quads.ravel())[:, None]
    quad_mean = sum_at(quads, quad_points, len(vertices)) / valence
    edge_mean = sum_at(edges.ends, midpoints, len(vertices)) / valence
    moved = (quad_mean + 2.0 * edge_mean + (valence - 3.0) * vertices) / valence
    on_boundary, neighbors = _boundary_neighbors(mesh)
    moved[on_boundary] = (6.0 * vertices[on_boundary] + neighbors) / 8.0

    edge_number = len(vertices) + edges.of_side
    quad_number = len(vertices) + len(edges.ends) + np.arange(len(quads))
    middle = np.broadcast_to(quad_number[:, None], quads.shape)
    children = np.stack([quads, edge_number, middle, np.roll(edge_number, 1, axis=1)], axis=-1)
    return QuadMesh(np.concatenate([moved, edge_points, quad_points]), children.reshape(-1, 4))


def limit_positions(mesh: QuadMesh) -> Array:
    """Return the limits of the vertices of a mesh on its Catmull-Clark surface.

    Returns
    -------
    ndarray, shape (n, 3)

    Notes
    -----
    For a vertex V of valence n, with E the sum of its n neighbors along edges and F that of the n
    opposite corners of its quads, the limit is ``(n^2 V + 4 E + F) / (n (n + 5))``: M. Halstead,
    M. Kass, T. DeRose, *Efficient, fair interpolation using Catmull-Clark surfaces*, SIGGRAPH 1993,
    section 4.1. On the boundary it is ``(4 V + A + B) / 6`` with the neighbors along it, as on
    every cubic B-spline curve.
    """
    vertices, quads = mesh.vertices, mesh.quads
    valence = np.bincount(quads.ravel())[:, None]
    # Inside the mesh, each neighbor along an edge is the next corner of exactly one quad.
    following, opposite = vertices[np.roll(quads, -1, axis=1)], vertices[np.roll(quads, 2, axis=1)]
    around = np.stack([4.0 * following, opposite], axis=2).transpose(1, 2, 0, 3)
    total = sum_at(
        np.concatenate([np.arange(len(vertices)), np.repeat(quads.T, 2, axis=0).ravel()]),
        np.concatenate([valence**2 * vertices, around.reshape(-1, 3)]),
        len(vertices),
    )
    limit = total / (valence * (valence + 5))
    on_boundary, beside = _boundary_neighbors(mesh)
    limit[on_boundary] = (4.0 * vertices[on_boundary] + beside) / 6.0
    return np.asarray(limit)


def _boundary_neighbors(mesh: QuadMesh) -> tuple[Ints, Array]:
    """Vertices on the boundary, and for each the sum of its two neighbors along it."""
    ends = mesh.edges.ends[mesh.edges.boundary]
    count = np.bincount(ends.ravel(), minlength=len(mesh.vertices))
    pinched = np.flatnonzero(count > 2)
    if len(pinched):
        raise InputError(
            f"{count[pinched[0]]} boundary edges meet at mesh vertex {pinched[0]}; expected 2: "
            "the quads round it have to form one fan"
        )
    on_boundary = np.flatnonzero(count)
    sums = sum_at(ends, mesh.vertices[ends[:, ::-1]], len(mesh.vertices))
    return on_boundary, sums[on_boundary]
