"""Newton's method for the path along a route, compiled."""

import ctypes
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.native.energy import PathTables
from bodymeasure.native.library import address, doubles, kernels


class _RouteUnknowns(ctypes.Structure):
    """`RouteUnknowns` of ``route_newton.cpp``."""

    _fields_ = (
        ("unknowns", ctypes.c_int64),
        ("bands", ctypes.c_int64),
        ("moved", ctypes.c_int64),
        ("rows", ctypes.c_void_p),
        ("local", ctypes.c_void_p),
        ("sign", ctypes.c_void_p),
        ("offset", ctypes.c_void_p),
        ("fixed", ctypes.c_void_p),
        ("idle", ctypes.c_void_p),
        ("epsilon", ctypes.c_double),
    )


class NewtonSettings(ctypes.Structure):
    """`NewtonSettings` of ``route_newton.cpp``: the constants of `numerics.box_newton`."""

    _fields_ = (
        ("most_steps", ctypes.c_int64),
        *((name, ctypes.c_double) for name in ("rest", "rest_damping", "rounding", "start")),
        *((name, ctypes.c_double) for name in ("first", "less", "more", "least", "most")),
    )


class RouteArrays(NamedTuple):
    """What moves the nodal values of the pieces of a route; see `across.pieces.problem`.

    Parameters
    ----------
    rows, local : ndarray of int, shape (pieces, k)
    sign, offset : ndarray, shape (pieces, k)
    fixed : ndarray, shape (pieces, 2, nodes)
    bands : int
        The number of bands of the Hessian.
    epsilon : float
    """

    rows: Ints
    local: Ints
    sign: Array
    offset: Array
    fixed: Array
    bands: int
    epsilon: float


class RouteMinimum(NamedTuple):
    """Where Newton's method came to rest; see `numerics.box_newton.BoxMinimum`."""

    unknowns: Array
    value: float
    gradient: Array
    bands: Array
    iterations: int
    converged: bool


def route_newton(
    tables: PathTables, route: RouteArrays, start: Array, idle: Bools, settings: NewtonSettings
) -> RouteMinimum:
    """Return the minimum that Newton's method finds from a place in the box.

    Parameters
    ----------
    tables : PathTables
        Such as the kernels serve.
    route : RouteArrays
    start : ndarray, shape (unknowns,)
    idle : ndarray of bool, shape (unknowns,)
    settings : NewtonSettings
    """
    rows, local = (np.ascontiguousarray(each, np.int64) for each in (route.rows, route.local))
    sign, offset, fixed = doubles(route.sign, route.offset, route.fixed)
    idle, place, size = np.ascontiguousarray(idle, bool), np.array(start, np.float64), len(start)
    unknowns = _RouteUnknowns(
        size,
        route.bands,
        rows.shape[1],
        address(rows),
        address(local),
        *map(address, (sign, offset, fixed)),
        address(idle),
        route.epsilon,
    )
    value, gradient, bands = np.empty(1), np.empty(size), np.empty((route.bands, size))
    steps = kernels().bodymeasure_route_newton(
        ctypes.byref(tables.structure),
        ctypes.byref(unknowns),
        ctypes.byref(settings),
        *map(address, (place, value, gradient, bands)),
    )
    return RouteMinimum(place, float(value[0]), gradient, bands, abs(steps), steps > 0)
