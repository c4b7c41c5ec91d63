"""Radial basis function collocation, the paper's method."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure.errors import InputError
from bodymeasure.geodesic.kernels import WU_C10, Kernel
from bodymeasure.geodesic.length_error import (
    TRUSTED_CORRECTION,
    MeasuredLength,
    measure_length,
)
from bodymeasure.geodesic.method import MethodResult, Piece
from bodymeasure.geodesic.newton import MAX_ITERATIONS, newton
from bodymeasure.geodesic.rbf_space import rbf_space
from bodymeasure.geodesic.surface import Surface
from bodymeasure.geodesic.trial_space import TrialSpace

_Array = NDArray[np.float64]

# Numbers of functions that are tried in turn. Even, so that symmetric centers and collocation
# points give a regular system. 8 functions serve 9 of 10 diagonals of a body, 12 nearly all of the
# rest (tests/benchmarks/rbf_convergence.py).
LADDER = (8, 12, 16, 20)
# On all but the last number of functions, Newton's method is given up after this many steps: a
# few stubborn problems are cheaper with more functions.
FIRST_ITERATIONS = 6
# Relative error that is asked for. The correction gives two digits more in the median.
TOLERANCE = 1e-10
# With more functions than the kernel's degree, this many centers stay outside [0, 1].
OUTER_CENTERS = 8
# How far outside they lie: half as far as the paper's, whose second center is at 1.5, to double.
REACH = 0.9
# A path this far outside [0, 1], in u or v, is not brought back by more functions: hundred times
# what a path on 8 functions is off where it has not converged.
FAR_OUTSIDE = 0.02
# Problems that are solved at once: their arrays then stay in the processor's cache.
CHUNK = 384


@dataclass(frozen=True)
class RBFCollocation:
    """Collocation with radial basis functions: the paper's equations (5) to (12).

    ``u(t) = a_0 + sum a_i phi(|t - c_i| / r)``, and v alike, meet the geodesic equations at the
    collocation points and the end conditions at t = 0 and 1. Newton's method solves for the nodal
    values, from a straight line in (u, v); the length is measured, corrected and judged by the
    residual between the collocation points (`length_error`); where the estimate is not under the
    tolerance, the same is done with more functions, from the path found so far.

    Parameters
    ----------
    kernel : Kernel
        Wu's functions `WU_C2` (the paper's), `WU_C4`, `WU_C6`, `WU_C10`, or any other.
    functions : int or sequence of int
        How many functions, N; several are tried in turn. Ignored if centers are given.
    centers : sequence of float, optional
        The c_i. By default half of them lie on each side outside (0, 1), as the paper's 1 and 1.5
        do; there the functions are single polynomials on [0, 1], and convergence is spectral. Of
        more functions than the kernel's degree, the rest lie inside at Chebyshev points.
    collocation_points : sequence of float, optional
        N - 1 points in (0, 1), by default Chebyshev-Lobatto points. They are moved if the system
        is degenerate on them.
    support_radius : float
        The r above; 2 in the paper.
    tolerance : float
        Relative error of the length that is asked for.

    Raises
    ------
    InputError
        If a setting makes no sense.
    """

    kernel: Kernel = WU_C10
    functions: int | Sequence[int] = LADDER
    centers: Sequence[float] | None = None
    collocation_points: Sequence[float] | None = None
    support_radius: float = 2.0
    tolerance: float = TOLERANCE

    def __post_init__(self) -> None:
        if not (np.isfinite(self.support_radius) and self.support_radius > 0.0):
            raise InputError(f"support_radius is {self.support_radius}; expected a positive number")
        if not self.tolerance > 0.0:
            raise InputError(f"tolerance is {self.tolerance}; expected a positive number")
        if not isinstance(self.kernel, Kernel):
            raise InputError(f"kernel is {self.kernel!r}; expected a Kernel, such as WU_C2")
        if self.centers is not None:
            centers = _sequence("centers", self.centers)
            if not (len(centers) and np.isfinite(centers).all()):
                raise InputError("centers must be finite numbers, at least one")
        counts = self._counts
        if not counts or not all(isinstance(n, int | np.integer) and n >= 1 for n in counts):
            raise InputError(
                f"functions is {self.functions!r}; expected at least one function: a whole number, "
                "or several to be tried in turn"
            )
        if self.collocation_points is not None:
            _check_collocation_points(self.collocation_points, self._counts)

    @property
    def _counts(self) -> tuple[Any, ...]:
        if self.centers is not None:
            return (len(self.centers),)
        # Also numpy's integers are numbers.
        functions: Any = self.functions
        return (functions,) if np.ndim(functions) == 0 else tuple(functions)

    @property
    def spaces(self) -> Iterator[TrialSpace]:
        """The trial spaces that are tried in turn, made when they are needed."""
        for count in self._counts:
            centers = self.centers
            points = self.collocation_points
            yield rbf_space(
                self.kernel,
                tuple(default_centers(self.kernel, count) if centers is None else centers),
                tuple(chebyshev_points(count - 1) if points is None else points),
                self.support_radius,
            )

    def solve(self, surface: Surface, start: _Array, end: _Array) -> MethodResult:
        """Paths from start to end, both of shape (problems, 2), on a batch of surfaces."""
        iterations = np.zeros(len(start), np.int64)
        is_open = np.ones(len(start), bool)
        pieces: list[Piece] = []
        guess: TrialSpace | None = None
        paths = np.empty((len(start), 2, 0))
        for count, space in zip(self._counts, self.spaces, strict=True):
            is_last = count == self._counts[-1]
            rest = np.flatnonzero(is_open)
            values = straight(start, end, space.nodes)
            if guess is not None:
                known = rest[np.isfinite(paths[rest, 0, 0])]
                values[known] = paths[known] @ guess.matrices(space.nodes)[0].T
            for chunk in np.split(rest, range(CHUNK, len(rest), CHUNK)):
                piece, used = self._solve_on(
                    space, surface.take(chunk), chunk, values[chunk], is_last
                )
                iterations[chunk] += used
                values[chunk] = piece.values
                done = piece.converged | (is_last or _is_far_outside(piece))
                is_open[chunk] = ~done
                pieces.append(piece.take(np.flatnonzero(done)))
            paths, guess = values, space
            if not is_open.any():
                break
        return MethodResult(tuple(piece for piece in pieces if len(piece.problems)), iterations)

    def _solve_on(
        self,
        space: TrialSpace,
        surface: Surface,
        problems: NDArray[np.int64],
        values: _Array,
        is_last: bool,
    ) -> tuple[Piece, NDArray[np.int64]]:
        """One chunk of problems on one space; a path is NaN where Newton's method failed."""
        limit = MAX_ITERATIONS if is_last else FIRST_ITERATIONS
        found = newton(surface, space, values, max_iterations=limit)
        measured = measure_length(surface, space, found.values)
        converged = found.converged & is_good(measured, self.tolerance)
        if not is_last:
            found.values[~found.converged] = np.nan
        piece = Piece(problems, space, found.values, measured, converged, found.singular)
        return piece, found.iterations


