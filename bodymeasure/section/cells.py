"""Parameter rectangles in which a section is the graph of a function."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.bezier import elevate, split

# The part of a rectangle at which it is cut. Cuts in the middle would put corners of rectangles on
# the section of symmetric patches, or at round heights, again and again.
CUT = 0.4877
# The largest slope of a graph, in the rectangle's own coordinates. It is above 1, so that each
# direction passes one of the two tests, and not much above, so that quadrature is easy.
STEEPEST = 4.0
# The number of halvings after which a rectangle without a direction is undecided: its second-order
# terms are 1e-12 of the patch.
DEEPEST = 20
# The sign of derivatives below this part of the size is rounding.
ROUNDING = 1e-15
# A section of n patches takes some 3 n rectangles; where it takes so many, the plane grazes the
# surface.
MOST = 200_000


class Cells(NamedTuple):
    """Rectangles, with the distance from the plane in each.

    Parameters
    ----------
    patch : ndarray of int, shape (k,)
        Row of the coefficients.
    lower, upper : ndarray, shape (k, 2)
        Corners (u, v).
    corners : ndarray, shape (k, 2, 2)
        Distances from the plane at the corners.
    axis : ndarray of int, shape (k,)
        0 if the section is a graph v(u), 1 if it is a graph u(v).
    """

    patch: Ints
    lower: Array
    upper: Array
    corners: Array
    axis: Ints


def graph_cells(distance: Array, size: float) -> tuple[Cells, Cells]:
    """Cut patches until the section is a graph over one parameter in each rectangle.

    Parameters
    ----------
    distance : ndarray, shape (patches, degree + 1, degree + 1)
        Bernstein coefficients of the distance from the plane.
    size : float
        Size of the atlas, in the unit of the distances.

    Returns
    -------
    cells : Cells
        All rectangles that the section may cross.
    undecided : Cells
        Tiny ones without a direction, at which the plane touches the surface; `axis` is -1.

    Notes
    -----
    Coefficients of one sign prove by their convex hull that the section misses a rectangle, and
    those of ``f_v -+ f_u / STEEPEST`` that it is a graph v(u) there: no loop lies unseen inside,
    and what crosses the sides says how they are joined. As in J. Snyder, *Interval analysis for
    computer graphics*, SIGGRAPH 1992, with Bernstein coefficients in place of intervals.
    """
    patch = np.arange(len(distance))
    lower, upper = np.zeros((len(distance), 2)), np.ones((len(distance), 2))
    found: list[Cells] = []
    for depth in range(DEEPEST + 1):
        crossed = (distance.min(axis=(1, 2)) <= 0.0) & (distance.max(axis=(1, 2)) >= 0.0)
        distance, patch, lower, upper = (x[crossed] for x in (distance, patch, lower, upper))
        axis = _graph_axis(distance, ROUNDING * size)
        cells = Cells(patch, lower, upper, distance[:, [0, -1]][:, :, [0, -1]], axis)
        done = axis >= 0
        found.append(_taken(cells, done))
        rest = ~done
        if depth == DEEPEST or not rest.any() or rest.sum() > MOST:
            break
        distance, patch, lower, upper = _quarters(
            distance[rest], patch[rest], lower[rest], upper[rest]
        )
    return _joined(found), _taken(cells, rest)


def _joined(found: list[Cells]) -> Cells:
    patch, lower, upper, corners, axis = zip(*found, strict=True)
    return Cells(
        np.concatenate(patch),
        np.concatenate(lower),
        np.concatenate(upper),
        np.concatenate(corners),
        np.concatenate(axis),
    )


def _taken(cells: Cells, mask: Bools) -> Cells:
    return Cells(
        cells.patch[mask],
        cells.lower[mask],
        cells.upper[mask],
        cells.corners[mask],
        cells.axis[mask],
    )


def _graph_axis(distance: Array, least: float) -> Ints:
    """Return 0 or 1 where the section is surely a graph over u or v, else -1, shape (k,)."""
    degree = distance.shape[1] - 1
    along_u, along_v = (
        elevate(degree * np.diff(distance, axis=axis)[..., None], degree, degree)[..., 0]
        for axis in (1, 2)
    )
    over_u = _dominates(along_v, along_u / STEEPEST, least)
    over_v = _dominates(along_u, along_v / STEEPEST, least)
    # Where both hold, the flatter graph is taken.
    flatter_u = np.abs(along_v).min(axis=(1, 2)) >= np.abs(along_u).min(axis=(1, 2))
    axis = np.where(over_u & (flatter_u | ~over_v), 0, 1)
    return np.where(over_u | over_v, axis, -1)


def _dominates(large: Array, small: Array, least: float) -> Bools:
    """Return whether |large| > |small|, with one sign of large, by Bernstein coefficients."""
    both = np.stack([large - small, large + small], axis=1)
    low, high = both.min(axis=(1, 2, 3)), both.max(axis=(1, 2, 3))
    return np.asarray((low > least) | (high < -least))


def _quarters(
    distance: Array,
    patch: Ints,
    lower: Array,
    upper: Array,
) -> tuple[Array, Ints, Array, Array]:
    parts = split(distance[..., None], CUT, CUT)[..., 0]
    middle = lower + CUT * (upper - lower)
    bounds = np.stack([lower, middle, upper], axis=1)
    corner = np.array([[0, 0], [0, 1], [1, 0], [1, 1]])
    axes = np.arange(2)
    return (
        parts.reshape(-1, *distance.shape[1:]),
        np.repeat(patch, 4),
        bounds[:, corner, axes].reshape(-1, 2),
        bounds[:, corner + 1, axes].reshape(-1, 2),
    )
