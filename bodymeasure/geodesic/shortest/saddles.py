"""Polygons at rest on a saddle of their energy, and the directions that lead down from it."""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.numerics.block_tridiagonal import apply, factorize, solve
from bodymeasure.geodesic.shortest.polygon_energy import PolygonEnergy, polygon_energy
from bodymeasure.geodesic.surfaces.protocol import Surface

# An eigenvalue below minus this part of the lowest one of a flat patch means a saddle. It is more
# than the rounding errors of a path at rest, and so little that paths beyond smaller saddles are
# shorter by a part of about 1e-9 at most.
SADDLE = 1e-5
# The factor between shifts that are tried until one is below all eigenvalues, and their number.
SHIFT_FACTOR = 2.0
MOST_SHIFTS = 24
# The number of steps of inverse iteration; any direction that leads down will do.
INVERSE_ITERATIONS = 10


def descent_directions(surface: Surface, points: Array) -> tuple[Ints, Array]:
    """Return the directions in which polygons at rest can still slide down.

    Parameters
    ----------
    surface : Surface
    points : ndarray, shape (polygons, m + 1, 2)
        Polygons as `descend` returns them.

    Returns
    -------
    saddles : ndarray of int, shape (k,)
        The polygons whose energy has a Hessian with a negative eigenvalue in the coordinates that
        are free to move.
    direction : ndarray, shape (k, m + 1, 2)
        An approximation of each saddle's lowest eigenvector, of size 1 where it is largest.
    """
    energy = polygon_energy(surface, points)
    finite = np.isfinite(energy.energy)
    least = SADDLE * _lowest_of_a_flat_patch(points.shape[1] - 1)
    saddles = np.flatnonzero((factorize(*energy.restricted_hessian(least)).negative > 0) & finite)
    direction = np.zeros((len(saddles), *points.shape[1:]))
    if len(saddles):
        lowest = _lowest_modes(energy.take(saddles))
        direction[:, 1:-1] = lowest.transpose(2, 1, 0)
    return saddles, direction


def _lowest_of_a_flat_patch(edges: int) -> float:
    """The size of the lowest eigenvalue of a flat patch's energy, relative to the metric."""
    return float(0.5 * (np.pi / edges) ** 2)


def _lowest_modes(energy: PolygonEnergy) -> Array:
    """Inverse iteration with a shift that is below all eigenvalues, but not far."""
    _, count, polygons = energy.gradient.shape
    shift = np.full(polygons, _lowest_of_a_flat_patch(count + 1))
    for _ in range(MOST_SHIFTS):
        factors = factorize(*energy.restricted_hessian(shift))
        indefinite = factors.negative > 0
        if not indefinite.any():
            break
        shift[indefinite] *= SHIFT_FACTOR
    along = np.linspace(0.0, 1.0, count + 2)[1:-1, None]
    # It is neither symmetric nor antisymmetric, so that it has a part in the mode that is sought.
    bell = along * (1.0 - along) * (1.0 + along)
    mode = np.where(energy.held, 0.0, np.stack([bell, 0.5 * bell]))
    for _ in range(INVERSE_ITERATIONS):
        mode = solve(factors, np.where(energy.held, 0.0, apply(energy.metric, mode)))
        mode /= np.abs(mode).max(axis=(0, 1))
    return mode
