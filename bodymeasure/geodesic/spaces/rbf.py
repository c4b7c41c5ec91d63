"""The trial space of the paper: a constant and radial functions, equations (5) and (6)."""

from decimal import Context, Decimal, localcontext
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.geodesic.spaces.kernels import Kernel
from bodymeasure.geodesic.spaces.piecewise import PiecewisePolynomials, sample_points
from bodymeasure.geodesic.spaces.trial_space import TrialSpace

# Smooth kernels on many centers give condition numbers far beyond 1e16, though the space they span
# is well behaved: only the basis is bad. So the change of basis, from coefficients to nodal values,
# is done once per space in this many digits, and every matrix that double precision then meets has
# entries of moderate size.
DIGITS = 60
# Past this condition number what is left of 60 digits no longer covers double precision with ten
# to spare.
DEGENERATE_CONDITION = 1e34
# Nodes at which the functions can hardly be told apart show as cardinal functions (1 at one node, 0
# at the others) that are huge between the nodes. The sum of their sizes is 2 to 4 on good nodes and
# grows like the condition number on bad ones; it is the factor by which rounding errors grow.
LARGEST_CARDINAL_SUM = 1e3
# Collocation points that make the system degenerate (symmetric ones do, for an odd number of
# functions with symmetric centers) are moved by these fractions of the gap to the next one, until
# one choice works: the paper's section 5 and Table 1, part 1.
SHIFTS = (0.0, 0.25, 0.4, -0.25, 0.1)
# Places where functions change their polynomial are one place if they are closer than this: they
# differ by rounding (-1.7 + 2 and 0.3), and no points can be told apart between them.
CLOSEST_BREAKS = 1e-10

_Matrix = NDArray[Any]  # of Decimal


@lru_cache(maxsize=64)
def rbf_space(
    kernel: Kernel,
    centers: tuple[float, ...],
    collocation_points: tuple[float, ...],
    support_radius: float,
) -> TrialSpace:
    """The span of a constant and ``phi(|t - c_i| / radius)`` on given collocation points.

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
    with localcontext(Context(prec=DIGITS)):
        sampled_basis = _basis(kernel, centers, samples.ravel(), support_radius)
        for shift in SHIFTS:
            nodes = _shifted_nodes(collocation_points, shift)
            inverse, condition = _inverse(_basis(kernel, centers, nodes, support_radius)[0])
            if inverse is None or condition > DEGENERATE_CONDITION:
                continue
            cardinal = np.stack([part @ inverse for part in sampled_basis])
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
            f"{functions} can hardly be told apart at any choice of collocation points tried: "
            f"between the points, rounding errors would grow by a factor of {growth:.1e}; choose "
            "fewer functions or a smaller support radius"
        )
    return (
        f"the collocation system of {functions} is degenerate (condition number {condition:.1e}) "
        "for every choice of collocation points tried; choose other centers (no two alike, each "
        "within a support radius of [0, 1]), a larger support radius, or another number of "
        "functions"
    )


def _piecewise(edges: Array, samples: Array, cardinal: _Matrix) -> PiecewisePolynomials:
    """The polynomials through values and derivatives (3, all samples, functions)."""
    pieces, count = samples.shape
    by_piece = np.split(cardinal, pieces, axis=1)
    coefficients = np.empty((3, count, cardinal.shape[2], pieces), dtype=np.longdouble)
    for i, (values, points) in enumerate(zip(by_piece, _decimals(samples), strict=True)):
        left, right = _decimals(edges[i : i + 2])
        x = (2 * points - left - right) / (right - left)
        chebyshev = [x * 0 + 1, x]
        for _ in range(2, count):
            chebyshev.append(2 * x * chebyshev[-1] - chebyshev[-2])
        inverse, _ = _inverse(np.stack(chebyshev[:count], axis=1))
        for order in range(3):
            exact = inverse @ values[order]
            coefficients[order, :, :, i] = np.vectorize(_long, otypes=[np.longdouble])(exact)
    return PiecewisePolynomials(edges, coefficients)


def _long(value: Decimal) -> np.longdouble:
    """To extended precision by way of text, since a float would cut it to double."""
    return np.longdouble(f"{value:.25e}")


def rbf_coefficients(
    kernel: Kernel,
    centers: tuple[float, ...],
    support_radius: float,
    nodes: Array,
    nodal_values: Array,
) -> Array:
    """The paper's a_0, a_1, ..., a_N (or b_i) of functions given by nodal values.

    Parameters
    ----------
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
    """
    with localcontext(Context(prec=DIGITS)):
        inverse, _ = _inverse(_basis(kernel, centers, nodes, support_radius)[0])
        if inverse is None:
            raise InputError("the collocation system is singular; it has no coefficients")
        return np.asarray(inverse @ _decimals(nodal_values), dtype=np.float64)


def _breaks(centers: tuple[float, ...], support_radius: float) -> list[float]:
    """Where inside (0, 1) a function changes its polynomial: centers and ends of supports."""
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


def _decimals(values: Any) -> _Matrix:
    values = np.asarray(values, dtype=np.float64)
    flat = [Decimal(value) for value in values.ravel().tolist()]
    return np.array(flat, dtype=object).reshape(values.shape)


def _basis(
    kernel: Kernel, centers: tuple[float, ...], t: Array, support_radius: float
) -> list[_Matrix]:
    """Values, first and second derivatives of 1, phi_1, ..., phi_N at t; each (k, N + 1)."""
    radius = Decimal(support_radius)
    offset = (_decimals(t)[:, None] - _decimals(centers)[None]) / radius
    distance = abs(offset)
    inside = distance <= 1
    coefficients = [Decimal(c) for c in kernel.coefficients]
    result = []
    for order in range(3):
        values = distance * 0 + coefficients[-1]
        for coefficient in reversed(coefficients[:-1]):
            values = values * distance + coefficient
        sign = np.where(offset < 0, -1, 1) if order == 1 else 1
        constant = _decimals(np.full((len(t), 1), 1.0 if order == 0 else 0.0))
        result.append(np.hstack([constant, values * inside * sign / radius**order]))
        coefficients = [k * c for k, c in enumerate(coefficients)][1:] or [Decimal(0)]
    return result


def _inverse(matrix: _Matrix) -> tuple[_Matrix | None, float]:
    """Gauss-Jordan inverse with row pivoting, and the condition number in the 1-norm."""
    size = len(matrix)
    rows = np.hstack([matrix, _decimals(np.eye(size))])
    for k in range(size):
        pivot = max(range(k, size), key=lambda i: abs(rows[i, k]))
        if rows[pivot, k] == 0:
            return None, float("inf")
        rows[[k, pivot]] = rows[[pivot, k]]
        rows[k] = rows[k] / rows[k, k]
        others = np.arange(size) != k
        rows[others] = rows[others] - rows[others, k : k + 1] * rows[k]
    inverse = rows[:, size:]
    norms = [max(abs(part).sum(axis=0)) for part in (matrix, inverse)]
    return inverse, float(norms[0] * norms[1])
