r"""Bounds of the length of the shortest path on a patch, on both sides.

From above it is bounded by the length l of any path on the patch, such as the computed one. From
below it is bounded by the distance in space, and, where the patch is a CAT(k) space (see
`shortest`), by a theorem of Alexander and Bishop: the ends of a path with geodesic curvature of at
most c are at least as far apart as those of an arc of constant curvature c and of the same length
in the plane of curvature k, as long as :math:`l \sqrt{k + c^2} < \pi`. That distance is

.. math:: d = \frac{2}{\sqrt k} \arcsin \frac{a \sin b}{b},
    \qquad a = \tfrac12 l \sqrt k, \quad b = \tfrac12 l \sqrt{k + c^2}.

Nothing is asked of the computed path but that it runs on the patch. To leading order
:math:`l - d = c^2 k^{-3/2} (\tan a - a)`, which is of second order in the residual.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.lengths.path_geometry import path_geometry
from bodymeasure.geodesic.spaces.quadrature import Quadrature
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

# A path is sampled at so many points more than its trial space's own quadrature has, on each piece.
MORE_POINTS = 8
# The curvature between two samples is taken to be at most this factor above the largest of them.
# Of 1300 resolved paths on wild patches, none exceeds it by more than 1.16.
BETWEEN = 1.2
# Where two sums of a length differ by more than this, relatively, the points are too far apart for
# the path, and its curvature may peak between them, as it did on these patches up to 200 times.
RESOLVED = 1e-7
# The rounding errors of a sum that gives a length, relative to it.
ROUNDING = 2.5e-16
# Two such sums of the same length differ by this part of it.
NOISE = 5e-16
# Two points of a patch of size 1 are as far apart as computed, up to this.
PLACES = 2e-15
# Rounding puts a path along an edge so far outside of [0, 1] in u or v.
ON_EDGE = 1e-14
# Where ends are closer in u and in v, rounded values may make a path turn back between samples.
SHORTEST_WAY = 1e-12
# Where the curvature of the surface is 0 or less, any positive bound serves the formula.
FLATTEST = 1e-6
# Terms of the series of sin(x) / x that are needed up to x = pi / 2.
TERMS = 16


class Bounds(NamedTuple):
    """Bounds of lengths; arrays of the shape of the batch, or floats for a single problem.

    Parameters
    ----------
    lower, upper : ndarray or float
        In the unit of the control points; NaN where there is no path on the patch.
    """

    lower: Array
    upper: Array


class SampledPaths(NamedTuple):
    """What is known of paths from many points on them; arrays of shape (paths,).

    Parameters
    ----------
    length : ndarray
        By a finer quadrature than that of the trial space; infinite for paths that leave the patch.
    curvature : ndarray
        The largest geodesic curvature at the samples, with what may lie between them; NaN where
        that is not known.
    """

    length: Array
    curvature: Array


@lru_cache(maxsize=64)
def _samples(space: TrialSpace) -> tuple[Quadrature, tuple[Array, ...]]:
    quadrature = Quadrature(space.functions.edges, space.quadrature.count + MORE_POINTS)
    # The curvature of a path by collocation is the largest at its ends.
    times = np.concatenate([[0.0], quadrature.points, [1.0]])
    return quadrature, tuple(space.matrices(times))


def sample_paths(surface: Surface, space: TrialSpace, values: Array) -> SampledPaths:
    """Return the lengths of paths and their largest curvatures, from samples.

    Parameters
    ----------
    surface : Surface
    space : TrialSpace
    values : ndarray, shape (paths, 2, n + 1)
    """
    quadrature, (place, *slopes) = _samples(space)
    moved = values - values[:, :, :1]
    places = values @ place.T
    geometry = path_geometry(surface, places, *(moved @ rows.T for rows in slopes))
    length = quadrature.weights @ geometry.speed[1:-1]
    curvature = BETWEEN * np.abs(geometry.geodesic_curvature).max(axis=0)
    unknown = np.abs(moved[:, :, -1]).max(axis=1) < SHORTEST_WAY
    # Off the patch, a path bounds nothing.
    outside = (places.min(axis=(1, 2)) < -ON_EDGE) | (places.max(axis=(1, 2)) > 1.0 + ON_EDGE)
    curvature = np.where(outside | unknown, np.nan, curvature)
    return SampledPaths(np.where(outside, np.inf, length), curvature)


def shortfall(length: Array, curvature: Array, surface_curvature: Array) -> Array:
    """Return by how much the distance of a path's ends may be less than the path's length.

    Parameters
    ----------
    length, curvature : ndarray
        Upper bounds of the path's length and of its geodesic curvature.
    surface_curvature : ndarray
        An upper bound of the Gaussian curvature of the surface, at least 0.

    Returns
    -------
    ndarray
        NaN where the theorem says nothing.
    """
    with np.errstate(invalid="ignore", over="ignore", divide="ignore"):
        k = np.maximum(surface_curvature, (FLATTEST / length) * (FLATTEST / length))
        a = length * np.sqrt(k) / 2.0
        excess = (length * curvature / 2.0) ** 2
        b = np.sqrt(a**2 + excess)
        # Without cancellation: the difference of sin(x) / x at a and b, as a series.
        lost = a * excess * _fall(a**2, b**2)
        sine = np.sin(a) - lost
        cosine = np.sqrt(1.0 - sine**2)
        gained = lost * (np.sin(a) + sine) / (cosine + np.cos(a))
        angle = np.arcsin(np.sin(a) * gained + np.cos(a) * lost)
        return np.where(b < np.pi / 2.0, 2.0 * angle / np.sqrt(k), np.nan)


def _fall(x: Array, y: Array) -> Array:
    """The slope of the chord of ``-sin(sqrt(x)) / sqrt(x)`` between x and y, both at most 3."""
    result, factor = np.zeros_like(x), 1.0
    power, quotient = np.ones_like(x), np.ones_like(x)
    for n in range(1, TERMS):
        factor *= -1.0 / (2 * n * (2 * n + 1))
        result = result - factor * quotient
        power = power * x
        # (y^(n+1) - x^(n+1)) / (y - x) from that of n.
        quotient = quotient * y + power
    return result


def bounds_of(
    raw: Array, sampled: SampledPaths, surface_curvature: Array, distance: Array
) -> Bounds:
    """Return the bounds of the shortest paths.

    Parameters
    ----------
    raw : ndarray, shape (paths,)
        The lengths of the computed paths.
    sampled : SampledPaths
    surface_curvature : ndarray, shape (paths,)
        NaN where the patch is not known to be a CAT(k) space for that bound.
    distance : ndarray, shape (paths,)
        The distances of the ends in space, on patches of about size 1.
    """
    # Two sums of a length differ by rounding, and beyond that by what the coarser rule lacks.
    doubt = 2.0 * np.maximum(np.abs(raw - sampled.length) - NOISE * raw, 0.0)
    upper = (raw + doubt) * (1.0 + ROUNDING)
    curvature = np.where(doubt <= 2.0 * RESOLVED * raw, sampled.curvature, np.nan)
    short = shortfall(upper, curvature, surface_curvature)
    apart = np.maximum(distance * (1.0 - ROUNDING) - PLACES, 0.0)
    lower = np.fmax((raw - doubt) * (1.0 - ROUNDING) - short, apart)
    return Bounds(np.minimum(lower, upper), upper)
