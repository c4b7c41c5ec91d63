"""The check of a mesh before libigl sees it."""

from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError

# The least that twice a face's area may be, relative to the square of its longest edge. Coordinates
# are rounded to 1e-16 of the mesh's size, which is up to 1e3 times that of a face; below this, a
# face's height is nothing but rounding.
DEGENERATE_AREA = 1e-12


def validate_mesh(vertices: ArrayLike, faces: ArrayLike) -> None:
    """Refuse a mesh that libigl would crash on or answer with a silent zero.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
    faces : array_like of int, shape (f, 3)

    Raises
    ------
    InputError
        If the mesh is not one piece of finite, oriented, manifold triangles that use every
        vertex; the message names the first vertex, edge or face that is wrong.
    """
    points, corners = _checked_arrays(np.asarray(vertices), np.asarray(faces))
    _check_faces(points, corners)
    _check_topology(corners.tobytes())


def _checked_arrays(
    vertices: NDArray[np.generic], faces: NDArray[np.generic]
) -> tuple[Array, Ints]:
    if vertices.ndim != 2 or vertices.shape[1] != 3 or vertices.dtype.kind not in "fiu":
        raise InputError(
            f"mesh vertices have shape {vertices.shape} and type {vertices.dtype}; "
            "expected (n, 3) real numbers"
        )
    if faces.ndim != 2 or faces.shape[1] != 3 or len(faces) == 0 or faces.dtype.kind not in "iu":
        raise InputError(
            f"mesh faces have shape {faces.shape} and type {faces.dtype}; "
            "expected (f, 3) whole numbers, at least one face"
        )
    points = vertices.astype(np.float64)
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(bad):
        raise InputError(
            f"mesh vertex {bad[0]} is {points[bad[0]].tolist()}; expected finite coordinates"
        )
    return points, faces.astype(np.int64)


def _check_faces(vertices: Array, faces: Ints) -> None:
    outside = np.flatnonzero(((faces < 0) | (faces >= len(vertices))).any(axis=1))
    if len(outside):
        raise InputError(
            f"mesh face {outside[0]} is {faces[outside[0]].tolist()}, but the vertices are "
            f"numbered 0 to {len(vertices) - 1}"
        )
    unused = np.flatnonzero(np.bincount(faces.ravel(), minlength=len(vertices)) == 0)
    if len(unused):
        raise InputError(f"mesh vertex {unused[0]} belongs to no face; remove it")
    corners = vertices[faces]
    sides = np.roll(corners, -1, axis=1) - corners
    area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=-1)
    longest = np.square(sides).sum(axis=-1).max(axis=-1)
    flat = np.flatnonzero(~(area > DEGENERATE_AREA * longest))
    if len(flat):
        raise InputError(
            f"mesh face {flat[0]} ({faces[flat[0]].tolist()}) has no area; "
            "remove it and join its vertices"
        )


@lru_cache(maxsize=64)
def _check_topology(faces: bytes) -> None:
    """Check edges, fans and pieces; cached, since the meshes of many patches share their faces."""
    corners = np.frombuffer(faces, dtype=np.int64).reshape(-1, 3)
    _check_connection(corners, _check_edges(corners))


def _check_edges(faces: Ints) -> Ints:
    """Pairs of half-edges that lie on one edge, shape (interior edges, 2).

    Half-edge 3 f + k runs from corner k of face f to the next.
    """
    tail = faces.ravel()
    head = np.roll(faces, -1, axis=1).ravel()
    low, high = np.minimum(tail, head), np.maximum(tail, head)
    order = np.lexsort((high, low))
    starts = np.flatnonzero(np.r_[True, (np.diff(low[order]) != 0) | (np.diff(high[order]) != 0)])
    uses = np.diff(np.r_[starts, len(order)])
    crowded = np.flatnonzero(uses > 2)
    if len(crowded):
        first = order[starts[crowded[0]]]
        around = order[starts[crowded[0]] :][: uses[crowded[0]]] // 3
        raise InputError(
            f"mesh edge ({low[first]}, {high[first]}) belongs to {len(around)} faces "
            f"({', '.join(map(str, around))}); expected at most 2 (a manifold)"
        )
    shared = starts[uses == 2]
    pairs = np.stack([order[shared], order[shared + 1]], axis=-1)
    same = np.flatnonzero(tail[pairs[:, 0]] == tail[pairs[:, 1]])
    if len(same):
        first, second = pairs[same[0]]
        raise InputError(
            f"mesh faces {first // 3} and {second // 3} run along their edge "
            f"({tail[first]}, {head[first]}) in the same direction; "
            "expected a mesh that is oriented throughout"
        )
    return pairs


def _check_connection(faces: Ints, pairs: Ints) -> None:
    count = len(faces)
    one, other = (pairs // 3).T
    pieces, piece = _components(count, one, other)
    vertex = faces.ravel()

    # Corners of one vertex are joined where their faces share an edge: one fan, one component.
    half, twin = pairs.T
    fans, fan = _components(
        3 * count,
        np.concatenate([half, _next_corner(half)]),
        np.concatenate([_next_corner(twin), twin]),
    )
    if fans > vertex.max() + 1:
        first_fan = np.full(vertex.max() + 1, -1)
        first_fan[vertex[::-1]] = fan[::-1]
        torn = vertex[np.flatnonzero(fan != first_fan[vertex])[0]]
        around = np.flatnonzero((faces == torn).any(axis=1))
        raise InputError(
            f"the faces around mesh vertex {torn} form more than one fan "
            f"(faces {', '.join(map(str, around))}); expected a manifold"
        )
    if pieces > 1:
        lone = int(np.flatnonzero(piece != piece[0])[0])
        raise InputError(
            f"the mesh falls into {pieces} pieces: no path leads from face 0 to face {lone}; "
            "pass one piece"
        )


def _next_corner(half_edge: Ints) -> Ints:
    return half_edge - half_edge % 3 + (half_edge + 1) % 3


def _components(count: int, one: Ints, other: Ints) -> tuple[int, NDArray[np.int32]]:
    graph = coo_array((np.ones(len(one), dtype=np.int8), (one, other)), shape=(count, count))
    number, label = connected_components(graph, directed=False)
    return int(number), label
