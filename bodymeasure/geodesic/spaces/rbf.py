"""The trial space of the paper: a constant and radial functions, equations (5) and (6)."""

from decimal import Decimal
from functools import lru_cache

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.arguments import numbers, require_kind
from bodymeasure.errors import InputError
from bodymeasure.geodesic.spaces.decimals import (
    Decimals,
    decimals,
    inverse,
    longdoubles,
    many_digits,
)
from bodymeasure.geodesic.spaces.kernels import Kernel
from bodymeasure.geodesic.spaces.piecewise import PiecewisePolynomials, sample_points
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.threads import one_blas_thread

# Past this condition number, what is left of the 60 digits of `decimals` no longer covers double
# precision with ten digits to spare.
DEGENERATE_CONDITION = 1e34
# Where the functions hardly differ at the nodes, the cardinal functions (1 at one node, 0 at the
# others) are huge between the nodes. The sum of their sizes is 2 to 4 on good nodes and grows like
# the condition number on bad ones; it is the factor by which rounding errors grow.
LARGEST_CARDINAL_SUM = 1e3
# Collocation points that make the system degenerate (symmetric ones do, for an odd number of
# functions with symmetric centers) are moved by these fractions of the gap to the next one, until
# one choice works: the paper's section 5 and Table 1, part 1.
SHIFTS = (0.0, 0.25, 0.4, -0.25, 0.1)
# Places where functions change their polynomial are taken for one if they are closer than this:
# they differ by rounding (-1.7 + 2 and 0.3).
CLOSEST_BREAKS = 1e-10


@lru_cache(maxsize=64)
def rbf_space(
    kernel: Kernel,
    centers: tuple[float, ...],
    collocation_points: tuple[float, ...],
    support_radius: float,
) -> TrialSpace:
    """Return the span of a constant and ``phi(|t - c_i| / radius)`` on given collocation points.

    Parameters
    ----------
    kernel : Kernel
    centers : tuple of float, N of them
        Anywhere on the real line.
    collocation_points : tuple of float, N - 1 of them
        Increasing, inside (0, 1).
    support_radius : float

    Returns
    -------
    TrialSpace
        With N + 1 nodes: 0, the collocation points (moved if the system would be degenerate
        otherwise, which the description says), 1.

    Raises
    ------
    InputError
        If no choice of collocation points makes the system regular.
    """
    breaks = _breaks(centers, support_radius)
    edges = np.array([0.0, *breaks, 1.0])
    samples = sample_points(edges, kernel.degree)
    condition, growth = float("inf"), float("inf")
    with many_digits():
        sampled_basis = basis(kernel, centers, samples.ravel(), support_radius)
        for shift in SHIFTS:
            nodes = _shifted_nodes(collocation_points, shift)
            inverted, condition = inverse(basis(kernel, centers, nodes, support_radius)[0])
            if inverted is None or condition > DEGENERATE_CONDITION:
                continue
            cardinal = np.stack([part @ inverted for part in sampled_basis])
            growth = min(growth, float(max(abs(cardinal[0]).sum(axis=1))))
            if growth < LARGEST_CARDINAL_SUM:
                functions = _piecewise(edges, samples, cardinal)
                break
        else:
            raise InputError(_refusal(f"{len(centers)} {kernel.name} functions", condition, growth))
    moved = "" if shift == 0.0 else f", collocation points moved by {shift:g} of their gaps"
    return TrialSpace(
        nodes=nodes,
        condition=condition,
        functions=functions,
        description=f"{len(centers)} {kernel.name} functions{moved}",
    )


def _refusal(functions: str, condition: float, growth: float) -> str:
    if np.isfinite(growth):
        return (
            f"{functions} hardly differ at any choice of collocation points tried: "
            f"between the points, rounding errors would grow by a factor of {growth:.1e}; choose "
            "fewer functions or a smaller support radius"
        )
    return (
        f"the collocation system of {functions} is degenerate (condition number {condition:.1e}) "
        "for every choice of collocation points tried; choose other centers (no two alike, each "
        "within a support radius of [0, 1]), a larger support radius, or another number of "
        "functions"
    )


def _piecewise(edges: Array, samples: Array, cardinal: Decimals) -> PiecewisePolynomials:
    """The polynomials through values and derivatives (3, all samples, functions)."""
    pieces, count = samples.shape
    by_piece = np.split(cardinal, pieces, axis=1)
    coefficients = np.empty((3, count, cardinal.shape[2], pieces), dtype=np.longdouble)
    for i, (values, points) in enumerate(zip(by_piece, decimals(samples), strict=True)):
        left, right = decimals(edges[i : i + 2])
        x = (2 * points - left - right) / (right - left)
        chebyshev = [x * 0 + 1, x]
        for _ in range(2, count):
            chebyshev.append(2 * x * chebyshev[-1] - chebyshev[-2])
        inverted, _ = inverse(np.stack(chebyshev[:count], axis=1))
        for order in range(3):
            coefficients[order, :, :, i] = longdoubles(inverted @ values[order])
    return PiecewisePolynomials(edges, coefficients)


