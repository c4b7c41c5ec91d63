"""Collocation with polynomials: the same equations on another trial space."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from bodymeasure._typing import Array
from bodymeasure.geodesic.methods.collocation import Form, check_form, collocate
from bodymeasure.geodesic.methods.settings import check_positive, whole_numbers
from bodymeasure.geodesic.solving.on_spaces import TOLERANCE
from bodymeasure.geodesic.solving.protocol import MethodResult
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface

# As many unknowns as the radial functions have.
DEGREES = (8, 12, 16, 20)
# A straight line has no collocation point.
LEAST_DEGREE = 2


@dataclass(frozen=True)
class PolynomialCollocation:
    """Collocation with polynomials at Chebyshev-Lobatto points.

    The equations, Newton's method and the error estimate are those of `RBFCollocation`. Only the
    trial space is another, which shows what the radial functions add or cost.
    The error falls exponentially with the degree (L. N. Trefethen, *Spectral Methods in MATLAB*,
    chapters 4 to 6 and 13). Rounding errors grow with the fourth power of the degree in the
    equations; past some 60 nothing is gained.

    Parameters
    ----------
    degrees : int or sequence of int
        The polynomials' degree, at least 2; several are tried in turn.
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
    >>> method = bm.PolynomialCollocation(degrees=(10, 20))
    >>> round(bm.solve_geodesic(net, (0, 0), (1, 1), method=method).length, 8)
    2.56200714
    """

    degrees: int | Sequence[int] = DEGREES
    tolerance: float = TOLERANCE
    form: Form = "fast"

    def __post_init__(self) -> None:
        check_form(self.form)
        whole_numbers("degrees", self.degrees, LEAST_DEGREE)
        check_positive("tolerance", self.tolerance)

    def solve(self, surface: Surface, start: Array, end: Array) -> MethodResult:
        """Return paths from start to end, both of shape (problems, 2), on a batch of surfaces."""
        makers = [
            partial(polynomial_space, n)
            for n in whole_numbers("degrees", self.degrees, LEAST_DEGREE)
        ]
        return collocate(makers, surface, (start, end), tolerance=self.tolerance, form=self.form)
