"""The energy of paths to the second order, compiled."""

import ctypes
from functools import cached_property
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.native.library import address, doubles, kernels, library
from bodymeasure.native.points import MOST_DEGREE

# The derivatives of a jet, three coordinates each.
JET = 30


class Paths(ctypes.Structure):
    """`Paths` of ``kernels.h``."""

    _fields_ = (
        ("count", ctypes.c_int64),
        ("degree_u", ctypes.c_int64),
        ("degree_v", ctypes.c_int64),
        ("nets", ctypes.c_void_p),
        ("nodes", ctypes.c_int64),
        ("points", ctypes.c_int64),
        ("place", ctypes.c_void_p),
        ("slopes", ctypes.c_void_p),
        ("weights", ctypes.c_void_p),
    )


class _Contents(NamedTuple):
    """The arrays to which a structure points, so that they live as long."""

    nets: Array
    place: Array
    slopes: Array
    weights: Array


class PathTables:
    """Patches and the trial space of paths on them, as the kernels take them.

    Parameters
    ----------
    nets : ndarray, shape (problems, (m + 1) * (n + 1), 30)
        The control points of the derivatives of each patch, in the order of a jet.
    degrees : tuple of int
        m and n.
    place, slopes : ndarray, shape (points, nodes)
        The maps from nodal values to values and slopes at the points of the quadrature.
    weights : ndarray, shape (points,)
    """

    def __init__(
        self, nets: Array, degrees: tuple[int, int], place: Array, slopes: Array, weights: Array
    ) -> None:
        self.degrees = degrees
        self._contents = _Contents(*doubles(nets, place, slopes, weights))
        self.problems, self.nodes = len(nets), place.shape[1]

    @property
    def are_served(self) -> bool:
        """Whether the kernels are there, and made for such patches."""
        small = max(self.degrees) <= MOST_DEGREE
        return library() is not None and small and self._contents.nets.shape[2] == JET

    @cached_property
    def structure(self) -> Paths:
        """The tables as a structure."""
        nets, place, slopes, weights = self._contents
        return Paths(
            self.problems,
            *self.degrees,
            address(nets),
            self.nodes,
            len(weights),
            address(place),
            address(slopes),
            address(weights),
        )


def energies(tables: PathTables, values: Array, flat: bool) -> tuple[Array, Array, Array]:
    """Return the energy of each path, its gradient and its Hessian by all nodal values.

    Parameters
    ----------
    tables : PathTables
        Such as the kernels serve.
    values : ndarray, shape (problems, 2, nodes)
    flat : bool
        Whether J^T J is to stand for the Hessian, as in a plane.

    Returns
    -------
    tuple of ndarray, shapes (problems,), (problems, 2 * nodes), (problems, 2 * nodes, 2 * nodes)
    """
    (values,) = doubles(values)
    size = 2 * tables.nodes
    value, gradient = np.empty(tables.problems), np.empty((tables.problems, size))
    hessian = np.empty((tables.problems, size, size))
    kernels().bodymeasure_energy(
        ctypes.byref(tables.structure),
        address(values),
        flat,
        *map(address, (value, gradient, hessian)),
    )
    return value, gradient, hessian
