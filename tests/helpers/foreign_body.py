"""Bodies of a topology that is not ours: the dual of our mesh, with its vertices on the surface."""

from functools import cache

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.fit.model import body_model
from bodymeasure.subdivision import QuadMesh, limit_positions, subdivide


def foreign_vertices(vertices: Array) -> Array:
    """Points of the surface in the middle of each quad, in another order; shape (13378, 3)."""
    mesh = subdivide(QuadMesh(vertices, body_model().quads))
    return limit_positions(mesh)[-len(body_model().quads) :][_order()]


@cache
def foreign_triangles() -> Ints:
    """Each of our vertices is a polygon of the quads about it, cut into triangles."""
    quads = body_model().quads
    # From the quad that ends in an edge at a corner to the one that begins with it.
    number, count = np.arange(len(quads)), len(body_model().mean)
    corners, following = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    quad = np.repeat(number, 4)
    begins = dict(zip((corners * count + following).tolist(), quad.tolist(), strict=True))
    beside = np.array([begins[key] for key in (following * count + corners).tolist()])
    # About each corner, the next quad lies across its side that ends there.
    after = np.roll(beside.reshape(-1, 4), 1, axis=1).ravel()
    rings: dict[int, dict[int, int]] = {}
    for corner, one, other in zip(corners.tolist(), quad.tolist(), after.tolist(), strict=True):
        rings.setdefault(corner, {})[one] = other
    triangles = []
    for ring in rings.values():
        first = next(iter(ring))
        at = ring[first]
        while ring[at] != first:
            triangles.append([first, at, ring[at]])
            at = ring[at]
    place = np.empty_like(_order())
    place[_order()] = np.arange(len(place))
    return np.asarray(place[np.array(triangles)])


@cache
def _order() -> Ints:
    return np.random.default_rng(7).permutation(len(body_model().quads))
