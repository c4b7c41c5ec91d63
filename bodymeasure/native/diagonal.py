"""Geodesics from corner to corner of bicubic patches, compiled: many at once."""

import ctypes
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.native.library import address, doubles, kernels

# The most problems that one vector of the processor holds; fewer where it has no such vectors.
MOST_LANES = 8


class _Problems(ctypes.Structure):
    """`DiagonalProblems` of ``diagonal.h``."""

    _fields_ = (
        ("count", ctypes.c_int64),
        *((name, ctypes.c_void_p) for name in ("rows", "nets", "start", "end")),
        ("are_corners", ctypes.c_int64),
    )


class _Space(ctypes.Structure):
    """`DiagonalSpace` of ``diagonal.h``."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("before", "inner", "points", "modes", "blocks")),
        *((name, ctypes.c_int64) for name in ("between", "second", "third", "last")),
        *((name, ctypes.c_void_p) for name in ("times", "carry", "first", "second_map")),
        *((name, ctypes.c_void_p) for name in ("quadrature", "weights", "place", "slope", "bend")),
        *((name, ctypes.c_void_p) for name in ("gaps", "values", "slopes", "products", "is_even")),
        *((name, ctypes.c_void_p) for name in ("places", "coefficients", "beside", "across")),
    )


class DiagonalSettings(ctypes.Structure):
    """`DiagonalSettings` of ``diagonal.h``: the constants of `geodesic.graph` and its lengths."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("guess_steps", "steps", "twice_falls")),
        *((name, ctypes.c_double) for name in ("longest_step", "small", "most_offset")),
        *((name, ctypes.c_double) for name in ("far_outside", "tolerance", "steep", "rounding")),
        *((name, ctypes.c_double) for name in ("noise", "safety", "quadrature_safety")),
        *((name, ctypes.c_double) for name in ("curvature_variation", "path_rounding", "lyapunov")),
        *((name, ctypes.c_double) for name in ("eigenvalue_rounding", "trusted_correction")),
        ("trusted_residual", ctypes.c_double),
    )


class _Paths(ctypes.Structure):
    """`DiagonalPaths` of ``diagonal.h``."""

    _fields_ = (
        *((name, ctypes.c_void_p) for name in ("problem", "values", "raw", "correction")),
        *((name, ctypes.c_void_p) for name in ("error", "residual", "reach", "chord", "index")),
        *((name, ctypes.c_void_p) for name in ("trusted", "good", "left", "offset")),
        ("counts", ctypes.c_int64 * 2),
    )


class QuadratureTables(NamedTuple):
    """What a trial space measures lengths by; see ``diagonal.h``.

    Parameters
    ----------
    times, weights : ndarray, shape (points,)
        A quadrature that is symmetric about the middle, of an even number of points.
    maps : ndarray, shape (3, points, inner)
        To values and two derivatives there.
    modes : ndarray, shape (2, points, modes)
        The modes and their slopes.
    coefficients : ndarray, shape (points - quarters[0], points)
        The map to Legendre coefficients beyond the first quarter.
    quarters : tuple of int
        The degrees at which the second, third and last quarters begin.
    beside : ndarray, shape (between,)
        Times close together.
    across : ndarray, shape (between, inner)
        The map to values there.
    """

    times: Array
    weights: Array
    maps: Array
    modes: Array
    coefficients: Array
    quarters: tuple[int, int, int]
    beside: Array
    across: Array


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
    quadrature : QuadratureTables, optional
        Without them the space only serves to make a guess.
    """

    def __init__(
        self, times: Array, carry: Array, slopes: Array, quadrature: QuadratureTables | None
    ) -> None:
        self.inner, self.before = carry.shape
        self.points = 0 if quadrature is None else len(quadrature.times)
        self._nodes = doubles(times, carry, *slopes)
        self._quadrature = quadrature

    @cached_property
    def structure(self) -> _Space:
        """The tables as a structure."""
        tables = self._quadrature
        if tables is None:
            return _Space(self.before, self.inner, *[0] * 7, *map(address, self._nodes))
        half = self.points // 2
        values, slopes = doubles(*tables.modes[:, :half])
        places, is_even, products = _blocks(values, slopes)
        self._measuring = [
            *doubles(tables.times, tables.weights, *tables.maps, 1.0 / np.diff(tables.times)),
            *(values, slopes, products, is_even, places),
            *doubles(tables.coefficients[:, :half], tables.beside, tables.across),
        ]
        return _Space(
            *(self.before, self.inner, self.points, values.shape[1], len(places)),
            len(tables.beside),
            *tables.quarters,
            *map(address, (*self._nodes, *self._measuring)),
        )


def _blocks(values: Array, slopes: Array) -> tuple[Ints, Ints, Array]:
    """The entries of the Galerkin system by fours: places, which are even, and products.

    All products of two even modes, or of two odd ones, are even about the middle.
    """
    half, modes = values.shape
    columns, rows = np.triu_indices(modes)
    same = (columns + rows) % 2 == 0
    places, is_even, products = [], [], []
    for even in (1, 0):
        group = np.flatnonzero(same == even)
        padded = np.concatenate([group, np.zeros(-len(group) % 4, np.int64)])
        place = np.where(np.arange(len(padded)) < len(group), padded, len(rows))
        pairs = [
            (each[:, rows[padded]] * each[:, columns[padded]]).reshape(half, -1, 4)
            for each in (slopes, values)
        ]
        places.append(place.reshape(-1, 4))
        is_even.append(np.full(len(padded) // 4, even))
        products.append(np.stack(pairs, axis=2).transpose(1, 0, 2, 3))
    return (
        np.ascontiguousarray(np.concatenate(places), np.int64),
        np.ascontiguousarray(np.concatenate(is_even), np.int64),
        np.ascontiguousarray(np.concatenate(products)),
    )


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
        MOST_LANES,
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
