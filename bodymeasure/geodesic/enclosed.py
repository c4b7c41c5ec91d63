"""Rigorous bounds of the lengths of shortest paths on patches."""

from typing import Any

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.arguments import require_kind
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.geodesic.methods.polynomial_collocation import PolynomialCollocation
from bodymeasure.geodesic.proofs.bounds import Bounds
from bodymeasure.geodesic.solution import GeodesicSolution
from bodymeasure.geodesic.solve import solve_geodesic
from bodymeasure.geodesic.status import Status
from bodymeasure.threads import one_blas_thread

# The degrees of paths that are tried in turn, until the bounds are as close as this, relatively.
DEGREES = (16, 24, 36)
CLOSE = 1e-10
# Bounds that a higher degree makes no closer than by this factor are not limited by the path.
NO_BETTER = 0.5
# The degree of patches up to which products of their polynomials fit the exact arithmetic.
MOST_DEGREE = 10


@one_blas_thread()
def enclose(solution: GeodesicSolution, *, degree: int | None = None) -> Bounds:
    """Return bounds of the lengths of shortest paths that leave out no rounding and no sampling.

    A polynomial path with exact coefficients is put through points of each geodesic. Its length is
    enclosed in ball arithmetic, with what the series leaves out, and so is its geodesic curvature
    everywhere; the bound of the patch's curvature is computed in exact rational arithmetic. What
    follows for the shortest path is a theorem (see the page "proofs" of the documentation). This
    takes some seconds a path.

    Parameters
    ----------
    solution : GeodesicSolution
        On polynomial patches, whose control points are taken as the exact numbers that they are.
    degree : int, optional
        The degree of the polynomial paths; higher ones give closer bounds and take longer. By
        default, up to three are tried in turn until the bounds differ by less than 1e-10 of them.

    Returns
    -------
    Bounds
        In the unit of the control points, rounded outward. Where the theorem says nothing, the
        distance in space is the lower bound; where no path is shown to run on the patch, the
        upper bound is infinite. NaN unless the status is ``CONVERGED``.

    Raises
    ------
    MissingExtraError
        If python-flint is not installed; the extra "rigorous" has it.
    InputError
        If the surfaces are no polynomial patches, or the degree is not from 3 to 40.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> net = bm.load_sample("hyperbolic_paraboloid").control_points[0]
    >>> lower, upper = bm.enclose(bm.solve_geodesic(net, (0, 0), (1, 1)))
    >>> known = 1.7978527887818834
    >>> lower < known < upper, (upper - lower) / known < 1e-9
    (True, True)
    """
    require_kind(solution, GeodesicSolution, "the solution", "what solve_geodesic returns")
    if degree is not None and not (isinstance(degree, int | np.integer) and 3 <= degree <= 40):
        raise InputError(f"degree is {degree!r}; expected a whole number from 3 to 40")
    patches = solution.patches
    if patches is None:
        raise InputError(
            "the solution is on a surface that is no polynomial patch; enclosures are for "
            "control points (..., m + 1, n + 1, 3)"
        )
    if max(patches.nets.shape[1:3]) - 1 > MOST_DEGREE:
        raise InputError(
            f"the patches are of degree {max(patches.nets.shape[1:3]) - 1}; enclosures are for "
            f"degrees of at most {MOST_DEGREE}"
        )
    try:
        from bodymeasure.geodesic.rigorous.bounds import enclose_shortest
    except ModuleNotFoundError as error:
        if error.name != "flint":
            raise
        raise MissingExtraError("ball arithmetic", "python-flint", "rigorous") from None
    count = int(np.prod(solution.shape))
    bounds = np.full((2, count), np.nan)
    status = np.asarray(solution.status, dtype=object).ravel()
    starts, ends = (each.reshape(-1, 2) for each in (solution.start, solution.end))
    nets = patches.nets
    for number in range(count):
        if status[number] is not Status.CONVERGED:
            continue
        if (starts[number] == ends[number]).all():
            bounds[:, number] = 0.0
            continue
        net, width = nets[patches.surface_of[number]], np.inf
        for tried in DEGREES if degree is None else (degree,):
            places = _places(net, starts[number], ends[number], tried)
            lower, upper = enclose_shortest(net, places)
            if upper - lower < width or np.isnan(bounds[1, number]):
                bounds[:, number] = lower, upper
            before, width = width, upper - lower
            if width <= CLOSE * upper or width > NO_BETTER * before:
                break
    # The scale is a power of 2, so that nothing is rounded.
    bounds[0] = np.maximum(bounds[0], 0.0)
    bounds *= patches.scale
    shaped: Any = bounds.reshape(2, *solution.shape) if solution.shape else bounds[:, 0].tolist()
    return Bounds(*shaped)


def _places(net: Array, start: Array, end: Array, degree: int) -> Array:
    """Values of u and v of a path at Chebyshev-Lobatto points, shape (2, degree + 1)."""
    method = PolynomialCollocation(degrees=degree, tolerance=1.0)
    found = solve_geodesic(net, start, end, method=method, on_failure="status")
    if found.status is not Status.CONVERGED:
        found = solve_geodesic(net, start, end, on_failure="status")
    times = 0.5 - 0.5 * np.cos(np.pi * np.arange(degree + 1) / degree)
    return np.ascontiguousarray(found.path(times).T)
