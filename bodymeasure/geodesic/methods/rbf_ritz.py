"""The weak form with radial functions: the path of least energy among those of the paper."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.geodesic.lengths.functionals import energy
from bodymeasure.geodesic.methods.rbf_collocation import (
    FUNCTIONS,
    RBFCollocation,
    chebyshev_points,
    default_centers,
)
from bodymeasure.geodesic.solving.levenberg_marquardt import minimize
from bodymeasure.geodesic.solving.on_spaces import TOLERANCE, solve_on_spaces
from bodymeasure.geodesic.solving.protocol import MethodResult
from bodymeasure.geodesic.spaces.kernels import WU_C10, Kernel
from bodymeasure.geodesic.spaces.rbf import rbf_space
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

# With the constant, one function is determined by the two ends.
LEAST = 2


@dataclass(frozen=True)
class RBFRitz:
    r"""The weak form with radial functions, which the paper announced as its future work.

    u(t) and v(t) are those of `RBFCollocation`, the paper's equations (5) and (6). In place of the
    geodesic equations at collocation points, the energy :math:`\tfrac12 \int |x'|^2 dt` is
    minimized, so that :math:`\int x' \cdot (S_u \varphi + S_v \psi)' dt = 0` for all functions
    of the space that vanish at the ends: only first derivatives are needed, no points are to be
    chosen, and each length is an upper bound. With as many functions, the length of the path is
    mostly closer than by collocation, by factors of 1.4 to 3.4 in the page "analysis" of the
    documentation. With centers inside (0, 1), where collocation fails, this method does not.

    Parameters
    ----------
    kernel : Kernel
        Wu's functions `WU_C2` (the paper's), `WU_C4`, `WU_C6`, `WU_C10`, or any other.
    functions : int or sequence of int
        The number N of functions; several are tried in turn. It is ignored if centers are given.
    centers : sequence of float, optional
        The c_i; by default those of `RBFCollocation`.
    support_radius : float
        2 in the paper.
    tolerance : float
        The relative error of the length that is asked for.

    Raises
    ------
    InputError
        If a setting makes no sense.

    Examples
    --------
    >>> import numpy as np
    >>> import bodymeasure as bm
    >>> net = bm.load_sample("paraboloid").control_points[0]
    >>> inside = bm.RBFRitz(bm.WU_C4, centers=np.linspace(0, 1, 12))
    >>> for method in (bm.RBFRitz(), inside):
    ...     print(round(bm.solve_geodesic(net, (0, 0), (1, 1), method=method).length, 8))
    2.56200714
    2.56200714
    """

    kernel: Kernel = WU_C10
    functions: int | Sequence[int] = FUNCTIONS
    centers: Sequence[float] | None = None
    support_radius: float = 2.0
    tolerance: float = TOLERANCE

    def __post_init__(self) -> None:
        # The settings are those of collocation, and so are their faults.
        self._counts  # noqa: B018

    @property
    def _counts(self) -> tuple[int, ...]:
        counts = RBFCollocation(
            self.kernel,
            self.functions,
            self.centers,
            support_radius=self.support_radius,
            tolerance=self.tolerance,
        ).counts
        if min(counts) < LEAST:
            raise InputError(
                f"the weak form is given {min(counts)} function; expected at least {LEAST}, since "
                "one and a constant leave nothing to minimize between fixed ends"
            )
        return counts

    def _space(self, count: int) -> TrialSpace:
        given = default_centers(self.kernel, count) if self.centers is None else self.centers
        centers = tuple(float(center) for center in given)
        return rbf_space(self.kernel, centers, _nodes(centers), self.support_radius)

    def solve(self, surface: Surface, start: Array, end: Array) -> MethodResult:
        """Return paths from start to end, both of shape (problems, 2), on a batch of surfaces."""
        return solve_on_spaces(
            [partial(self._space, count) for count in self._counts],
            surface,
            (start, end),
            tolerance=self.tolerance,
            solver=partial(minimize, energy),
        )


def _nodes(centers: tuple[float, ...]) -> tuple[float, ...]:
    """The inner nodes whose values stand for the functions; the minimum does not depend on them.

    Functions centered outside are polynomials on [0, 1], which Chebyshev points hold best. Those
    that are centered inside are held best by points that are as far apart as their centers.
    """
    count = len(centers) - 1
    inside = [center for center in centers if 0.0 <= center <= 1.0]
    if 2 * len(inside) <= len(centers):
        return tuple(chebyshev_points(count))
    return tuple(np.arange(1, count + 1) / (count + 1))
