"""Triangles turned so that they are seen counterclockwise from outside, each piece by itself.

Scanners give bodies in pieces, of which some may be inside out; a fit that believes their normals
puts arms behind the back.
"""

from typing import Any

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.errors import MissingExtraError
from bodymeasure.fit.scan.weld import area_vectors

# A part whose volume about its own middle is less than this part of that of a cube with its area is
# nearly flat, and its volume does not tell its sides apart. That of a ball is 0.094.
FLAT = 0.003


def oriented(vertices: Array, triangles: Ints) -> tuple[Ints, Ints, Bools]:
    """Return triangles turned outwards.

    Neighbors are made to agree across edges of two triangles. Each part that is joined by such
    edges is then turned so that its volume about its own middle is positive, which holds for open
    parts, too, as long as they bulge; flat parts are turned as the closest others.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    triangles : ndarray of int, shape (m, 3)

    Returns
    -------
    triangles : ndarray of int, shape (m, 3)
    part : ndarray of int, shape (m,)
        The part of each triangle.
    turned : ndarray of bool, shape (m,)
        Which triangles were turned round.
    """
    agreeing, part = _agreeing(triangles)
    areas = area_vectors(vertices, agreeing)
    area = np.linalg.norm(areas, axis=1)
    whole = np.bincount(part, area)
    volume = _volumes(vertices, agreeing, part, areas, area)
    inward = volume < 0.0
    flat = np.abs(volume) < FLAT * whole**1.5
    areas[inward[part]] *= -1.0
    if flat.any() and not flat.all():
        against = _against_others(vertices[agreeing].mean(axis=1), areas, part, flat)
        inward ^= flat & against
    result = np.where(inward[part][:, None], agreeing[:, ::-1], agreeing)
    turned = _sense(result) != _sense(triangles)
    return result, part, turned


def _agreeing(triangles: Ints) -> tuple[Ints, Ints]:
    """Return triangles that agree with their neighbors, and the part of each."""
    first, second, agree = _neighbors(triangles)
    if agree.all():
        ones = np.ones(len(first), dtype=np.int8)
        links = scipy.sparse.coo_array((ones, (first, second)), shape=(len(triangles),) * 2)
        part = scipy.sparse.csgraph.connected_components(links, directed=False)[1]
        return triangles, np.asarray(part, dtype=np.int64)
    try:
        import igl
    except ImportError:
        raise MissingExtraError("orienting a mesh", "libigl", "fit") from None
    found: Any = igl.bfs_orient(np.ascontiguousarray(triangles))
    return np.asarray(found[0], dtype=np.int64), np.asarray(found[1], dtype=np.int64)


def _neighbors(triangles: Ints) -> tuple[Ints, Ints, Bools]:
    """Return the two triangles of each edge that has two, and whether they run against each other.

    Neighbors that are turned the same way run along their edge in opposite directions.
    """
    start, end = triangles.reshape(-1), np.roll(triangles, -1, axis=1).reshape(-1)
    forward = start < end
    keys = np.where(
        forward, start * (triangles.max() + 1) + end, end * (triangles.max() + 1) + start
    )
    order = np.argsort(keys, kind="stable")
    _, begin, count = np.unique(keys[order], return_index=True, return_counts=True)
    begin = begin[count == 2]
    one, other = order[begin], order[begin + 1]
    return one // 3, other // 3, np.asarray(forward[one] != forward[other])


def _volumes(vertices: Array, triangles: Ints, part: Ints, areas: Array, area: Array) -> Array:
    """Return the volume of each part about its own centroid."""
    centers = vertices[triangles].mean(axis=1)
    weights = np.bincount(part, area)
    middle = np.stack(
        [np.bincount(part, area * centers[:, axis]) / weights for axis in range(3)], axis=1
    )
    heights = np.einsum("ij,ij->i", centers - middle[part], areas)
    return np.asarray(np.bincount(part, heights) / 3.0)


def _against_others(centers: Array, areas: Array, part: Ints, flat: Bools) -> Bools:
    """Return which parts face against the triangles of parts that are not flat, next to them."""
    known = ~flat[part]
    near = scipy.spatial.KDTree(centers[known]).query(centers[~known])[1]
    agreement = np.zeros(len(part))
    lengths = np.linalg.norm(areas[known], axis=1)[near]
    agreement[~known] = np.einsum("ij,ij->i", areas[~known], areas[known][near]) / lengths
    return np.asarray(np.bincount(part, agreement) < 0.0)


def _sense(triangles: Ints) -> Bools:
    """Return which way round triangles have their corners, from the least: up or down."""
    first = np.argmin(triangles, axis=1)
    row = np.arange(len(triangles))
    return np.asarray(triangles[row, (first + 1) % 3] < triangles[row, (first + 2) % 3])