@one_blas_thread()
def rbf_coefficients(
    kernel: Kernel,
    centers: tuple[float, ...],
    support_radius: float,
    nodes: Array,
    nodal_values: Array,
) -> Array:
    """Return the paper's coefficients a_0, ..., a_N (or b_i) of functions given by nodal values.

    Parameters
    ----------
    kernel : Kernel
    centers : tuple of float
        The N centers.
    support_radius : float
    nodes : ndarray, shape (N + 1,)
    nodal_values : ndarray, shape (N + 1, ...)

    Returns
    -------
    ndarray, shape (N + 1, ...)
        Coefficients for the kernel as it is written in `Kernel`, not normalized to phi(0) = 1.

    Raises
    ------
    InputError
        If the system is singular.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> method = bm.RBFCollocation(bm.WU_C2, centers=(1.0, 1.5))
    >>> solution = bm.solve_geodesic(
    ...     bm.load_sample("paraboloid").control_points[0], (0, 0), (1, 1),
    ...     method=method, on_failure="status",
    ... )
    >>> (paths,) = solution.batches
    >>> rbf_coefficients(
    ...     bm.WU_C2, (1.0, 1.5), 2.0, paths.space.nodes, paths.values[0].T
    ... ).shape
    (3, 2)
    """
    require_kind(kernel, Kernel, "the kernel", "a Kernel, such as WU_C2")
    places = [
        numbers(value, name, "numbers (k,)")
        for name, value in (("centers", centers), ("nodes", nodes))
    ]
    values = numbers(nodal_values, "nodal_values", "numbers (k, ...)")
    radius = numbers(support_radius, "support_radius", "a positive number")
    if any(array.ndim != 1 for array in places) or len(places[0]) + 1 != len(places[1]):
        raise InputError(
            f"centers have shape {places[0].shape} and nodes {places[1].shape}; expected (N,) and "
            "(N + 1,)"
        )
    if values.ndim == 0 or len(values) != len(places[1]):
        raise InputError(f"nodal_values have shape {values.shape}; expected a row for each node")
    if radius.ndim or not 0.0 < radius < np.inf:
        raise InputError(f"support_radius is {support_radius!r}; expected a positive number")
    with many_digits():
        inverted, _ = inverse(basis(kernel, centers, nodes, support_radius)[0])
        if inverted is None:
            raise InputError("the collocation system is singular; it has no coefficients")
        return np.asarray(inverted @ decimals(nodal_values), dtype=np.float64)


def _breaks(centers: tuple[float, ...], support_radius: float) -> list[float]:
    """The places inside (0, 1) at which a function changes its polynomial, as at its center."""
    places = sorted(c + side * support_radius for c in centers for side in (-1.0, 0.0, 1.0))
    breaks = [0.0]
    for place in places:
        if breaks[-1] + CLOSEST_BREAKS < place < 1.0 - CLOSEST_BREAKS:
            breaks.append(place)
    return breaks[1:]


def _shifted_nodes(collocation_points: tuple[float, ...], shift: float) -> Array:
    nodes = np.array([0.0, *collocation_points, 1.0])
    gaps = np.diff(nodes)
    nodes[1:-1] += shift * (gaps[1:] if shift > 0.0 else gaps[:-1])
    return nodes


def basis(
    kernel: Kernel, centers: tuple[float, ...], t: Array, support_radius: float
) -> list[Decimals]:
    """The values and two derivatives of 1, phi_1, ..., phi_N at t; each (k, N + 1)."""
    radius = Decimal(support_radius)
    offset = (decimals(t)[:, None] - decimals(centers)[None]) / radius
    distance = abs(offset)
    inside = distance <= 1
    coefficients = [Decimal(c) for c in kernel.coefficients]
    result = []
    for order in range(3):
        values = distance * 0 + coefficients[-1]
        for coefficient in reversed(coefficients[:-1]):
            values = values * distance + coefficient
        sign = np.where(offset < 0, -1, 1) if order == 1 else 1
        constant = decimals(np.full((len(t), 1), 1.0 if order == 0 else 0.0))
        result.append(np.hstack([constant, values * inside * sign / radius**order]))
        coefficients = [k * c for k, c in enumerate(coefficients)][1:] or [Decimal(0)]
    return result
