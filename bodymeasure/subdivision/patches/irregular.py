"""The quads of a mesh whose patches only approximate the surface, and their neighborhood."""

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.subdivision.polygon_mesh import PolygonMesh, joined_corners
from bodymeasure.subdivision.polygons import refined


def irregular_quads(mesh: PolygonMesh) -> Bools:
    """Return the quads of a mesh whose patch is not the Catmull-Clark surface itself.

    A corner is regular with four quads round it, with two on one side of a crease or of the
    boundary, and with one between two sharp edges at a vertex that stays where it is.

    Parameters
    ----------
    mesh : PolygonMesh
        A mesh of quads alone.

    Returns
    -------
    ndarray of bool, shape (quads,)
    """
    corners = mesh.corners
    quads = np.bincount(mesh.sector)[mesh.sector]
    expected = np.where(mesh.crease_vertices[corners], 2, 4)
    expected = np.where(mesh.corner_vertices[corners], 1, expected)
    irregular = (quads != expected) | mesh.darts[corners]
    return np.asarray(irregular.reshape(-1, 4).any(axis=1))


def neighborhood(mesh: PolygonMesh, chosen: Bools) -> tuple[PolygonMesh, Ints]:
    """Return the part of a mesh that determines the surface over some of its quads.

    It consists of these quads and of all that share a vertex with them. Where others would touch
    at a vertex alone, each gets a vertex of its own; the surface over the chosen quads stays.

    Returns
    -------
    mesh : PolygonMesh
    numbers : ndarray of int
        The numbers of the chosen quads in it.
    """
    touched = np.zeros(len(mesh.vertices), dtype=np.bool_)
    touched[mesh.corners[chosen[mesh.face]]] = True
    kept = np.zeros(len(mesh.sizes), dtype=np.bool_)
    kept[mesh.face[touched[mesh.corners]]] = True
    if kept.all():
        return mesh, np.flatnonzero(chosen)
    half_edges = kept[mesh.face]
    inside = np.bincount(mesh.edge[half_edges], minlength=len(mesh.sides)) == 2
    fan = joined_corners(mesh, inside)
    _, first, corners = np.unique(fan[half_edges], return_index=True, return_inverse=True)
    vertices = mesh.corners[half_edges][first]
    number = np.full(len(mesh.corners), -1)
    number[half_edges] = corners
    creased = np.flatnonzero(half_edges & mesh.sharp[mesh.edge] & (mesh.sides[mesh.edge] == 2))
    part = PolygonMesh(
        mesh.vertices[vertices],
        corners,
        mesh.sizes[kept],
        np.stack([number[creased], number[mesh.following[creased]]], axis=-1),
        tagged=np.flatnonzero(np.isin(vertices, list(mesh.tagged))).tolist(),
        rounded=mesh.rounded,
    )
    return part, np.flatnonzero(chosen[kept])


def subdivided(mesh: PolygonMesh, numbers: Ints, steps: int) -> tuple[PolygonMesh, Ints, Array]:
    """Subdivide a mesh of quads, and return what becomes of some of its quads.

    Returns
    -------
    mesh : PolygonMesh
        The mesh after so many steps.
    children : ndarray of int, shape (quads, 4**steps)
        The numbers in it of the quads into which each of the chosen ones is divided.
    places : ndarray, shape (4**steps, 4, 2)
        (u, v) on the quad of the corners of its children.
    """
    children = numbers[:, None]
    places = np.array([[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]])
    for _ in range(steps):
        mesh = refined(mesh)
        children = (4 * children[..., None] + np.arange(4)).reshape(len(numbers), -1)
        places = children_places(places)
    return mesh, children, places


def children_places(places: Array) -> Array:
    """Return (u, v) of the corners of the four children of quads, shape (4 quads, 4, 2)."""
    middle = (places + np.roll(places, -1, axis=1)) / 2.0
    center = np.broadcast_to(places.mean(axis=1, keepdims=True), places.shape)
    children = [places, middle, center, np.roll(middle, 1, axis=1)]
    return np.stack(children, axis=2).reshape(-1, 4, 2)
