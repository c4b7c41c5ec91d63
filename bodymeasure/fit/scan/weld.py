"""Vertices joined by position, and triangles without area dropped."""

from typing import Any

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.errors import InputError
from bodymeasure.fit.scan.load import Triangles
from bodymeasure.wording import counted

# Vertices closer than these meters are one: scanners do not tell them apart, and files that repeat
# a vertex round it alike.
SAME = 1e-5
# Vertices farther from the middle than so many times the distance within which 95 % of them lie
# belong to a damaged or wild triangle: even the hands of a body are within three times.
FAR = 20.0
_WITHIN = 95.0


def welded(found: Triangles) -> Triangles:
    """Return a mesh with each position once, without triangles that have no place or no area.

    Parameters
    ----------
    found : Triangles
        In meters.

    Raises
    ------
    InputError
        If nothing is left.
    """
    vertices, triangles, notes = found.vertices, found.triangles, list(found.notes)
    finite: Bools = np.asarray(np.isfinite(vertices).all(axis=1))
    if not finite.all():
        lost = ~finite[triangles].all(axis=1)
        notes.append(
            f"Dropped {counted(int(lost.sum()), 'triangle')} at "
            f"{counted(int((~finite).sum()), 'vertex', 'vertices')} whose coordinates are not "
            "finite."
        )
        triangles = triangles[~lost]
    if not len(triangles):
        raise InputError("no triangle has finite coordinates; export the mesh again")
    vertices, triangles = used_only(vertices, triangles)
    wild = _wild(vertices)[triangles].any(axis=1)
    if wild.any():
        notes.append(
            f"Dropped {counted(int(wild.sum()), 'triangle')} that lie or lead far away from all "
            "others."
        )
        vertices, triangles = used_only(vertices, triangles[~wild])
    first, number = _positions(vertices)
    if len(first) < len(vertices):
        notes.append(
            f"Welded {counted(len(vertices), 'vertex', 'vertices')} by position to {len(first):,}."
        )
        vertices, triangles = vertices[first], number[triangles]
    kept = _with_area(vertices, triangles)
    if not kept.all():
        notes.append(f"Dropped {counted(int((~kept).sum()), 'triangle')} without area.")
        triangles = triangles[kept]
    if not len(triangles):
        raise InputError("all triangles are without area; export the mesh again")
    triangles, repeated = _once(triangles)
    if repeated:
        notes.append(f"Dropped {counted(repeated, 'triangle')} that repeat others.")
    return Triangles(*used_only(vertices, triangles), tuple(notes))


def used_only(vertices: Array, triangles: Ints) -> tuple[Array, Ints]:
    """Return a mesh without the vertices that no triangle has."""
    used = np.zeros(len(vertices), dtype=np.bool_)
    used[triangles] = True
    number = np.cumsum(used) - 1
    return vertices[used], number[triangles]


def _wild(vertices: Array) -> Bools:
    """Return which vertices are far from the others."""
    with np.errstate(over="ignore"):
        away = np.linalg.norm(vertices - np.median(vertices, axis=0), axis=1)
        return np.asarray(away > FAR * np.percentile(away, _WITHIN))


def _positions(vertices: Array) -> tuple[Ints, Ints]:
    """Return one vertex of each position, in order, and the position's number of each vertex."""
    rounded = np.round(vertices / SAME).astype(np.int64)
    rounded -= rounded.min(axis=0)
    sizes = rounded.max(axis=0) + 1
    # One whole number for each position, as long as there is room for it, is found much faster.
    keys: Any = rounded
    if np.prod(sizes.astype(np.float64)) < 2.0**62:
        keys = (rounded[:, 0] * sizes[1] + rounded[:, 1]) * sizes[2] + rounded[:, 2]
    _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    number = np.empty(len(order), dtype=np.int64)
    number[order] = np.arange(len(order))
    return first[order], number[inverse.reshape(-1)]


def _with_area(vertices: Array, triangles: Ints) -> Bools:
    """Return which triangles have three corners and an area."""
    a, b, c = triangles.T
    distinct = (a != b) & (b != c) & (c != a)
    double = np.linalg.norm(area_vectors(vertices, triangles), axis=1)
    return np.asarray(distinct & (double > SAME**2))


def _once(triangles: Ints) -> tuple[Ints, int]:
    """Return the triangles without those that have the corners of an earlier one, and how many."""
    count = int(triangles.max()) + 1
    low, middle, high = np.sort(triangles, axis=1).T
    # Pairs of vertices get numbers first, as the product of three counts might not fit.
    pairs = np.unique(low * count + middle, return_inverse=True)[1]
    first = np.unique(pairs * count + high, return_index=True)[1]
    return triangles[np.sort(first)], len(triangles) - len(first)


def area_vectors(vertices: Array, triangles: Ints) -> Array:
    """Return the normals of triangles, each as long as its area, shape (m, 3)."""
    a, b, c = (vertices[triangles[:, corner]] for corner in range(3))
    return np.asarray(0.5 * np.cross(b - a, c - a))


def pieces(vertices: Array, triangles: Ints) -> Ints:
    """Return the number of the piece of each triangle; a piece is joined by its vertices."""
    a, b, c = triangles.T
    rows, columns = np.concatenate([a, b]), np.concatenate([b, c])
    ones = np.ones(len(rows), dtype=np.int8)
    links = scipy.sparse.coo_array((ones, (rows, columns)), shape=(len(vertices),) * 2)
    of_vertex = scipy.sparse.csgraph.connected_components(links, directed=False)[1]
    return np.asarray(np.unique(of_vertex[a], return_inverse=True)[1], dtype=np.int64)
