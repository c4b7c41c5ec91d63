"""Ways over triangle meshes pulled straight, compiled."""

import ctypes
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Complex, Ints
from bodymeasure.native.library import address, doubles, kernels

# The most faces of a strip: so many, and so many more for each vertex that it begins along.
MOST_FACES, MORE_FACES = 1000, 16
# The most faces of each of the first ways. The system provides their room only where it is used.
LONGEST = 8192


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


class _Graph(ctypes.Structure):
    """`Graph` of ``first_ways.cpp``."""

    _fields_ = (
        ("vertices", ctypes.c_int64),
        ("longest", ctypes.c_int64),
        *((name, ctypes.c_void_p) for name in ("begins", "heads", "lengths", "along")),
    )


class _Joined(ctypes.Structure):
    """`Joined` of ``first_ways.cpp``."""

    _fields_ = (
        ("count", ctypes.c_int64),
        ("longest", ctypes.c_int64),
        *((name, ctypes.c_void_p) for name in ("vertices", "distances", "along")),
    )


class _Scope(ctypes.Structure):
    """`Scope` of ``first_ways.cpp``."""

    _fields_ = (
        ("longer", ctypes.c_double),
        ("apart", ctypes.c_double),
        ("parts", ctypes.c_int64),
        ("most", ctypes.c_int64),
        ("part", ctypes.c_void_p),
    )


class _Ways(ctypes.Structure):
    """`Ways` of ``first_ways.cpp``."""

    _fields_ = (
        ("faces", ctypes.c_int64 * 2),
        ("ends", ctypes.c_double * 6),
        ("longest", ctypes.c_int64),
        *(
            (name, ctypes.c_void_p)
            for name in ("counts", "strips", "sides", "along", "lengths", "weights")
        ),
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


@dataclass(frozen=True, eq=False)
class GraphArrays:
    """A graph as the kernels read it; see `geodesic.across.routes.graph.PatchGraph`.

    Parameters
    ----------
    begins : ndarray of int, shape (n + 1,)
        The number of the first step from each vertex.
    heads : ndarray of int, shape (steps,)
        The vertices to which steps lead.
    lengths : ndarray, shape (steps,)
    along : ndarray of int, shape (steps or more, k)
    """

    begins: Ints
    heads: Ints
    lengths: Array
    along: Ints

    @cached_property
    def structure(self) -> _Graph:
        """The arrays as a structure."""
        arrays = self.begins, self.heads, self.lengths, self.along
        return _Graph(len(self.begins) - 1, self.along.shape[1], *map(address, arrays))


class JoinedEnd(NamedTuple):
    """An end of ways on a mesh, and the vertices of a graph to which it is joined.

    Parameters
    ----------
    face : int
        The face that holds it.
    weights : sequence of float
        Its barycentric coordinates there.
    vertices : ndarray of int, shape (k,)
    distances : ndarray, shape (k,)
    along : ndarray of int, shape (k, longest)
        The vertices, along edges, from a corner of the face to each of them, and then -1.
    """

    face: int
    weights: Sequence[float]
    vertices: Ints
    distances: Array
    along: Ints


class WaysWanted(NamedTuple):
    """How widely ways are sought; see `geodesic.across.routes.ways.Scope`."""

    longer: float
    apart: float
    parts: Sequence[float]
    most: int


class WayFound(NamedTuple):
    """What `geodesic.across.routes.strips.StraightWay` holds; the weights are those of the ends."""

    strip: Ints
    sides: Ints
    along: Array
    length: float
    weights: tuple[list[float], list[float]]


def first_ways_straightened(
    mesh: MeshArrays, graph: GraphArrays, ends: tuple[JoinedEnd, JoinedEnd], wanted: WaysWanted
) -> list[WayFound] | None:
    """Return different ways between two ends, pulled straight; None if the Python form has to look.

    Parameters
    ----------
    mesh : MeshArrays
        One of whose sides each is on two faces at most.
    graph : GraphArrays
    ends : pair of JoinedEnd
    wanted : WaysWanted
    """
    most = wanted.most
    counts, (strips, sides) = np.empty(most, np.int64), np.empty((2, most, LONGEST), np.int64)
    along, lengths, weights = np.empty((most, LONGEST)), np.empty(most), np.empty((most, 2, 3))
    found = counts, strips, sides, along, lengths, weights
    faces, shares = (ends[0].face, ends[1].face), (*ends[0].weights, *ends[1].weights)
    ways = _Ways(faces, shares, LONGEST, *map(address, found))
    joined = [_Joined(*end.along.shape, *map(address, end[2:])) for end in ends]
    (parts,) = doubles(np.array(wanted.parts))
    count = kernels().bodymeasure_first_ways(
        ctypes.byref(mesh.structure),
        ctypes.byref(graph.structure),
        ctypes.byref((_Joined * 2)(*joined)),
        ctypes.byref(_Scope(wanted.longer, wanted.apart, len(parts), most, address(parts))),
        ctypes.byref(ways),
    )
    if count < 0:
        return None
    # Copies, so that no way keeps the room of all.
    return [
        WayFound(
            strip[:size].copy(),
            side[: size - 1].copy(),
            t[: size - 1].copy(),
            length,
            (share[:3], share[3:]),
        )
        for strip, side, t, size, length, share in zip(
            strips[:count],
            sides,
            along,
            counts.tolist(),
            lengths.tolist(),
            weights.reshape(most, 6).tolist(),
            strict=False,
        )
    ]


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
