r"""The length of a computed path, how much too long it is, and how sure that is.

A path :math:`\gamma` that is not quite a geodesic has a geodesic curvature :math:`\kappa_g`. Let
:math:`\psi` be how far the geodesic between the same ends lies to its side. In coordinates of arc
length s along the path and distance n from it, the metric is
:math:`ds^2 (1 - 2 \kappa_g n + (\kappa_g^2 - K) n^2 + \dots) + dn^2`, so the length of the path
shifted by :math:`\psi` is

.. math:: L(\psi) = L - \int \kappa_g \psi + \tfrac12 \int (\psi'^2 - K \psi^2) + \dots

(K is the Gaussian curvature). It is stationary where :math:`-\psi'' - K \psi = \kappa_g`, the
Jacobi equation with zero ends, and there :math:`L - L(\psi) = \tfrac12 \int \kappa_g \psi` to
leading order. That excess is subtracted. What is left over is estimated by

- the last Galerkin modes of :math:`\psi`, for those that were left out;
- the next term of the expansion, :math:`\tfrac16 \int |\partial_n K| |\psi|^3`, with the
  derivative across the path taken to be of the size of that along it, and of 4 K / L;
- the terms after it, :math:`\int |\kappa_g \psi| \psi'^2 / 2 + \psi'^4 / 8 + K^2 \psi^4`;
- ten times the error that the quadrature estimates of itself;

all tripled, plus rounding. The factors were fixed by measurement
(``tests/benchmarks/error_estimate.py``): on random and body patches the estimate covers the true
error of the corrected length on more than 99.9 % of paths, and is 30 to 150 times too large in the
median on bodies, up to 600 times on wild patches. It is leading order: callers trust it only where
the correction is a small part of the length (`TRUSTED_CORRECTION`).
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import lru_cache

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from bodymeasure.geodesic.path_geometry import path_geometry
from bodymeasure.geodesic.quadrature import Quadrature
from bodymeasure.geodesic.surface import Surface
from bodymeasure.geodesic.trial_space import TrialSpace

_Array = NDArray[np.float64]

# The expansion is leading order: past this part of the length the correction is not to be trusted.
TRUSTED_CORRECTION = 1e-4
# See the module's text.
SAFETY = 3.0
QUADRATURE_SAFETY = 10.0
CURVATURE_VARIATION = 4.0
# Rounding errors of a length, relative, a node: measured against 40-node solutions.
ROUNDING = 2e-16
# If the length times the integral of the positive part of K is below this, no conjugate point can
# lie on the path: Lyapunov's inequality (P. Hartman, Ordinary Differential Equations, XI.5.1).
LYAPUNOV_BOUND = 4.0


@dataclass(frozen=True)
class MeasuredLength:
    """Lengths of computed paths, and what is known of their errors; arrays of shape (problems,).

    Parameters
    ----------
    raw : ndarray
        Length of the path as computed.
    correction : ndarray
        How much longer than the geodesic the path is, to leading order.
    error : ndarray
        Estimated error of ``raw - correction``.
    residual : ndarray
        Largest geodesic curvature at the quadrature points, which lie between the nodes, times the
        length: 0 for a geodesic.
    minimal : ndarray of bool
        The path is a strict local minimum of length: no conjugate point.
    """

    raw: _Array
    correction: _Array
    error: _Array
    residual: _Array
    minimal: NDArray[np.bool_]

    @property
    def corrected(self) -> _Array:
        """The length of the geodesic: of the path, less its excess."""
        return self.raw - self.correction

    def take(self, rows: NDArray[np.int64]) -> MeasuredLength:
        """The lengths of some of the problems."""
        return MeasuredLength(*(getattr(self, field.name)[rows] for field in fields(self)))


def measure_length(surface: Surface, space: TrialSpace, values: _Array) -> MeasuredLength:
    """Length, leading-order correction and error estimate of paths.

    Parameters
    ----------
    surface : Surface
    space : TrialSpace
    values : ndarray, shape (problems, 2, n + 1)
        u and v at the nodes.
    """
    quadrature = space.quadrature
    place, *slopes = space.at_quadrature
    # As in `equations`: rounding of the sums that differentiate must not grow with the place.
    moved = values - values[:, :, :1]
    geometry = path_geometry(surface, values @ place.T, *(moved @ rows.T for rows in slopes))
    speed, kappa, curvature = (
        geometry.speed,
        geometry.geodesic_curvature,
        geometry.gaussian_curvature,
    )
    length = quadrature.integrate(speed)
    modes = _modes(quadrature, space.size)
    # The Galerkin system of the Jacobi equation, with d/ds = (1 / speed) d/dt and ds = speed dt.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        weighted = quadrature.weights * speed
        stiffness = (quadrature.weights / speed) @ modes.slope_products
        stiffness -= (weighted * curvature) @ modes.value_products
        stiffness = stiffness.reshape(-1, modes.count, modes.count)
        load = (weighted * kappa) @ modes.values
        solution, solvable = _solve(stiffness, load)
        by_mode = 0.5 * load * solution
        correction = by_mode.sum(axis=1)
        shift = solution @ modes.values.T
        slope = (solution @ modes.slopes.T) / speed
        left_out = np.abs(by_mode[:, -2:]).sum(axis=1)
        error = SAFETY * (
            left_out
            + _next_order(quadrature, geometry.speed, kappa, curvature, shift, slope, length)
            + QUADRATURE_SAFETY * quadrature.error_estimate(speed)
        )
    # Besides sums of many terms, what is left over of the solution of the collocation equations.
    error += ROUNDING * (10.0 + space.size) * length
    minimal = _is_minimal(
        stiffness, quadrature.integrate(np.maximum(curvature, 0.0) * speed), length
    )
    return MeasuredLength(
        raw=length,
        correction=correction,
        error=np.where(solvable & np.isfinite(error), error, np.inf),
        residual=np.abs(kappa).max(axis=1) * length,
        minimal=minimal & solvable,
    )


def _next_order(
    quadrature: Quadrature,
    speed: _Array,
    kappa: _Array,
    curvature: _Array,
    shift: _Array,
    slope: _Array,
    length: _Array,
) -> _Array:
    along = np.abs(np.diff(curvature, axis=1) / np.diff(quadrature.points))
    variation = (along / np.minimum(speed[:, 1:], speed[:, :-1])).max(axis=1)
    variation += CURVATURE_VARIATION * np.abs(curvature).max(axis=1) / length
    square, shift_square = slope * slope, shift * shift
    cubic = quadrature.integrate(np.abs(shift) * shift_square * speed) * variation / 6.0
    quartic = np.abs(kappa * shift) * square / 2.0 + square * square / 8.0
    quartic += (curvature * shift_square) ** 2
    result: _Array = cubic + quadrature.integrate(quartic * speed)
    return result


def _is_minimal(stiffness: _Array, positive_curvature: _Array, length: _Array) -> NDArray[np.bool_]:
    """Whether the second variation of length is positive definite; the cheap test first."""
    minimal = positive_curvature * length < LYAPUNOV_BOUND
    doubtful = np.flatnonzero(~minimal & np.isfinite(stiffness).all(axis=(1, 2)))
    if len(doubtful):
        minimal[doubtful] = np.linalg.eigvalsh(stiffness[doubtful])[:, 0] > 0.0
    return minimal


def _solve(matrix: _Array, right: _Array) -> tuple[_Array, NDArray[np.bool_]]:
    solvable = np.asarray(np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(right).all(axis=1))
    if not solvable.all():
        matrix = np.where(solvable[:, None, None], matrix, np.eye(matrix.shape[-1]))
        right = np.where(solvable[:, None], right, 0.0)
    try:
        solution = np.linalg.solve(matrix, right[..., None])[..., 0].astype(np.float64)
    except np.linalg.LinAlgError:
        # One of the batch is exactly singular: it has a conjugate point at its very end.
        regular = np.abs(np.linalg.eigvalsh(matrix)).min(axis=1) > 0.0
        solvable &= regular
        matrix = np.where(solvable[:, None, None], matrix, np.eye(matrix.shape[-1]))
        solution = np.linalg.solve(matrix, right[..., None])[..., 0].astype(np.float64)
    return solution, solvable


@dataclass(frozen=True)
class _Modes:
    """Functions on [0, 1] that vanish at its ends, at the points of a quadrature.

    Integrated Legendre polynomials, scaled so that their slopes are orthonormal: the Jacobi
    system is then nearly the identity divided by the length.
    """

    count: int
    values: _Array
    slopes: _Array
    value_products: _Array
    slope_products: _Array


@lru_cache(maxsize=32)
def _modes_on(points: tuple[float, ...], count: int) -> _Modes:
    x = 2.0 * np.array(points) - 1.0
    basis = legendre.legvander(x, count + 1)
    k = np.arange(1, count + 1)
    values = (basis[:, 2:] - basis[:, :-2]) / (2.0 * np.sqrt(2.0 * k + 1.0))
    slopes = np.sqrt(2.0 * k + 1.0) * basis[:, 1:-1]
    return _Modes(
        count,
        values,
        slopes,
        (values[:, :, None] * values[:, None, :]).reshape(len(x), -1),
        (slopes[:, :, None] * slopes[:, None, :]).reshape(len(x), -1),
    )


def _modes(quadrature: Quadrature, size: int) -> _Modes:
    """Twice as many modes as the path has, which is as far as the quadrature reaches."""
    return _modes_on(tuple(quadrature.points), min(2 * size, len(quadrature.points) - 3))
