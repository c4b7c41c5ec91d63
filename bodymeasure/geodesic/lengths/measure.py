r"""The length of a computed path, its excess over the geodesic's, and the error of both.

A path :math:`\gamma` that is not quite a geodesic has a geodesic curvature :math:`\kappa_g`. Let
:math:`\psi` be the distance to its side at which the geodesic between the same ends lies. In
coordinates of arc length s along the path and distance n from it, the metric is
:math:`ds^2 (1 - 2 \kappa_g n + (\kappa_g^2 - K) n^2 + \dots) + dn^2`, so the length of the path
shifted by :math:`\psi` is

.. math:: L(\psi) = L - \int \kappa_g \psi + \tfrac12 \int (\psi'^2 - K \psi^2) + \dots

(K is the Gaussian curvature). It is stationary where :math:`-\psi'' - K \psi = \kappa_g`, the
Jacobi equation with zero ends, and there :math:`L - L(\psi) = \tfrac12 \int \kappa_g \psi` to
leading order. That excess is subtracted. The remaining error is estimated by

- the last Galerkin modes of :math:`\psi`, for those that were left out. On few functions two modes
  say too little, and the curvature of piecewise polynomials has kinks, so that the contributions of
  the modes hardly fall from one to the next: there, all that they leave out of
  :math:`\tfrac12 \int (\int \kappa_g)^2`, which is the excess without K, is counted too;
- the next term of the expansion, :math:`\tfrac16 \int |\partial_n K| |\psi|^3`, with the
  derivative across the path taken to be of the size of that along it, and of 4 K / L;
- the terms after it, :math:`\int |\kappa_g \psi| \psi'^2 / 2 + \psi'^4 / 8 + K^2 \psi^4`;
- three times the quadrature's estimate of its own error;

all times five, plus rounding. The factors were fixed by measurement
(``tests/benchmarks/patches/error_estimate.py`` and ``adversarial.py``): on random and body patches
the estimate covers the true error of the corrected length on more than 99.9 % of paths; with a
factor of three some adversarial ones were off by 1.6 times the estimate. It is about a hundred
times too large in the median where errors are above rounding, and some 1e-5 of what is corrected.
It is of leading order: callers trust it only where the correction is a small part of the length
(`length.TRUSTED_CORRECTION`) and the path turns little between its nodes
(`length.TRUSTED_RESIDUAL`).
"""

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.lengths.compiled import CANCELLATION, STEEP, compiled_lengths
from bodymeasure.geodesic.lengths.jacobi import length_and_error
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.lengths.path_geometry import path_geometry
from bodymeasure.geodesic.numerics.array_libraries import namespace
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface


def measure_length(surface: Surface, space: TrialSpace, values: Array) -> Length:
    """Return the lengths of paths, with their leading-order corrections and error estimates.

    Parameters
    ----------
    surface : Surface
    space : TrialSpace
    values : ndarray, shape (problems, 2, n + 1)
        u and v at the nodes.
    """
    return compiled_lengths(surface, space, values) or _measured(surface, space, values)


def _measured(surface: Surface, space: TrialSpace, values: Array) -> Length:
    place, *slopes = space.at_quadrature
    # Differences from the start, so that rounding errors of derivatives do not grow with (u, v).
    moved = values - values[:, :, :1]
    geometry = path_geometry(surface, values @ place.T, *(moved @ rows.T for rows in slopes))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        length = length_and_error(space, geometry, namespace(geometry.speed))
    steep = np.flatnonzero(is_steep(length.raw, values))
    if len(steep):
        length.error[steep] += _cancellation(surface.take(steep), space, values[steep])
    return length


def is_steep(length: Array, values: Array) -> Bools:
    """Return which paths are so short, for their way in u and v, that rounding errors count.

    Parameters
    ----------
    length : ndarray, shape (problems,)
    values : ndarray, shape (problems, 2, n + 1)
    """
    way = np.abs(values[:, :, 1:] - values[:, :, :-1]).sum(axis=(1, 2))
    result: Bools = length < STEEP * way
    return result


def _cancellation(surface: Surface, space: TrialSpace, values: Array) -> Array:
    """The rounding errors of lengths that are small beside what they are calculated from."""
    place, slopes, _ = space.at_quadrature
    velocity = np.abs((values - values[:, :, :1]) @ slopes.T)
    magnitude = surface.magnitude((values @ place.T).transpose(0, 2, 1))
    terms = magnitude[0] * velocity[:, 0] + magnitude[1] * velocity[:, 1]
    result: Array = CANCELLATION * (terms @ space.quadrature.weights)
    return result
