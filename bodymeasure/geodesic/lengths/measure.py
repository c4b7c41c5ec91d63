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

- the last Galerkin modes of :math:`\psi`, for those that were left out. On few functions two modes
  tell too little, and the curvature of piecewise polynomials has kinks, so that what modes take off
  hardly falls from one to the next: there, all that they leave out of
  :math:`\tfrac12 \int (\int \kappa_g)^2`, which is the excess without K, is counted too;
- the next term of the expansion, :math:`\tfrac16 \int |\partial_n K| |\psi|^3`, with the
  derivative across the path taken to be of the size of that along it, and of 4 K / L;
- the terms after it, :math:`\int |\kappa_g \psi| \psi'^2 / 2 + \psi'^4 / 8 + K^2 \psi^4`;
- three times the error that the quadrature estimates of itself;

all times five, plus rounding. The factors were fixed by measurement
(``tests/benchmarks/patches/error_estimate.py`` and ``adversarial.py``): on random and body patches
the estimate covers the true error of the corrected length on more than 99.9 % of paths; with a
factor of three some adversarial ones were off by 1.6 times the estimate. It is about a hundred
times too large in the median where errors are above rounding, and some 1e-5 of what is corrected.
It is leading order: callers trust it only where the correction is a small part of the length
(`TRUSTED_CORRECTION`) and the path turns but little between its nodes (`TRUSTED_RESIDUAL`).
"""

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace

import array_api_compat.numpy
import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.geodesic.lengths.jacobi import UNKNOWN, judge
from bodymeasure.geodesic.lengths.path_geometry import path_geometry
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.bezier import Surface

# The expansion is leading order: past this part of the length the correction is not to be trusted.
TRUSTED_CORRECTION = 1e-4
# Nor of a path that somewhere turns, within the surface, by more than this angle on a way as long
# as itself. Of 7000 paths with good lengths on bodies and on mild and wild patches, one in a
# thousand does, and is found with more functions; on folded patches and near cusps some do whose
# formulas all agree on a wrong length.
TRUSTED_RESIDUAL = 1.0
# On a surface of size 1, derivatives by u and v are at most 6 in size, and more than that times the
# rounding errors that `jacobi.ROUNDING` allows are made by a path that is not this part as long as
# its way in u and v.
STEEP = 0.2
# Rounding errors of a derivative, relative to the terms that it is the sum of.
CANCELLATION = 4e-16


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
    index : ndarray of int
        Of the geodesic that the path stands for (`jacobi.judge`): 0 for a strict local minimum,
        `jacobi.UNKNOWN` where that cannot be told.
    """

    raw: Array
    correction: Array
    error: Array
    residual: Array
    index: NDArray[np.int64]

    @property
    def minimal(self) -> NDArray[np.bool_]:
        """Which paths are proven to be shorter than all close to them."""
        result: NDArray[np.bool_] = self.index == 0
        return result

    @property
    def corrected(self) -> Array:
        """The length of the geodesic: of the path, less its excess."""
        return self.raw - self.correction

    def take(self, rows: NDArray[np.int64]) -> "MeasuredLength":
        """The lengths of some of the problems."""
        return MeasuredLength(*(getattr(self, field.name)[rows] for field in fields(self)))

    def scaled(self, powers: NDArray[np.int64]) -> "MeasuredLength":
        """The same on surfaces that are larger by powers of two."""
        return replace(
            self,
            raw=np.ldexp(self.raw, powers),
            correction=np.ldexp(self.correction, powers),
            error=np.ldexp(self.error, powers),
        )

    @classmethod
    def of_parts(cls, parts: "Sequence[MeasuredLength]") -> "MeasuredLength":
        """Of paths that are made of parts, the joints of which stay in place.

        The index is then the sum of the parts' indices.
        """
        indices = [part.index for part in parts]
        known = np.all([index != UNKNOWN for index in indices], axis=0)
        return cls(
            raw=np.sum([part.raw for part in parts], axis=0),
            correction=np.sum([part.correction for part in parts], axis=0),
            error=np.sum([part.error for part in parts], axis=0),
            residual=np.max([part.residual for part in parts], axis=0),
            index=np.where(known, np.sum(indices, axis=0), UNKNOWN),
        )


def measure_length(surface: Surface, space: TrialSpace, values: Array) -> MeasuredLength:
    """Length, leading-order correction and error estimate of paths.

    Parameters
    ----------
    surface : Surface
    space : TrialSpace
    values : ndarray, shape (problems, 2, n + 1)
        u and v at the nodes.
    """
    place, *slopes = space.at_quadrature
    # As in `equations`: rounding of the sums that differentiate must not grow with the place.
    moved = values - values[:, :, :1]
    geometry = path_geometry(surface, values @ place.T, *(moved @ rows.T for rows in slopes))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        measured = MeasuredLength(*judge(space, geometry, array_api_compat.numpy))
    steep = np.flatnonzero(is_steep(measured.raw, values))
    if len(steep):
        measured.error[steep] += _cancellation(surface.take(steep), space, values[steep])
    return measured


def is_steep(length: Array, values: Array) -> NDArray[np.bool_]:
    """Which paths are so short, for their way in u and v, that rounding errors count.

    Parameters
    ----------
    length : ndarray, shape (problems,)
    values : ndarray, shape (problems, 2, n + 1)
    """
    way = np.abs(values[:, :, 1:] - values[:, :, :-1]).sum(axis=(1, 2))
    result: NDArray[np.bool_] = length < STEEP * way
    return result


def _cancellation(surface: Surface, space: TrialSpace, values: Array) -> Array:
    """Rounding errors of lengths that are small beside what they are calculated from."""
    place, slopes, _ = space.at_quadrature
    velocity = np.abs((values - values[:, :, :1]) @ slopes.T)
    magnitude = surface.magnitude((values @ place.T).transpose(0, 2, 1))
    terms = magnitude[0] * velocity[:, 0] + magnitude[1] * velocity[:, 1]
    result: Array = CANCELLATION * (terms @ space.quadrature.weights)
    return result


def is_good(measured: MeasuredLength, tolerance: float) -> NDArray[np.bool_]:
    """Whether lengths are known to a relative tolerance, and their corrections to be trusted."""
    known = measured.error <= tolerance * measured.raw
    trusted = np.abs(measured.correction) <= TRUSTED_CORRECTION * measured.raw
    result: NDArray[np.bool_] = known & trusted & (measured.residual <= TRUSTED_RESIDUAL)
    return result
