"""Ways over triangle meshes pulled straight, compiled."""

import ctypes
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Complex, Ints
from bodymeasure.native.library import address, kernels

# The most faces of a strip: so many, and so many more for each vertex that it begins along.
MOST_FACES, MORE_FACES = 1000, 16


class _Triangles(ctypes.Structure):
    """`Triangles` of ``straight_way.cpp``."""

    _fields_ = tuple(
        (name, ctypes.c_void_p) for name in ("faces", "over", "apex", "angle", "vertices")
    )


class _Way(ctypes.Structure):
    """`Way` of ``straight_way.cpp``."""

    _fields_ = (
        ("count", ctypes.c_int64),
        ("vertices", ctypes.c_void_p),
        ("faces", ctypes.c_int64 * 2),
        ("weights", ctypes.c_double * 6),
        ("most", ctypes.c_int64),
        ("strip", ctypes.c_void_p),
        ("sides", ctypes.c_void_p),
        ("along", ctypes.c_void_p),
        ("length", ctypes.c_double),
    )


@dataclass(frozen=True, eq=False)
class MeshArrays:
    """A mesh as the kernels read it; see `geodesic.across.routes.faces.FaceMesh`.

    Parameters
    ----------
    faces, over : ndarray of int, shape (f, 3)
    apex : ndarray of complex, shape (f, 3)
    angle : ndarray, shape (n,)
    vertices : ndarray, shape (n, 3)
    """

    faces: Ints
    over: Ints
    apex: Complex
    angle: Array
    vertices: Array

    @cached_property
    def structure(self) -> _Triangles:
        """The arrays as a structure."""
        arrays = self.faces, self.over, self.apex, self.angle, self.vertices
        return _Triangles(*map(address, arrays))


class WayFound(NamedTuple):
    """What `geodesic.across.routes.strips.StraightWay` holds; the weights are those of the ends."""

    strip: Ints
    sides: Ints
    along: Array
    length: float
    weights: tuple[list[float], list[float]]


def way_straightened(
    mesh: MeshArrays,
    faces: tuple[int, int],
    weights: tuple[Sequence[float], Sequence[float]],
    vertices: Ints,
) -> WayFound | int:
    """Return the way along a mesh's edges, pulled straight.

    Parameters
    ----------
    mesh : MeshArrays
        One of whose sides each is on two faces at most.
    faces, weights : pair
        Where its ends are: their faces, and the barycentric coordinates on them.
    vertices : ndarray of int

    Returns
    -------
    WayFound or int
        0 if no strip of faces leads past a vertex; 1 if the Python form has to look.
    """
    given = np.ascontiguousarray(vertices, np.int64)
    most = MOST_FACES + MORE_FACES * len(given)
    strip, sides = np.empty((2, most), np.int64)
    along = np.empty(most)
    way = _Way(len(given), address(given), faces, (*weights[0], *weights[1]), most)
    way.strip, way.sides, way.along = map(address, (strip, sides, along))
    count = kernels().bodymeasure_straight_way(ctypes.byref(mesh.structure), ctypes.byref(way))
    if count < 0:
        return -1 - int(count)
    shares = list(way.weights)
    return WayFound(
        strip[:count].copy(),
        sides[: count - 1].copy(),
        along[: count - 1].copy(),
        way.length,
        (shares[:3], shares[3:]),
    )
