"""Table 2, with which the paper compares: Ritz's method with u = t and v a polynomial of u."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.errors import InputError
from bodymeasure.geodesic.lengths.functionals import length_over_v
from bodymeasure.geodesic.solving.levenberg_marquardt import minimize
from bodymeasure.geodesic.solving.newton import MAX_ITERATIONS
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.paper.method.arc_length import arc_lengths, inside_patch

# The paper gives six figures of lengths of about 1, but neither its bound nor its limit.
ERROR_BOUND = 1e-6
MAX_ORDER = 16


@dataclass(frozen=True, eq=False)
class RitzSolution:
    """The results of Ritz's method for a batch of patches; arrays of shape (patches,).

    Parameters
    ----------
    length : ndarray
        The least length of all orders, as in Table 2; NaN where it is no number.
    order : ndarray of int
        The last order that was tried.
    change : ndarray
        The change of the length with the last order, which is the table's Error.
    stopped : ndarray of bool
        Whether the change fell under the bound before the orders were exhausted.
    inside : ndarray of bool
        Whether the path of the last order stays in its patch.
    """

    length: Array
    order: Ints
    change: Array
    stopped: Bools
    inside: Bools


def solve_ritz(
    control_points: Array, error_bound: float = ERROR_BOUND, max_order: int = MAX_ORDER
) -> RitzSolution:
    """Return diagonals from (0, 0) to (1, 1) by equations (13) and (14).

    The length is minimized over v alone, from the path of the order before; the first one is the
    straight line in (u, v). A path that turns back in u cannot be found, and a path that leaves the
    patch is not kept inside.

    Parameters
    ----------
    control_points : ndarray, shape (patches, 4, 4, 3)
    error_bound : float
        Bound in the unit of the control points.
    max_order : int

    Raises
    ------
    InputError
        If the bound is not positive or the limit is below 2.
    """
    if not error_bound > 0.0:
        raise InputError(f"error_bound is {error_bound!r}; expected a positive number")
    if max_order < 2:
        raise InputError(f"max_order is {max_order!r}; expected a whole number of at least 2")
    count = len(control_points)
    change, order = np.full(count, np.inf), np.ones(count, np.int64)
    inside, rows = np.ones(count, bool), np.arange(count)
    surface, space = BezierSurfaces(control_points), polynomial_space(1)
    values = np.broadcast_to(space.nodes, (count, 2, 2))
    length = arc_lengths(surface, space, values)
    for degree in range(2, max_order + 1):
        finer = polynomial_space(degree)
        guess = values @ space.matrices(finer.nodes)[0].T
        # Rounding must move neither the ends, nor u away from t.
        guess[:, 0], guess[:, :, 0], guess[:, :, -1] = finer.nodes, 0.0, 1.0
        part, space = surface.take(rows), finer
        values = minimize(length_over_v, part, space, guess, max_iterations=MAX_ITERATIONS).values
        here = arc_lengths(part, space, values)
        change[rows], order[rows] = np.abs(length[rows] - here), degree
        length[rows] = np.minimum(length[rows], here)
        inside[rows] = inside_patch(space, values)
        more = change[rows] > error_bound
        rows, values = rows[more], values[more]
        if len(rows) == 0:
            break
    finite = np.isfinite(length)
    return RitzSolution(
        np.where(finite, length, np.nan), order, change, finite & (change <= error_bound), inside
    )
