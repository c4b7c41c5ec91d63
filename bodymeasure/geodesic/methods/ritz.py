"""Ritz's method: the path of least energy, or length, among polynomials."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Literal

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.geodesic.lengths.functionals import energy, length_over_v
from bodymeasure.geodesic.methods.settings import check_positive, whole_numbers
from bodymeasure.geodesic.solving.levenberg_marquardt import minimize
from bodymeasure.geodesic.solving.on_spaces import TOLERANCE, solve_on_spaces
from bodymeasure.geodesic.solving.protocol import MethodResult
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface

ORDERS = (8, 12, 16, 20)
# A straight line has nothing to vary.
LEAST_ORDER = 2


@dataclass(frozen=True)
class Ritz:
    r"""The weak form: a polynomial path of least energy or length.

    No second derivative of the path is needed, and no collocation point chosen. u(t) and v(t) are
    polynomials whose order is raised until the estimated error is small enough, as in the paper's
    Table 2 (I. M. Gelfand, S. V. Fomin, *Calculus of Variations*, section 40). They are held by
    their values at Chebyshev-Lobatto points: the powers of (14) span the same space, but with a
    condition number that grows exponentially.

    Parameters
    ----------
    order : int or sequence of int
        The polynomials' order, at least 2; several are tried in turn.
    parametrization : {"arbitrary", "u"}
        "arbitrary": u and v are both unknown, and the energy :math:`\tfrac12 \int |x'|^2 dt` is
        minimized, whose minimum is the shortest path run through at constant speed. "u", the
        paper's (13) and (14): u runs linearly with t, v alone is unknown, and the length is
        minimized. That takes a path on which u is strictly monotonic; where it turns back, no
        order helps (``NOT_CONVERGED``), and between ends with the same u there is none.
    tolerance : float
        The relative error of the length that is asked for.

    Raises
    ------
    InputError
        If a setting makes no sense, or ends have the same u with parametrization "u".

    Examples
    --------
    >>> import bodymeasure as bm
    >>> net = bm.load_sample("paraboloid").control_points[0]
    >>> method = bm.Ritz(order=(6, 12, 18))
    >>> round(bm.solve_geodesic(net, (0, 0), (1, 1), method=method).length, 8)
    2.56200714
    """

    order: int | Sequence[int] = ORDERS
    parametrization: Literal["arbitrary", "u"] = "arbitrary"
    tolerance: float = TOLERANCE

    def __post_init__(self) -> None:
        whole_numbers("order", self.order, LEAST_ORDER)
        check_positive("tolerance", self.tolerance)
        if self.parametrization not in ("arbitrary", "u"):
            raise InputError(
                f"parametrization is {self.parametrization!r}; expected 'arbitrary' or 'u'"
            )

    def solve(self, surface: Surface, start: Array, end: Array) -> MethodResult:
        """Return paths from start to end, both of shape (problems, 2), on a batch of surfaces."""
        if self.parametrization == "u":
            same = np.flatnonzero(start[:, 0] == end[:, 0])
            if len(same):
                first, last = start[same[0]].tolist(), end[same[0]].tolist()
                raise InputError(
                    f"start {first} and end {last} have the same u, so that v is no function of "
                    "u between them; use Ritz(parametrization='arbitrary')"
                )
        functional = energy if self.parametrization == "arbitrary" else length_over_v
        return solve_on_spaces(
            [partial(polynomial_space, n) for n in whole_numbers("order", self.order, LEAST_ORDER)],
            surface,
            (start, end),
            tolerance=self.tolerance,
            solver=partial(minimize, functional),
        )
