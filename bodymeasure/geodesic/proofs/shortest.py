r"""The proof that a geodesic is the only shortest path on its patch.

Let D be a patch, taken as a disc of its own whose metric is that of the surface: where
``S_u x S_v`` is never 0, nothing else is asked of it, and it may cross itself in space. Let k > 0
be an upper bound of its Gaussian curvature K. If :math:`\int_D \max(K, 0) < 2 \pi`, then D with its
inner distances is a CAT(k) space, and in such a space a geodesic shorter than
:math:`\pi / \sqrt k` is the only shortest path between its ends. Geodesics here are those of the
patch with its edges, which may run along an edge that bends inwards.

The bound of the integral cannot be left out: on a sphere without a small cap, halves of the rim are
geodesics as short as one likes, two between any two opposite points of it. The argument in full,
with its sources, is in the documentation under "proofs".
"""

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.proofs.curvature import CurvatureBounds, curvature_bounds
from bodymeasure.geodesic.surfaces.control_points import of_size_one

# The part of pi^2 and 2 pi that is used, so that no rounding in the comparison itself matters.
SAFE = 1.0 - 1e-12
# Bounds of a length are close where the curvature's bound is below this part of the largest one.
NEAR = 0.8


def bounds_for_paths(control_points: Array, surface_of: Ints, lengths: Array) -> CurvatureBounds:
    """Return bounds of the curvature around paths, as close as their lengths ask for.

    Parameters
    ----------
    control_points : ndarray, shape (patches, m + 1, n + 1, 3)
        Polynomial patches.
    surface_of : ndarray of int, shape (paths,)
        The patch of each path.
    lengths : ndarray, shape (paths,)
        Upper bounds of the paths' lengths; NaN where there is no path.

    Returns
    -------
    CurvatureBounds
        Of shape (paths,), infinite where there is no path.
    """
    result = CurvatureBounds(*np.full((3, len(lengths)), np.inf))
    asked = np.flatnonzero(np.isfinite(lengths))
    if not len(asked):
        return result
    patches, rows = np.unique(surface_of[asked], return_inverse=True)
    nets, sizes = of_size_one(control_points[patches])
    largest = _largest(lengths[asked] / sizes[rows])
    endless = np.full(len(nets), np.inf)
    found = curvature_bounds(nets, endless, endless, most_halvings=0).take(rows)
    far = ~proves(found, largest) | (found.curvature > NEAR * largest)
    left = np.flatnonzero(far & (largest > 0.0))
    if len(left):
        # Where the whole curvature is too large as well, smaller bounds are asked for.
        wanted = np.minimum(NEAR * largest[left], 2.0 * np.pi * SAFE / found.area[left])
        found.put(left, curvature_bounds(nets[rows[left]], wanted, largest[left]))
    result.put(asked, found.scaled(sizes[rows]))
    return result


def are_shortest(bounds: CurvatureBounds, lengths: Array) -> Bools:
    """Return which geodesics are proven to be the only shortest paths on their patches.

    Parameters
    ----------
    bounds : CurvatureBounds
        Those of `bounds_for_paths`.
    lengths : ndarray, shape (paths,)
        Upper bounds of the geodesics' lengths; NaN where there is no geodesic, and then nothing is
        proven.

    Returns
    -------
    ndarray of bool, shape (paths,)
        False means that it is not proven.
    """
    return proves(bounds, _largest(lengths)) & np.isfinite(lengths)


def _largest(lengths: Array) -> Array:
    """The curvature up to which a path of some length is the only shortest one."""
    # A path of length 0 is the shortest on any patch.
    with np.errstate(divide="ignore", over="ignore"):
        return np.asarray((np.pi / lengths) ** 2 * SAFE)


def proves(bounds: CurvatureBounds, largest: Array) -> Bools:
    """Return whether bounds prove geodesics, where k must be at most the largest, (pi / L)^2."""
    return (bounds.curvature <= largest) & has_little_curvature(bounds)


def has_little_curvature(bounds: CurvatureBounds) -> Bools:
    """Return which patches have so little whole curvature that they are CAT(k) spaces."""
    return np.asarray(bounds.positive < 2.0 * np.pi * SAFE)
