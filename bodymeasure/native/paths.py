"""Newton's method for paths on patches, by collocation and for polygons, compiled."""

import ctypes

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.native.library import address, doubles, kernels


class CollocationSettings(ctypes.Structure):
    """The last fields of `Collocation` of ``collocation.cpp``: the constants of its NumPy forms."""

    _fields_ = tuple(
        (name, ctypes.c_double)
        for name in ("sufficient_decrease", "last_step", "longest_step", "smallest_step")
    )


class _Collocation(ctypes.Structure):
    """`Collocation` of ``collocation.cpp``."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("count", "degree_u", "degree_v", "nodes", "most")),
        *((name, ctypes.c_void_p) for name in ("nets", "first", "second", "at_ends")),
        *((name, ctypes.c_void_p) for name in ("held", "spans")),
        ("settings", CollocationSettings),
    )


class DescentSettings(ctypes.Structure):
    """The last fields of `Descent` of ``polygons.cpp``: the constants of its NumPy form."""

    _fields_ = tuple(
        (name, ctypes.c_double)
        for name in ("regularization", "rest", "first_damping", "less", "more", "most_damping")
    )


class _Descent(ctypes.Structure):
    """`Descent` of ``polygons.cpp``."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("count", "degree_u", "degree_v", "points", "most")),
        ("nets", ctypes.c_void_p),
        ("settings", DescentSettings),
    )


def collocated(
    patches: tuple[Array, tuple[int, int]],
    maps: tuple[Array, Array],
    start: tuple[Array, Ints, Array],
    most_evaluations: int,
    settings: CollocationSettings,
) -> tuple[Array, Bools, Bools, Ints]:
    """Return what `solving.newton.newton` does, also for paths whose ends move along edges.

    Parameters
    ----------
    patches : tuple
        The control points of all derivatives of each patch, and its degrees.
    maps : tuple of ndarray, shapes (2, n - 1, n + 1) and (2, n + 1)
        To two derivatives at the inner nodes, and to the first one at both ends.
    start : tuple of ndarray, shapes (problems, 2, n + 1), (problems, 2) and (problems,)
        Nodal values; the coordinates that edges fix at both ends, -1 where an end stays; and what
        last steps are small beside.
    most_evaluations : int
    settings : CollocationSettings
    """
    values, held, spans = start
    values = np.array(values, np.float64, order="C")
    nets, differentiation, at_ends, spans = doubles(patches[0], *maps, spans)
    held, count = np.ascontiguousarray(held, np.int64), len(values)
    converged, singular = np.empty(count, bool), np.empty(count, bool)
    iterations, (first, second) = np.empty(count, np.int64), differentiation
    arrays = (nets, first, second, at_ends, held, spans)
    problems = _Collocation(
        count, *patches[1], values.shape[2], most_evaluations, *map(address, arrays), settings
    )
    kernels().bodymeasure_collocation(
        ctypes.byref(problems), *map(address, (values, converged, singular, iterations))
    )
    return values, converged, singular, iterations


def polygons_at_rest(
    patches: tuple[Array, tuple[int, int]],
    polygons: Array,
    most_steps: int,
    settings: DescentSettings,
) -> Array:
    """Return what `shortest.descent.descend` does.

    Parameters
    ----------
    patches : tuple
        The control points of all derivatives of each patch, and its degrees.
    polygons : ndarray, shape (polygons, m + 1, 2)
        In the box.
    most_steps : int
    settings : DescentSettings
    """
    polygons = np.array(polygons, np.float64, order="C")
    (nets,) = doubles(patches[0])
    count, points = polygons.shape[:2]
    descent = _Descent(count, *patches[1], points, most_steps, address(nets), settings)
    kernels().bodymeasure_descent(ctypes.byref(descent), address(polygons))
    return polygons
