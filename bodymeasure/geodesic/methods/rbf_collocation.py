"""Radial basis function collocation, the paper's method."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.geodesic.methods.collocation import Form, check_form, collocate
from bodymeasure.geodesic.methods.settings import check_positive, whole_numbers
from bodymeasure.geodesic.solving.on_spaces import TOLERANCE
from bodymeasure.geodesic.solving.protocol import MethodResult
from bodymeasure.geodesic.spaces.kernels import WU_C10, Kernel
from bodymeasure.geodesic.spaces.rbf import rbf_space
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

# The numbers of functions that are tried in turn. They are even, so that symmetric centers and
# collocation points give a regular system. 8 functions serve 9 of 10 diagonals of a body, 12 nearly
# all of the rest (tests/benchmarks/patches/rbf_convergence.py).
FUNCTIONS = (8, 12, 16, 20)
# More functions than this are refused at once. Their system is solved with 60 digits, which takes
# seconds from here on, and with the default support radius they already differ too little.
MOST_FUNCTIONS = 40
# With more functions than the kernel's degree, this many centers stay outside [0, 1].
OUTER_CENTERS = 8
# How far outside they lie: half as far as the paper's, whose second center is at 1.5, to double.
REACH = 0.9


@dataclass(frozen=True)
class RBFCollocation:
    """Collocation with radial basis functions: the paper's equations (5) to (12).

    ``u(t) = a_0 + sum a_i phi(|t - c_i| / r)``, and v alike, meet the geodesic equations at the
    collocation points and the end conditions at t = 0 and 1. Newton's method solves for the nodal
    values, from a straight line in (u, v). The length is measured and corrected, and its error
    estimated, by the residual between the collocation points (`lengths.measure`). Where the
    estimate is not under the tolerance, the same is done with more functions, from the path found
    so far.

    Parameters
    ----------
    kernel : Kernel
        Wu's functions `WU_C2` (the paper's), `WU_C4`, `WU_C6`, `WU_C10`, or any other.
    functions : int or sequence of int
        The number N of functions, at most 40; several are tried in turn. It is ignored if centers
        are given.
    centers : sequence of float, optional
        The c_i. By default half of them lie on each side outside (0, 1), as the paper's 1 and 1.5
        do; there the functions are single polynomials on [0, 1], and convergence is spectral, as
        long as there are fewer of them than the kernel's degree. If there are more, the rest lie
        inside at Chebyshev points, and convergence is algebraic.
    collocation_points : sequence of float, optional
        N - 1 points in (0, 1), by default Chebyshev-Lobatto points. They are moved if the system
        is degenerate on them.
    support_radius : float
        The r above; 2 in the paper.
    tolerance : float
        The relative error of the length that is asked for.
    form : {"fast", "full"}
        "fast" solves for one unknown function where that serves, which is several times as fast;
        "full" solves for u and v everywhere.

    Raises
    ------
    InputError
        If a setting makes no sense.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> net = bm.load_sample("paraboloid").control_points[0]
    >>> method = bm.RBFCollocation(bm.WU_C6, functions=(8, 12, 16))
    >>> round(bm.solve_geodesic(net, (0, 0), (1, 1), method=method).length, 8)
    2.56200714
    """

    kernel: Kernel = WU_C10
    functions: int | Sequence[int] = FUNCTIONS
    centers: Sequence[float] | None = None
    collocation_points: Sequence[float] | None = None
    support_radius: float = 2.0
    tolerance: float = TOLERANCE
    form: Form = "fast"

    def __post_init__(self) -> None:
        check_form(self.form)
        check_positive("support_radius", self.support_radius)
        check_positive("tolerance", self.tolerance)
        if not isinstance(self.kernel, Kernel):
            raise InputError(f"kernel is {self.kernel!r}; expected a Kernel, such as WU_C2")
        if self.centers is not None:
            centers = _sequence("centers", self.centers)
            if not (len(centers) and np.isfinite(centers).all()):
                raise InputError(
                    f"centers is {self.centers!r}; expected finite numbers, at least one"
                )
        counts = self.counts
        if self.collocation_points is not None:
            _check_collocation_points(self.collocation_points, counts)

    @cached_property
    def counts(self) -> tuple[int, ...]:
        """The numbers of functions that are tried in turn."""
        if self.centers is not None:
            counts: tuple[int, ...] = (len(self.centers),)
        else:
            counts = whole_numbers("functions", self.functions, 1)
        if max(counts) > MOST_FUNCTIONS:
            raise InputError(
                f"{max(counts)} functions are asked for; expected at most {MOST_FUNCTIONS}, since "
                "more hardly differ from one another, and take long to tell apart"
            )
        return counts

    @property
    def spaces(self) -> Iterator[TrialSpace]:
        """The trial spaces that are tried in turn, each made when it is needed."""
        return map(self._space, self.counts)

    def _space(self, count: int) -> TrialSpace:
        if self.centers is None and self.collocation_points is None:
            return _default_space(self.kernel, count, self.support_radius)
        centers, points = self.centers, self.collocation_points
        return rbf_space(
            self.kernel,
            tuple(default_centers(self.kernel, count) if centers is None else centers),
            tuple(chebyshev_points(count - 1) if points is None else points),
            self.support_radius,
        )

    def solve(self, surface: Surface, start: Array, end: Array) -> MethodResult:
        """Return paths from start to end, both of shape (problems, 2), on a batch of surfaces."""
        makers = [partial(self._space, count) for count in self.counts]
        return collocate(makers, surface, (start, end), tolerance=self.tolerance, form=self.form)


@lru_cache(maxsize=64)
def _default_space(kernel: Kernel, count: int, support_radius: float) -> TrialSpace:
    centers, points = default_centers(kernel, count), chebyshev_points(count - 1)
    return rbf_space(kernel, tuple(centers), tuple(points), support_radius)


def default_centers(kernel: Kernel, count: int) -> Array:
    """Return the centers for a number of functions; see `RBFCollocation`."""
    outer = count if count < kernel.degree else OUTER_CENTERS
    left = outer // 2
    reach = REACH / max(left, 1)
    below = -reach * (np.arange(left) + 0.5)[::-1]
    above = 1.0 + REACH / (outer - left) * (np.arange(outer - left) + 0.5)
    return np.concatenate([below, chebyshev_points(count - outer), above])


def chebyshev_points(count: int) -> Array:
    """Return the inner Chebyshev-Lobatto points of [0, 1]."""
    return np.asarray(0.5 - 0.5 * np.cos(np.pi * np.arange(1, count + 1) / (count + 1)))


def _sequence(name: str, values: Sequence[float]) -> Array:
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
        raise InputError(
            f"collocation_points is {points!r}; expected numbers that increase, strictly between "
            "0 and 1"
        )
