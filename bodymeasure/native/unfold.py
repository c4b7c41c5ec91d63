"""Strips of triangles unfolded into a plane, compiled."""

import ctypes
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Complex, Ints
from bodymeasure.native.library import address, doubles, kernels


class _Triangles(ctypes.Structure):
    """`Triangles` of ``unfold.cpp``."""

    _fields_ = (("faces", ctypes.c_void_p), ("apex", ctypes.c_void_p))


class _Strip(ctypes.Structure):
    """`Strip` of ``unfold.cpp``."""

    _fields_ = (
        ("count", ctypes.c_int64),
        ("strip", ctypes.c_void_p),
        ("scale", ctypes.c_double),
        ("start_weights", ctypes.c_void_p),
        ("end_weights", ctypes.c_void_p),
        ("sides", ctypes.c_void_p),
        ("names", ctypes.c_void_p),
        ("left", ctypes.c_void_p),
        ("right", ctypes.c_void_p),
        ("ends", ctypes.c_void_p),
        ("bends", ctypes.c_void_p),
    )


class UnfoldedStrip(NamedTuple):
    """An unfolded strip; see `geodesic.across.routes.strips`.

    Parameters
    ----------
    sides : ndarray of int, shape (k - 1,)
    names : ndarray of int, shape (k - 1, 2)
    left, right : ndarray of complex, shape (k - 1,)
    ends : ndarray of complex, shape (2,)
    bends : ndarray of int, shape (b, 2)
    """

    sides: Ints
    names: Ints
    left: Complex
    right: Complex
    ends: Complex
    bends: Ints


def unfolded(
    mesh: tuple[Ints, Complex], strip: Ints, scale: float, weights: Sequence[Array]
) -> UnfoldedStrip | None:
    """Return a strip unfolded into a plane, and where the shortest path within it bends.

    Parameters
    ----------
    mesh : tuple of ndarray, shape (faces, 3)
        The vertices of each face, and where its third corner is, seen from each side.
    strip : ndarray of int, shape (k,)
        Faces, each of which shares a side with the next.
    scale : float
        The length of the first side of the first face.
    weights : pair of ndarray, shape (3,)
        The barycentric coordinates of both ends.

    Returns
    -------
    UnfoldedStrip or None
        None if two faces in a row share no side.
    """
    weights, strip = doubles(*weights), np.ascontiguousarray(strip, np.int64)
    count = len(strip)
    sides, names = np.empty(count - 1, np.int64), np.empty((count - 1, 2), np.int64)
    left, right = np.empty(count - 1, complex), np.empty(count - 1, complex)
    ends, bends = np.empty(2, complex), np.empty((2 * count, 2), np.int64)
    triangles = _Triangles(*map(address, mesh))
    whole = _Strip(
        count,
        address(strip),
        scale,
        *map(address, (*weights, sides, names, left, right, ends, bends)),
    )
    found = kernels().bodymeasure_unfold(ctypes.byref(triangles), ctypes.byref(whole))
    if found < 0:
        return None
    return UnfoldedStrip(sides, names, left, right, ends, bends[:found])
