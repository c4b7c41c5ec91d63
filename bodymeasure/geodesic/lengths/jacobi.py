"""The Jacobi equation along computed paths, which gives a length its correction and its error.

The formulas are derived in the text of `measure`.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.polynomial import legendre

from bodymeasure._typing import Array
from bodymeasure.geodesic.lengths.length import UNKNOWN, Length, is_leading_order
from bodymeasure.geodesic.lengths.path_geometry import PathGeometry
from bodymeasure.geodesic.numerics.array_libraries import constant
from bodymeasure.geodesic.numerics.elimination import solve_symmetric
from bodymeasure.geodesic.spaces.quadrature import Quadrature
from bodymeasure.geodesic.spaces.trial_space import TrialSpace

# See the text of `measure`.
SAFETY = 5.0
QUADRATURE_SAFETY = 3.0
CURVATURE_VARIATION = 4.0
# The relative rounding error of a length for each node, measured against 40-node solutions.
ROUNDING = 2e-16
# If the length times the integral of the positive part of K is below this, no conjugate point can
# lie on the path: Lyapunov's inequality (P. Hartman, Ordinary Differential Equations, XI.5.1).
LYAPUNOV_BOUND = 4.0
# For more modes than this the products of all pairs take too much memory, and problems are few.
MOST_IN_ONE_PRODUCT = 48
# On spaces of fewer functions, two modes are not enough to estimate what is left out.
FEW = 6
# An eigenvalue of the second variation that is this small, beside its others of about 1, is made of
# rounding errors, and its sign says nothing.
EIGENVALUE_ROUNDING = 1e-11


def length_and_error(space: TrialSpace, along: PathGeometry, xp: Any) -> Length:
    """Return lengths, their excess, the error that is left and the index, in one elimination.

    Parameters
    ----------
    space : TrialSpace
        The trial space of the paths.
    along : PathGeometry
        The geometry of the paths at the points of the space's quadrature.
    xp : namespace of the arrays
        It keeps to the Python array API standard. Where a path stands still or the surface is
        singular, it is the caller who silences divisions by zero.

    Returns
    -------
    Length
        The arrays are of the library `xp`.
    """
    speed, kappa, curvature = along
    quadrature = space.quadrature
    modes = modes_on(quadrature, space.size)
    weights = constant(quadrature.weights, speed, xp)
    length = weights @ speed
    # The Galerkin system of the Jacobi equation, with d/ds = (1 / speed) d/dt and ds = speed dt.
    weighted = weights[:, None] * speed
    densities = xp.concat([weights[:, None] / speed, weighted * curvature])
    values = constant(modes.values, speed, xp)
    load = xp.matrix_transpose(values) @ (weighted * kappa)
    solution, pivots = solve_symmetric(modes.system(densities, xp), load, xp)
    by_mode = 0.5 * load * solution
    shift = values @ solution
    slope = (constant(modes.slopes, speed, xp) @ solution) / speed
    variation = _curvature_variation(quadrature, along, xp)
    left_out = xp.sum(xp.abs(by_mode[-2:, :]), axis=0)
    if len(quadrature.widths) > 1 or space.size < FEW:
        left_out = left_out + _beyond(quadrature, along, modes, xp)
    left_out = left_out + _next_order(quadrature, along, (shift, slope), variation, xp)
    left_out = left_out + QUADRATURE_SAFETY * quadrature.error_estimate(speed, xp)
    # The rounding errors of sums of many terms, and of the solution of the collocation equations.
    error = SAFETY * left_out + ROUNDING * (10.0 + space.size) * length
    # A system that could not be solved has a correction that is not finite, and an error too.
    known = xp.isfinite(error)
    # On the geodesic, beside the path, K times the square of the length differs by this.
    uncertainty = variation * xp.max(xp.abs(shift), axis=0) * length * length / np.pi**2
    index = _index(quadrature, along, pivots, uncertainty, xp)
    correction = xp.sum(by_mode, axis=0)
    residual = xp.max(xp.abs(kappa), axis=0) * length
    return Length(
        raw=length,
        correction=correction,
        error=xp.where(known, error, xp.inf),
        residual=residual,
        index=xp.where(known, index, UNKNOWN),
        trusted=is_leading_order(correction, residual, length),
    )


def _index(
    quadrature: Quadrature, along: PathGeometry, pivots: Any, uncertainty: Any, xp: Any
) -> Any:
    """The number of negative eigenvalues of the second variation.

    That is the number of conjugate points on the path (Morse's index theorem: M. do Carmo,
    *Riemannian Geometry*, chapter 11), and Galerkin's method never counts too many. The index is
    `UNKNOWN` where an eigenvalue is so small that its sign is uncertain. All others are about the
    mean of 1 / speed, so that the determinant shows how small it is.
    """
    speed, _, curvature = along
    weights = constant(quadrature.weights, speed, xp)
    length, size = weights @ speed, weights @ (1.0 / speed)
    negative = xp.sum(xp.where(pivots < 0.0, 1, 0), axis=0)
    clear = xp.abs(xp.prod(pivots / size, axis=0)) > uncertainty + EIGENVALUE_ROUNDING
    positive = weights @ (xp.where(curvature > 0.0, curvature, 0.0) * speed)
    # Lyapunov's inequality proves that there is none without Galerkin's method.
    return xp.where(positive * length < LYAPUNOV_BOUND, 0, xp.where(clear, negative, UNKNOWN))


def _curvature_variation(quadrature: Quadrature, along: PathGeometry, xp: Any) -> Any:
    """An estimate of the size of the derivative of K across the path."""
    speed, _, curvature = along
    steps = constant(np.diff(quadrature.points)[:, None], speed, xp)
    change = xp.abs(curvature[1:, :] - curvature[:-1, :]) / steps
    slower = xp.where(speed[1:, :] < speed[:-1, :], speed[1:, :], speed[:-1, :])
    length = constant(quadrature.weights, speed, xp) @ speed
    most = CURVATURE_VARIATION * xp.max(xp.abs(curvature), axis=0) / length
    return xp.max(change / slower, axis=0) + most


def _beyond(quadrature: Quadrature, along: PathGeometry, modes: "Modes", xp: Any) -> Any:
    """The part of the correction that belongs to all modes that are left out.

    K hardly matters to modes that vary so quickly. Without it, psi' is the integral of the
    curvature along the path, less its mean, and the part of that outside the span of the modes'
    slopes is known.
    """
    speed, kappa, _ = along
    weights = constant(quadrature.weights, speed, xp)
    turn = constant(quadrature.antiderivative, speed, xp) @ (kappa * speed)
    turn = (turn - weights @ (turn * speed) / (weights @ speed)) * speed
    slopes = constant(modes.slopes, speed, xp)
    rest = turn - slopes @ (xp.matrix_transpose(slopes) @ (weights[:, None] * turn))
    return 0.5 * (weights @ (rest * rest / speed))


def _next_order(
    quadrature: Quadrature, along: PathGeometry, field: tuple[Any, Any], variation: Any, xp: Any
) -> Any:
    """The terms of the expansion that the correction leaves out."""
    speed, kappa, curvature = along
    shift, slope = field
    weights = constant(quadrature.weights, speed, xp)
    slope_square, shift_square = slope * slope, shift * shift
    cubic = (weights @ (xp.abs(shift) * shift_square * speed)) * variation / 6.0
    quartic = xp.abs(kappa * shift) * slope_square / 2.0 + slope_square * slope_square / 8.0
    bent = curvature * shift_square
    return cubic + weights @ ((quartic + bent * bent) * speed)


@dataclass(frozen=True)
class Modes:
    """Functions on [0, 1] that vanish at its ends, at the points of a quadrature.

    Integrated Legendre polynomials, scaled so that their slopes are orthonormal: the Jacobi
    system is then nearly the identity divided by the length.

    Parameters
    ----------
    values, slopes : ndarray, shape (points, count)
    """

    values: Array
    slopes: Array

    @property
    def count(self) -> int:
        """The number of modes."""
        return int(self.values.shape[1])

    @cached_property
    def products(self) -> Array:
        """The map from the densities to the lower triangle of the Jacobi system, column by column.

        Shape (count * (count + 1) / 2, 2 * points).
        """
        columns, rows = np.triu_indices(self.count)
        stiffness = self.slopes[:, rows] * self.slopes[:, columns]
        mass = self.values[:, rows] * self.values[:, columns]
        return np.ascontiguousarray(np.concatenate([stiffness, -mass]).T)

    def system(self, densities: Any, xp: Any) -> Any:
        """Return the lower triangle of the Jacobi system, column by column.

        Parameters
        ----------
        densities : array, shape (2 * points, problems)
            The densities of stiffness, then those of mass.
        """
        if self.count > MOST_IN_ONE_PRODUCT:
            factors = np.concatenate([self.slopes, self.values])
            signed = np.concatenate([self.slopes, -self.values])
            weighted = xp.permute_dims(densities, (1, 0))[:, None, :] * constant(
                signed.T, densities, xp
            )
            whole = weighted @ constant(factors, densities, xp)
            columns = (xp.permute_dims(whole[:, j:, j], (1, 0)) for j in range(self.count))
            return xp.concat(list(columns))
        return constant(self.products, densities, xp) @ densities


@lru_cache(maxsize=32)
def _modes_on(points: tuple[float, ...], count: int) -> Modes:
    x = 2.0 * np.array(points) - 1.0
    basis = legendre.legvander(x, count + 1)
    k = np.arange(1, count + 1)
    values = (basis[:, 2:] - basis[:, :-2]) / (2.0 * np.sqrt(2.0 * k + 1.0))
    slopes = np.sqrt(2.0 * k + 1.0) * basis[:, 1:-1]
    return Modes(values, slopes)


def modes_on(quadrature: Quadrature, size: int) -> Modes:
    """Return twice as many modes as the path has, which is as far as the quadrature reaches."""
    return _modes_on(tuple(quadrature.points), min(2 * size, len(quadrature.points) - 3))
