"""The lengths of paths, compiled: with their corrections, errors and indices."""

import ctypes
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.native.energy import PathTables
from bodymeasure.native.library import address, doubles, kernels

# The most problems that one vector of the processor holds; fewer where it has no such vectors.
MOST_LANES = 8
# The entries of a block of the Galerkin system: `BLOCK` of ``diagonal.h``.
BLOCK = 8


class LengthStructure(ctypes.Structure):
    """`LengthTables` of ``diagonal.h``."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("size", "points", "modes", "blocks")),
        *((name, ctypes.c_int64) for name in ("second", "third", "last")),
        *((name, ctypes.c_void_p) for name in ("weights", "place", "slope", "bend", "gaps")),
        *((name, ctypes.c_void_p) for name in ("values", "slopes", "products", "is_even")),
        *((name, ctypes.c_void_p) for name in ("places", "coefficients", "antiderivative")),
    )


class LengthSettings(ctypes.Structure):
    """`LengthSettings` of ``diagonal.h``: the constants of `geodesic.lengths`."""

    _fields_ = (
        ("twice_falls", ctypes.c_int64),
        *((name, ctypes.c_double) for name in ("steep", "cancellation", "noise", "safety")),
        *((name, ctypes.c_double) for name in ("quadrature_safety", "curvature_variation")),
        *((name, ctypes.c_double) for name in ("path_rounding", "lyapunov", "eigenvalue_rounding")),
        *((name, ctypes.c_double) for name in ("trusted_correction", "trusted_residual")),
    )


class _Lengths(ctypes.Structure):
    """`Lengths` of ``diagonal.h``."""

    _fields_ = tuple(
        (name, ctypes.c_void_p)
        for name in ("raw", "correction", "error", "residual", "index", "trusted")
    )


@dataclass(frozen=True, eq=False)
class LengthTables:
    """What lengths on a trial space are calculated from; see ``diagonal.h``.

    Parameters
    ----------
    size : int
        Paths have one more node.
    times, weights : ndarray, shape (points,)
        A quadrature that is symmetric about the middle, of an even number of points.
    maps : ndarray, shape (3, points, k)
        To values and two derivatives there, from all nodes or, for offsets, from inner ones.
    modes : ndarray, shape (2, points, modes)
        The modes and their slopes.
    coefficients : ndarray, shape (points - quarters[0], points)
        The map to Legendre coefficients beyond the first quarter.
    quarters : tuple of int
        The degrees at which the second, third and last quarters begin.
    antiderivative : ndarray, shape (points, points), optional
        The map to integrals, if the modes are so few that what they leave out is counted.
    """

    size: int
    times: Array
    weights: Array
    maps: Array
    modes: Array
    coefficients: Array
    quarters: tuple[int, int, int]
    antiderivative: Array | None = None
    _arrays: "list[Array | Ints | None]" = field(init=False, repr=False)

    def __post_init__(self) -> None:
        # The arrays to which structures point, in their order. They are made at once: of threads
        # that each made their own, the last would free those of the others.
        half = len(self.times) // 2
        places, is_even, products = self._blocks
        whole = None if self.antiderivative is None else doubles(self.antiderivative)[0]
        arrays = [
            *doubles(self.weights, *self.maps, 1.0 / np.diff(self.times)),
            *doubles(*self.modes[:, :half], products),
            *(is_even, places),
            *doubles(self.coefficients[:, :half]),
            whole,
        ]
        object.__setattr__(self, "_arrays", arrays)

    @cached_property
    def structure(self) -> LengthStructure:
        """The tables as a structure."""
        return LengthStructure(*self.fields)

    @property
    def fields(self) -> tuple[int | None, ...]:
        """The structure's fields, which point to arrays of this record."""
        count, quarters, modes = len(self._blocks[0]), self.quarters, self.modes.shape[2]
        addresses = (None if each is None else address(each) for each in self._arrays)
        return self.size, len(self.times), modes, count, *quarters, *addresses

    @cached_property
    def _blocks(self) -> tuple[Ints, Ints, Array]:
        """The entries of the Galerkin system by blocks: places, which are even, and products.

        All products of two even modes, or of two odd ones, are even about the middle.
        """
        values, slopes = self.modes[:, : len(self.times) // 2]
        half, modes = values.shape
        columns, rows = np.triu_indices(modes)
        same = (columns + rows) % 2 == 0
        places, is_even, products = [], [], []
        for even in (1, 0):
            group = np.flatnonzero(same == even)
            padded = np.concatenate([group, np.zeros(-len(group) % BLOCK, np.int64)])
            place = np.where(np.arange(len(padded)) < len(group), padded, len(rows))
            pairs = [
                (sign * each[:, rows[padded]] * each[:, columns[padded]]).reshape(half, -1, BLOCK)
                for sign, each in ((1.0, slopes), (-1.0, values))
            ]
            places.append(place.reshape(-1, BLOCK))
            is_even.append(np.full(len(padded) // BLOCK, even))
            products.append(np.stack(pairs, axis=2).transpose(1, 0, 2, 3))
        return (
            np.ascontiguousarray(np.concatenate(places), np.int64),
            np.ascontiguousarray(np.concatenate(is_even), np.int64),
            np.ascontiguousarray(np.concatenate(products)),
        )


def path_lengths(
    paths: PathTables, tables: LengthTables, settings: LengthSettings, values: Array
) -> tuple[Array, Array, Array, Array, Ints, Bools]:
    """Return the arrays of `geodesic.lengths.length.Length`, in its order, of paths on patches.

    Parameters
    ----------
    paths : PathTables
        Such as the kernels serve.
    tables : LengthTables
        Those of the same trial space, from all nodes.
    settings : LengthSettings
    values : ndarray, shape (paths, 2, n + 1)
    """
    (values,) = doubles(values)
    count = len(values)
    raw, correction, error, residual = np.empty((4, count))
    index, trusted = np.empty(count, np.int64), np.empty(count, bool)
    found = raw, correction, error, residual, index, trusted
    kernels().bodymeasure_lengths(
        ctypes.byref(paths.structure),
        address(values),
        ctypes.byref(tables.structure),
        ctypes.byref(settings),
        ctypes.byref(_Lengths(*map(address, found))),
        MOST_LANES,
    )
    return found
