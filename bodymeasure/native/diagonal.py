"""Geodesics from corner to corner of bicubic patches, compiled: many at once."""

import ctypes
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.native import lengths
from bodymeasure.native.lengths import LengthSettings, LengthStructure, LengthTables
from bodymeasure.native.library import address, doubles, kernels


class _Problems(ctypes.Structure):
    """`DiagonalProblems` of ``diagonal.h``."""

    _fields_ = (
        ("count", ctypes.c_int64),
        *((name, ctypes.c_void_p) for name in ("rows", "nets", "start", "end")),
        ("are_corners", ctypes.c_int64),
    )


class _Space(LengthStructure):
    """`DiagonalSpace` of ``diagonal.h``."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("before", "inner", "between")),
        *((name, ctypes.c_void_p) for name in ("times", "carry", "first", "second_map")),
        *((name, ctypes.c_void_p) for name in ("quadrature", "beside", "across")),
    )


class DiagonalSettings(LengthSettings):
    """`DiagonalSettings` of ``diagonal.h``: the constants of `geodesic.graph` and its lengths."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("guess_steps", "steps")),
        *((name, ctypes.c_double) for name in ("longest_step", "small", "most_offset")),
        *((name, ctypes.c_double) for name in ("far_outside", "tolerance", "rounding")),
    )


class _Paths(ctypes.Structure):
    """`DiagonalPaths` of ``diagonal.h``."""

    _fields_ = (
        *((name, ctypes.c_void_p) for name in ("problem", "values", "raw", "correction")),
        *((name, ctypes.c_void_p) for name in ("error", "residual", "reach", "chord", "index")),
        *((name, ctypes.c_void_p) for name in ("trusted", "good", "left", "offset")),
        ("counts", ctypes.c_int64 * 2),
    )


class DiagonalSpace:
    """A trial space, as the kernel takes it.

    Parameters
    ----------
    times : ndarray, shape (inner,)
        The inner nodes.
    carry : ndarray, shape (inner, before)
        The map from offsets at the inner nodes of the space before; none before the guess.
    slopes : ndarray, shape (2, inner, inner)
        The maps to two derivatives at the nodes.
    tables : LengthTables, optional
        Those of lengths, from offsets. Without them the space only serves to make a guess.
    between : tuple of ndarray, shapes (between,) and (between, inner)
        Times close together, and the map to values there.
    """

    def __init__(
        self,
        times: Array,
        carry: Array,
        slopes: Array,
        tables: LengthTables | None = None,
        between: tuple[Array, Array] = (np.zeros(0), np.zeros(0)),
    ) -> None:
        self.inner, self.before = carry.shape
        self._tables, self._beside = tables, between[0]
        quadrature = between[0] if tables is None else tables.times
        self._arrays = doubles(times, carry, *slopes, quadrature, *between)

    @cached_property
    def structure(self) -> _Space:
        """The tables as a structure."""
        result = _Space() if self._tables is None else _Space(*self._tables.fields)
        own = self.before, self.inner, len(self._beside), *map(address, self._arrays)
        for field, value in zip(_Space._fields_, own, strict=True):
            setattr(result, field[0], value)
        return result


class DiagonalProblems(NamedTuple):
    """Problems on bicubic patches.

    Parameters
    ----------
    nets : ndarray, shape (problems, 4, 4, 3)
        Each whole, or restricted to the rectangle between its two points.
    start, end : ndarray, shape (problems, 2)
        Those points, in the parameters of the whole patches.
    are_corners : bool
        Whether the patches are whole, and the points are corners.
    """

    nets: Array
    start: Array
    end: Array
    are_corners: bool


@dataclass(frozen=True)
class DiagonalPaths:
    """The paths that are done, k of them, and those that are left to another space, j of them.

    Parameters
    ----------
    problem : ndarray of int, shape (k,)
        The places of their problems in the rows that were given.
    values : ndarray, shape (k, 2, inner + 2)
        u and v at all nodes.
    raw, correction, error, residual : ndarray, shape (k,)
        See `geodesic.lengths.length.Length`.
    reach : ndarray, shape (k,)
        How far the path goes outside of its patch in u or v; less than 0 inside.
    chord : ndarray, shape (k,)
        The distance of its ends in space.
    index : ndarray of int, shape (k,)
    trusted, good : ndarray of bool, shape (k,)
        Good ones are known to the tolerance, too.
    left : ndarray of int, shape (j,)
        As `problem`. What is in neither is left to another form.
    offset : ndarray, shape (j, inner)
    """

    problem: Ints
    values: Array
    raw: Array
    correction: Array
    error: Array
    residual: Array
    reach: Array
    chord: Array
    index: Ints
    trusted: Bools
    good: Bools
    left: Ints
    offset: Array


def diagonal_paths(
    problems: DiagonalProblems,
    rows: Ints,
    space: DiagonalSpace,
    settings: DiagonalSettings,
    before: Array | DiagonalSpace,
) -> DiagonalPaths:
    """Take Newton's steps on a trial space, and measure the paths.

    Parameters
    ----------
    problems : DiagonalProblems
    rows : ndarray of int, shape (k,)
        The problems to solve.
    space : DiagonalSpace
        One with a quadrature.
    settings : DiagonalSettings
    before : ndarray, shape (k, before), or DiagonalSpace
        The offsets at the inner nodes of the space before, or the space to make a first guess on.
    """
    nets, start, end = doubles(problems.nets, problems.start, problems.end)
    guess = before if isinstance(before, DiagonalSpace) else space
    known = None if isinstance(before, DiagonalSpace) else doubles(before)[0]
    rows = np.ascontiguousarray(rows, np.int64)
    count, inner = len(rows), space.inner
    # Pages of memory that are not written to are not taken.
    numbers, reals = np.empty((3, count), np.int64), np.empty((6, count))
    answers = np.empty((2, count), bool)
    values, offset = np.empty((count, 2, inner + 2)), np.empty((count, inner))
    given = _Problems(count, *map(address, (rows, nets, start, end)), problems.are_corners)
    # An address takes a microsecond, so that those of rows follow from one.
    number, real, answer = map(address, (numbers, reals, answers))
    found = _Paths(
        number,
        address(values),
        *(real + 8 * count * row for row in range(6)),
        number + 8 * count,
        *(answer, answer + count),
        number + 16 * count,
        address(offset),
    )
    kernels().bodymeasure_diagonals(
        ctypes.byref(given),
        ctypes.byref(guess.structure),
        ctypes.byref(space.structure),
        ctypes.byref(settings),
        None if known is None else address(known),
        ctypes.byref(found),
        lengths.MOST_LANES,
    )
    done, left = found.counts
    raw, correction, error, residual, reach, chord = (row[:done] for row in reals)
    return DiagonalPaths(
        problem=numbers[0, :done],
        values=values[:done],
        raw=raw,
        correction=correction,
        error=error,
        residual=residual,
        reach=reach,
        chord=chord,
        index=numbers[1, :done],
        trusted=answers[0, :done],
        good=answers[1, :done],
        left=numbers[2, :left],
        offset=offset[:left],
    )
