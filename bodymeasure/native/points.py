"""Roots of polynomials, points of patches and hulls of points, compiled."""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.native.library import address, doubles, kernels

# The highest degree of a patch in one parameter, and the most columns of its nets, for which the
# kernels have room.
MOST_DEGREE, MOST_COLUMNS = 32, 40


def roots_in_brackets(coefficients: Array, lower: Array, upper: Array) -> Array:
    """Return the root of each polynomial; see `section.roots.bracketed_roots`."""
    coefficients, lower, upper = doubles(coefficients, lower, upper)
    count, size = coefficients.shape
    found = np.empty(count)
    kernels().bodymeasure_roots(count, size - 1, *map(address, (coefficients, lower, upper, found)))
    return found


def power_jets(coefficients: Array, x: Array) -> Array:
    """Return derivatives up to the second; see `bezier.power_form.jets`, but for weights.

    Returns
    -------
    ndarray, shape (k, 3, 3, coordinates)
    """
    coefficients, x = doubles(coefficients, x)
    count, side, _, coordinates = coefficients.shape
    jets = np.empty((count, 3, 3, coordinates))
    kernels().bodymeasure_power_jets(
        count, side, coordinates, *map(address, (coefficients, x, jets))
    )
    return jets


def bezier_jets(nets: Array, degrees: tuple[int, int], columns: int, parameters: Array) -> Array:
    """Return the first columns of patches' nets at points.

    Parameters
    ----------
    nets : ndarray, shape (problems, (m + 1) * (n + 1), width)
    degrees : tuple of int
        m and n.
    columns : int
        At most `MOST_COLUMNS`.
    parameters : ndarray, shape (problems, k, 2)

    Returns
    -------
    ndarray, shape (columns, problems, k)
    """
    nets, parameters = doubles(nets, parameters)
    problems, points = parameters.shape[:2]
    jets = np.empty((columns, problems, points))
    kernels().bodymeasure_jets(
        problems,
        *degrees,
        nets.shape[2],
        columns,
        address(nets),
        points,
        *map(address, (parameters, jets)),
    )
    return jets


def extents(points: Array, scaled: Array | None = None) -> Array:
    """Return the greatest extents and the largest coordinates of patches (count, k, 3).

    If there is an array for scaled patches, they are put there, and a third row of the result has
    the powers of 2 by which they were divided.
    """
    (points,) = doubles(points)
    count, size = points.shape[:2]
    found = np.empty((2 if scaled is None else 3, count))
    place = None if scaled is None else address(scaled)
    kernels().bodymeasure_extents(count, size, address(points), place, address(found))
    return found


def planar_hull(points: Array) -> Ints:
    """Return the corners of the convex hull of points (k, 2), counterclockwise."""
    (points,) = doubles(points)
    corners = np.empty(len(points) + 1, np.int64)
    count = kernels().bodymeasure_planar_hull(len(points), *map(address, (points, corners)))
    return corners[:count]