def _is_far_outside(piece: Piece) -> NDArray[np.bool_]:
    """Which paths leave their patch so clearly that more functions would not bring them back.

    They have no length on the patch, and the polynomial that continues it out there may be wild.
    """
    result = np.zeros(len(piece.problems), bool)
    rows = np.flatnonzero(~piece.converged & np.isfinite(piece.values[:, 0, 0]))
    path = piece.values[rows] @ piece.space.between_nodes.T
    result[rows] = (np.abs(path - 0.5) > 0.5 + FAR_OUTSIDE).any(axis=(1, 2))
    return result


def default_centers(kernel: Kernel, count: int) -> _Array:
    """Centers for a number of functions; see `RBFCollocation`."""
    outer = count if count < kernel.degree else OUTER_CENTERS
    left = outer // 2
    reach = REACH / max(left, 1)
    below = -reach * (np.arange(left) + 0.5)[::-1]
    above = 1.0 + REACH / (outer - left) * (np.arange(outer - left) + 0.5)
    return np.concatenate([below, chebyshev_points(count - outer), above])


def chebyshev_points(count: int) -> _Array:
    """The inner Chebyshev-Lobatto points of [0, 1]."""
    return np.asarray(0.5 - 0.5 * np.cos(np.pi * np.arange(1, count + 1) / (count + 1)))


def straight(start: _Array, end: _Array, nodes: _Array) -> _Array:
    """Nodal values of straight lines in (u, v), shape (problems, 2, n + 1)."""
    line: _Array = start[:, :, None] + (end - start)[:, :, None] * nodes
    line[:, :, -1] = end
    return line


def is_good(measured: MeasuredLength, tolerance: float) -> NDArray[np.bool_]:
    """Whether lengths are known to a relative tolerance, and their corrections to be trusted."""
    result: NDArray[np.bool_] = (measured.error <= tolerance * measured.raw) & (
        np.abs(measured.correction) <= TRUSTED_CORRECTION * measured.raw
    )
    return result


def _sequence(name: str, values: Sequence[float]) -> _Array:
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        array = np.empty(())
    if array.ndim != 1:
        raise InputError(f"{name} is {values!r}; expected a sequence of numbers")
    return array


def _check_collocation_points(points: Sequence[float], counts: tuple[int, ...]) -> None:
    array = _sequence("collocation_points", points)
    if any(count != len(array) + 1 for count in counts):
        raise InputError(
            f"{array.size} collocation points for {', '.join(map(str, counts))} functions; "
            "expected one fewer than functions (the paper's equations (7) to (12))"
        )
    inside = (array > 0.0) & (array < 1.0)
    if not (inside.all() and (np.diff(array) > 0.0).all()):
        raise InputError("collocation points must increase, strictly between 0 and 1")
